#pragma once

/// \file
/// \brief From the names of two shapes to their types, and to a question about them.

#include "02_primitives/finder/trial/finder.hpp"
#include "02_primitives/finder/trial/plane_columns.hpp"

#include <type_traits>

namespace cookbook
{

/// A list of types.
template <class... Shapes>
struct ShapeList
{
};

/// The shapes in space.
template <class Real>
using ShapesInSpace = ShapeList<
    Vector3<Real>, Segment<Real>, Ray<Real>, Plane<Real>, Sphere<Real>, Capsule<Real>, Aabb<Real>,
    Obb<Real>, Triangle<Real>, Tetrahedron<Real>>;

/// The shapes in the plane.
template <class Real>
using ShapesInPlane = ShapeList<
    Vector<Real, 2>, Segment2<Real>, Ray2<Real>, Circle<Real>, Rectangle<Real>,
    OrientedRectangle<Real>>;

/// Calls `use` with the type of each shape.
template <class... Shapes, class Use>
void for_each_shape(ShapeList<Shapes...>, const Use& use)
{
  (use(std::type_identity<Shapes>()), ...);
}

/// Calls `use` with the types of two shapes of the list, known by their names.
template <class List, class Use>
void with_shapes(List list, const std::string& a, const std::string& b, const Use& use)
{
  for_each_shape(
      list,
      [&]<class A>(std::type_identity<A>)
      {
        if (a != ShapeColumns<A>::name)
        {
          return;
        }
        for_each_shape(
            list,
            [&]<class B>(std::type_identity<B> type)
            {
              if (b == ShapeColumns<B>::name)
              {
                use(std::type_identity<A>(), type);
              }
            });
      });
}

/// How many columns there are.
inline std::size_t count_columns(const std::string& columns)
{
  return static_cast<std::size_t>(std::count(columns.begin(), columns.end(), ',')) + 1;
}

/// The columns `x,y` of a shape as `ax,ay`.
inline std::string prefixed(const std::string& columns, char prefix)
{
  std::string text(1, prefix);
  for (const char c : columns)
  {
    text += c;
    if (c == ',')
    {
      text += prefix;
    }
  }
  return text;
}

/// A question about two shapes, which `answer(a, b)` answers with a list of numbers.
template <class Real, class A, class B, class Answer>
Question<Real> question_about(const std::string& ask, const std::string& answers, Answer answer)
{
  const std::string of_a = ShapeColumns<A>::columns, of_b = ShapeColumns<B>::columns;
  const std::size_t first = count_columns(of_a);
  return {
      ask, prefixed(of_a, 'a') + "," + prefixed(of_b, 'b'), answers,
      [first, answer](const PairsRow& row)
      {
        const A a = ShapeColumns<A>::read({row, 0});
        return answer(a, ShapeColumns<B>::read({row, first}));
      }};
}

/// The numbers of a vector, after those that are there.
template <class Real, int Size>
void append(std::vector<Real>& numbers, const Vector<Real, Size>& v)
{
  numbers.insert(numbers.end(), v.data(), v.data() + Size);
}

/// The question by the names of its shapes, found by `Asked::about<Real, A, B>()`.
template <class Real, class Asked>
std::optional<Question<Real>> question_named(const std::string& a, const std::string& b)
{
  std::optional<Question<Real>> found;
  const auto find = [&]<class A, class B>(std::type_identity<A>, std::type_identity<B>)
  { found = Asked::template about<Real, A, B>(); };
  with_shapes(ShapesInSpace<Real>(), a, b, find);
  with_shapes(ShapesInPlane<Real>(), a, b, find);
  return found;
}

/// The columns of a point of as many dimensions, with a prefix: `ax,ay` or `ax,ay,az`.
inline std::string point_columns(int dimensions, const std::string& prefix)
{
  const std::string plane = prefix + "x," + prefix + "y";
  return dimensions == 2 ? plane : plane + "," + prefix + "z";
}

/// Whether two shapes overlap; in a source of its own, as the next two, for it takes long to
/// compile.
template <class Real>
std::optional<Question<Real>> overlap_question(const std::string& a, const std::string& b);

/// Where two shapes are closest.
template <class Real>
std::optional<Question<Real>> closest_question(const std::string& a, const std::string& b);

/// Where the first of two shapes, a ray or a segment, meets the other.
template <class Real>
std::optional<Question<Real>> cast_question(const std::string& a, const std::string& b);

} // namespace cookbook
