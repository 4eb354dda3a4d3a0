#pragma once

/// \file
/// \brief The figures of casts: what a ray meets, half a chord, slabs, and the view along a ray.

#include "02_primitives/casts/casts.hpp"
#include "common/math/rotation.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <cmath>
#include <optional>

namespace cookbook
{

/// A point of the figures' plane, z = 0.
inline Eigen::Vector2d flat(const Vector3<double>& p)
{
  return p.head<2>();
}

/// A fan of rays from one point: what each meets first, of all shapes.
inline plot::Figure2d casts_figure()
{
  using V = Vector3<double>;
  plot::Figure2d figure("casts", "", {{-0.5, -2.3}, {5.4, 2.5}, 420});
  const V eye(0, 0, 0);
  const Sphere<double> ball{{3.2, 1.3, 0}, 0.8};
  const Obb<double> box{{3.6, -1.0, 0}, rational_rotation<double>(4, 0, 0, 1), {0.7, 0.5, 1}};
  const Capsule<double> capsule{{{1.3, 1.7, 0}, {1.9, 2.0, 0}}, 0.25};
  const Plane<double> ground{{0, 1, 0}, -2};
  figure.describe("A fan of rays from one point, each drawn up to what it meets first.")
      .half_plane({0, 1}, -2)
      .circle(flat(ball.center), ball.radius, plot::Ink::a)
      .box(flat(box.center), 2 * std::atan2(1.0, 4.0), {0.7, 0.5}, plot::Ink::b)
      .capsule({1.3, 1.7}, {1.9, 2.0}, 0.25, plot::Ink::a);
  for (const double slope : {1.05, 0.45, 0.12, -0.2, -0.45, -1.1})
  {
    const Ray<double> ray{eye, V(1, slope, 0) / std::sqrt(1 + slope * slope) * 1.5};
    std::optional<Hit<double, 3>> first;
    const auto ask = [&](const auto& shape)
    {
      const auto hit = cast(ray, shape);
      first = hit && (!first || hit->t < first->t) ? hit : first;
    };
    ask(ball), ask(box), ask(capsule), ask(ground);
    if (!first)
    {
      figure.arrow({0, 0}, flat(3.4 * ray.direction), plot::Ink::muted);
      continue;
    }
    figure.segment({0, 0}, flat(first->point))
        .arrow(flat(first->point), flat(first->point + 0.5 * first->normal))
        .point(flat(first->point), plot::Ink::overlap);
  }
  figure.dot({0, 0}, plot::Ink::ink, "o", plot::Side::left);
  return figure;
}

/// A ray and a ball: along, across, and half a chord.
inline plot::Figure2d chord_figure()
{
  plot::Figure2d figure("casts_sphere", "", {{-5.4, -2.4}, {2.6, 3.0}, 420});
  const double half = 1.6; // and 1.2 across: 3-4-5, times 0.4
  figure.describe("A ray passes the centre of a ball at 1.2 m; half the chord is 1.6 m.")
      .circle({0, 0}, 2, plot::Ink::a)
      .segment({-5, 1.2}, {-half, 1.2})
      .segment({-half, 1.2}, {half, 1.2}, plot::Ink::muted, plot::Stroke::dashed)
      .segment({-5, 1.2}, {0, 0}, plot::Ink::muted)
      .arrow({0, 0}, {0, 1.2}, plot::Ink::ink, "ℓ", plot::Side::right)
      .segment({0, 0}, {-half, 1.2}, plot::Ink::a)
      .label({-half / 2, 0.6}, "r", plot::Side::below_left, plot::Ink::a)
      .label({-2.9, 0.55}, "f", plot::Side::below)
      .dimension({-5, 1.2}, {-half, 1.2}, "t |v|", 14)
      .dimension({-half, 1.2}, {0, 1.2}, "h", 14)
      .dimension({-5, 1.2}, {half, 1.2}, "q / |v|", 50)
      .dot({0, 0}, plot::Ink::a, "c", plot::Side::below)
      .dot({-5, 1.2}, plot::Ink::ink, "o", plot::Side::below)
      .point({-half, 1.2}, plot::Ink::overlap);
  return figure;
}

/// Two slabs, and the parts of a ray in each.
inline plot::Figure2d slab_figure()
{
  plot::Figure2d figure("casts_slabs", "", {{-0.6, -0.7}, {6.4, 4.3}, 420});
  const Eigen::Vector2d origin(0, 0.2), direction(1, 0.55);
  const auto at = [&](double t) -> Eigen::Vector2d { return origin + t * direction; };
  const double x_in = 2, x_out = 5, y_in = (1.1 - 0.2) / 0.55, y_out = (2.6 - 0.2) / 0.55;
  figure.describe("A ray is in the upright slab from 2 to 5, in the level one from 1.6 to 4.4.")
      .polygon({{2, -0.6}, {5, -0.6}, {5, 4.2}, {2, 4.2}}, plot::Ink::a)
      .polygon({{-0.5, 1.1}, {6.3, 1.1}, {6.3, 2.6}, {-0.5, 2.6}}, plot::Ink::b)
      .box({3.5, 1.85}, 0, {1.5, 0.75}, plot::Ink::ink, plot::Fill::none)
      .arrow(at(0), at(6.2), plot::Ink::ink)
      .segment(at(x_in), at(y_out), plot::Ink::overlap, plot::Stroke::solid, 3.2)
      .dot(at(x_in), plot::Ink::a, "x in", plot::Side::above)
      .dot(at(x_out), plot::Ink::a, "x out", plot::Side::below_right)
      .dot(at(y_in), plot::Ink::b, "y in", plot::Side::below_right)
      .dot(at(y_out), plot::Ink::b, "y out", plot::Side::above)
      .dot(at(0), plot::Ink::ink, "o", plot::Side::below);
  return figure;
}

/// Two triangles that share an edge, in the view along a ray.
inline plot::Figure2d sheared_figure()
{
  plot::Figure2d figure("casts_sheared", "", {{-3.1, -2.1}, {3.3, 2.4}, 420});
  const Eigen::Vector2d a(-2.6, -0.6), b(0.9, -1.5), c(0.4, 2), d(2.8, 0.9);
  figure.describe("Two triangles that share an edge, seen along a ray, which is the origin.")
      .polygon({a, b, c}, plot::Ink::a)
      .polygon({b, d, c}, plot::Ink::b)
      .segment({0, 0}, a, plot::Ink::muted, plot::Stroke::dashed)
      .segment({0, 0}, b, plot::Ink::muted, plot::Stroke::dashed)
      .segment({0, 0}, c, plot::Ink::muted, plot::Stroke::dashed)
      .label(a, "a", plot::Side::left)
      .label(b, "b", plot::Side::below)
      .label(c, "c", plot::Side::above)
      .point({0, 0}, plot::Ink::overlap, "ray", plot::Side::below_left);
  return figure;
}

} // namespace cookbook
