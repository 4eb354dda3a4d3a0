/// \file
/// \brief Any two shapes: their closest points, whether they overlap, and where a ray meets one.

#include "01_math/turning/rotation_by.hpp"
#include "02_primitives/casts/casts.hpp"
#include "02_primitives/overlaps/overlaps.hpp"
#include "tools/live/page.hpp"
#include "tools/plot/figures/figure3d.hpp"
#include "tools/program/table.hpp"

#include <string>
#include <variant>

namespace cookbook::live
{

namespace
{

using V = Vector3<double>;
using Shape =
    std::variant<Sphere<double>, Obb<double>, Capsule<double>, Triangle<double>, Segment<double>>;

const std::vector<std::string> kinds = {"sphere", "box", "capsule", "triangle", "segment"};

/// A shape of this kind at a place, turned about z [rad].
Shape shape_at(int kind, const V& center, double turn)
{
  const Matrix3<double> axes = rotation_by<double>({0, 0, turn}).toRotationMatrix();
  const auto at = [&](double x, double y, double z) { return V(center + axes * V(x, y, z)); };
  switch (kind)
  {
  case 0:
    return Sphere<double>{center, 0.8};
  case 1:
    return Obb<double>{center, axes, {0.9, 0.5, 0.6}};
  case 2:
    return Capsule<double>{{at(-0.8, 0, 0), at(0.8, 0, 0)}, 0.4};
  case 3:
    return Triangle<double>{at(-0.9, -0.5, 0.6), at(1, -0.3, 0), at(-0.2, 0.9, -0.6)};
  default:
    return Segment<double>{at(-1, 0, 0), at(1, 0, 0)};
  }
}

/// Draws a shape of any kind.
struct Draw
{
  plot::Figure3d& figure;
  plot::Ink ink;

  void operator()(const Sphere<double>& s) const { figure.sphere(s.center, s.radius, ink); }
  void operator()(const Obb<double>& s) const { figure.box(s.center, s.axes, s.half_extents, ink); }
  void operator()(const Capsule<double>& s) const
  {
    figure.capsule(s.segment.start, s.segment.end, s.radius, ink);
  }
  void operator()(const Triangle<double>& s) const { figure.polygon({s.a, s.b, s.c}, ink); }
  void operator()(const Segment<double>& s) const
  {
    figure.segment(s.start, s.end, ink, plot::Stroke::solid, 4);
  }
};

/// Shows the closest points of two shapes.
void show_closest(Page& page, plot::Figure3d& figure, const Shape& a, const Shape& b)
{
  const ClosestPoints<double, 3> closest = std::visit(
      [](const auto& p, const auto& q) -> ClosestPoints<double, 3> { return closest_points(p, q); },
      a, b);
  const bool meet = std::visit([](const auto& p, const auto& q) { return overlaps(p, q); }, a, b);
  page.text("the shapes", meet ? "overlap or touch" : "are apart");
  page.number("distance", closest.distance, "m");
  figure.segment(closest.a, closest.b, plot::Ink::overlap, plot::Stroke::solid, 2.5)
      .point(closest.a, plot::Ink::a)
      .point(closest.b, plot::Ink::b);
}

/// Shows where a ray meets a shape.
void show_cast(Page& page, plot::Figure3d& figure, const Ray<double>& ray, const Shape& a)
{
  const auto hit = std::visit(
      [&](const auto& shape) -> std::optional<Hit<double, 3>>
      {
        if constexpr (requires { cast(ray, shape); })
        {
          return cast(ray, shape);
        }
        return std::nullopt; // nothing is cast at a segment, which has no size
      },
      a);
  page.text("the ray", hit ? "meets A" : "misses A");
  figure.arrow(ray.origin, ray.origin + ray.direction, plot::Ink::b, "ray");
  if (hit)
  {
    page.number("t", hit->t);
    figure.segment(ray.origin, hit->point, plot::Ink::overlap, plot::Stroke::dashed)
        .point(hit->point, plot::Ink::overlap)
        .arrow(hit->point, hit->point + 0.6 * hit->normal, plot::Ink::ink, "n");
  }
}

} // namespace

void figure(Page& page)
{
  const int question = page.choice("question", {"closest points", "a ray at A"});
  const int kind_a = page.choice("A", kinds, 1);
  const double yaw = page.slider("view from the side", -1.5, 1.5, 0.4, "rad");
  plot::Figure3d figure("finder_live", "", {yaw, 0.3, page.fit(460), 300});
  figure.describe("Two shapes in space and their closest points, or a ray and where it meets one.")
      .frame({{0.5, 0.2, 0}, 6});
  const DragPlane plane = drag_plane(figure, V::Zero(), V::UnitX(), V::UnitY());
  const Shape a = shape_at(kind_a, V(-0.8, 0, 0), 0.3);
  std::visit(Draw{figure, plot::Ink::a}, a);
  const Eigen::Vector2d at = page.handle("B", plane, {1.7, 0.5}, plot::Ink::b);
  if (question == 1)
  {
    const Eigen::Vector2d aim = page.handle("aim", plane, {0.7, 0.4}, plot::Ink::ink);
    const V direction(aim.x() - at.x(), aim.y() - at.y(), 0);
    if (direction.isZero(0))
    {
      page.text("the ray", "has no direction");
    }
    else
    {
      show_cast(page, figure, {V(at.x(), at.y(), 0), direction}, a);
    }
  }
  else
  {
    const int kind_b = page.choice("B is a", kinds, 2);
    const double turn = page.slider("turn of B", -3.14, 3.14, 0.9, "rad");
    const double z = page.slider("z of B", -1.5, 1.5, 0, "m");
    const Shape b = shape_at(kind_b, V(at.x(), at.y(), z), turn);
    std::visit(Draw{figure, plot::Ink::b}, b);
    show_closest(page, figure, a, b);
  }
  page.draw(figure.svg());
}

} // namespace cookbook::live
