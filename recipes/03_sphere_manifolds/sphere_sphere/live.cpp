/// \file
/// \brief Two spheres to be dragged: their manifold, what the published code makes of it, and
/// where both are once each has moved by half the depth.

#include "03_sphere_manifolds/collision/trial/collision_names.hpp"
#include "03_sphere_manifolds/manifold/trial/as_double.hpp"
#include "03_sphere_manifolds/sphere_methods/trial/sphere_methods.hpp"
#include "03_sphere_manifolds/sphere_sphere/trial/sphere_sphere_figures.hpp"
#include "tools/live/page.hpp"

namespace cookbook::live
{

namespace
{

constexpr double tolerance = 0.01;     // [m], a depth that counts as touching
constexpr double resting_speed = 0.01; // [m/s]

/// The manifold by one of the methods; the published one computes in float.
std::optional<Manifold<double>>
manifold_by(int method, const Sphere<double>& a, const Sphere<double>& b)
{
  if (method == 0)
  {
    return plain_sphere_sphere(a, b);
  }
  const auto in_float = [](const Sphere<double>& sphere) {
    return Sphere<float>{sphere.center.cast<float>(), float(sphere.radius)};
  };
  return as_double(sphere_sphere_as_published(in_float(a), in_float(b)));
}

void show_numbers(
    Page& page, const Sphere<double>& a, const Sphere<double>& b, const Vector3<double>& velocity,
    const std::optional<Manifold<double>>& manifold)
{
  page.number("distance |t|", (b.center - a.center).norm(), "m");
  page.text("nature", name_of(nature(manifold, tolerance)));
  if (!manifold)
  {
    for (const char* name :
         {"approach", "depth d", "normal n", "each moves", "once both have moved"})
    {
      page.text(name, "–"); // the lines stay, so that nothing jumps
    }
    return;
  }
  const Vector3<double>& n = manifold->normal;
  const Vector3<double> t = b.center - a.center + manifold->depth * n; // each moves by half
  page.text("approach", name_of(approach(velocity, n, resting_speed)));
  page.number("depth d", manifold->depth, "m");
  page.text("normal n", "(" + number(n.x()) + ", " + number(n.y()) + ")");
  page.number("each moves", penetration_distance(*manifold), "m");
  page.text("once both have moved", left_after_move(a.radius + b.radius - t.norm()));
}

} // namespace

void figure(Page& page)
{
  const plot::View view{{-1.6, -1.6}, {3, 1.6}, page.fit(480)};
  const plot::Figure2d empty("sphere_sphere", "", view);
  const int method = page.choice("method", {"plain_sphere_sphere", "sphere_sphere_as_published"});
  const Eigen::Vector2d at = page.handle("B", empty, {1.536, 0.448}, plot::Ink::b);
  DragPlane around_b = drag_plane(empty);
  around_b.origin += at.x() * around_b.across + at.y() * around_b.up;
  const Eigen::Vector2d velocity = page.handle("velocity of B", around_b, {0.15, -0.75});
  const double radius = page.slider("radius of B", 0.1, 1.5, 1, "m");
  const bool separated = page.toggle("each moved by half the depth");

  const Sphere<double> a{{0, 0, 0}, 1}, b{{at.x(), at.y(), 0}, radius};
  const std::optional<Manifold<double>> manifold = manifold_by(method, a, b);
  show_numbers(page, a, b, {velocity.x(), velocity.y(), 0}, manifold);
  plot::Figure2d figure = spheres_figure(a, b, view);
  figure.describe("Two spheres with normal, depth and contact point where they overlap.")
      .keep_free(at, handle_room)
      .keep_free(at + velocity, handle_room)
      .arrow(at, at + velocity, plot::Ink::b, "v_{B}");
  if (manifold)
  {
    add_manifold(figure, a, b, *manifold, -1.14 * view.width / (view.max.x() - view.min.x()));
    if (separated)
    {
      const Eigen::Vector2d half = penetration_distance(*manifold) * manifold->normal.head<2>();
      figure.circle(-half, a.radius, plot::Ink::a, plot::Fill::none, plot::Stroke::dotted)
          .circle(at + half, b.radius, plot::Ink::b, plot::Fill::none, plot::Stroke::dotted);
    }
  }
  else
  {
    figure.dot({0, 0}, plot::Ink::a, "A", plot::Side::left)
        .dot(at, plot::Ink::b, "B", plot::Side::right);
  }
  page.draw(figure.svg());
}

} // namespace cookbook::live
