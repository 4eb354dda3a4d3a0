#include "02_primitives/closest_points/closest_points.hpp"
#include "02_primitives/finder/trial/finder_pairs.hpp"
#include "02_primitives/in_the_plane/in_the_plane.hpp"

#include <utility>

namespace cookbook
{

namespace
{

struct Closest
{
  template <class Real, class A, class B>
  static std::optional<Question<Real>> about()
  {
    if constexpr (requires(const A& a, const B& b) { closest_points(a, b); })
    {
      return ask<Real, A, B>([](const A& a, const B& b) { return closest_points(a, b); });
    }
    else if constexpr (requires(const A& a, const B& b) { closest_points(b, a); })
    {
      return ask<Real, A, B>(
          [](const A& a, const B& b)
          {
            auto found = closest_points(b, a);
            std::swap(found.a, found.b);
            return found;
          });
    }
    return std::nullopt;
  }

private:
  template <class Real, class A, class B, class Find>
  static Question<Real> ask(Find find)
  {
    constexpr int size = decltype(find(A(), B()).a)::RowsAtCompileTime;
    return question_about<Real, A, B>(
        "closest", "distance," + point_columns(size, "a") + "," + point_columns(size, "b"),
        [find](const A& a, const B& b)
        {
          const auto found = find(a, b);
          std::vector<Real> numbers{found.distance};
          append<Real, size>(numbers, found.a);
          append<Real, size>(numbers, found.b);
          return numbers;
        });
  }
};

} // namespace

template <class Real>
std::optional<Question<Real>> closest_question(const std::string& a, const std::string& b)
{
  return question_named<Real, Closest>(a, b);
}

template std::optional<Question<float>>
closest_question<float>(const std::string& a, const std::string& b);
template std::optional<Question<double>>
closest_question<double>(const std::string& a, const std::string& b);

} // namespace cookbook
