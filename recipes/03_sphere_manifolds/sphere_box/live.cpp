/// \file
/// \brief A ball to be dragged into a box: through which face it leaves, and where the published
/// code sends it.

#include "03_sphere_manifolds/collision/trial/collision_names.hpp"
#include "03_sphere_manifolds/manifold/trial/as_double.hpp"
#include "03_sphere_manifolds/sphere_box/trial/sphere_box_figures.hpp"
#include "03_sphere_manifolds/sphere_failures/trial/sphere_box_methods.hpp"
#include "tools/live/page.hpp"

namespace cookbook::live
{

namespace
{

/// The manifold by one of the methods; the published one computes in float.
std::optional<Manifold<double>>
manifold_by(int method, const Sphere<double>& sphere, const Obb<double>& box)
{
  if (method == 0)
  {
    return plain_sphere_box(sphere, box);
  }
  return as_double(sphere_box_as_published(
      {sphere.center.cast<float>(), float(sphere.radius)},
      {box.center.cast<float>(), box.axes.cast<float>(), box.half_extents.cast<float>()}));
}

/// A number of metres, to a millionth.
std::string metres(double x)
{
  return number(std::round(x * 1e6) * 1e-6 + 0.0) + " m";
}

/// How far a ball is inside a box [m], negative where there is a gap.
double overlap_of(const Sphere<double>& sphere, const Obb<double>& box)
{
  const Vector3<double> local = box.axes.transpose() * (sphere.center - box.center);
  return sphere.radius - signed_distance_box<double>(local, box.half_extents).length;
}

void show_numbers(
    Page& page, const Sphere<double>& sphere, const Obb<double>& box,
    const std::optional<Manifold<double>>& manifold)
{
  const double out = -overlap_of({sphere.center, 0}, box);
  page.text(
      "centre of A", out > 0   ? metres(out) + " outside"
                     : out < 0 ? metres(-out) + " inside"
                               : "on the surface");
  page.text("method says", manifold ? "overlap" : "apart");
  if (!manifold)
  {
    for (const char* name : {"depth d", "normal n", "once A has moved"})
    {
      page.text(name, "–"); // the lines stay, so that nothing jumps
    }
    return;
  }
  const Vector3<double>& n = manifold->normal;
  const Sphere<double> moved{sphere.center - manifold->depth * n, sphere.radius};
  page.number("depth d", manifold->depth, "m");
  page.text("normal n", "(" + number(n.x() + 0.0) + ", " + number(n.y() + 0.0) + ")");
  page.text("once A has moved", left_after_move(overlap_of(moved, box)));
}

/// The box as the figure has it, in the plane.
void add_box(
    plot::Figure2d& figure, const Obb<double>& box, const Eigen::Vector2d& moved,
    plot::Stroke stroke)
{
  const Eigen::Vector2d x = box.half_extents.x() * box.axes.col(0).head<2>(),
                        y = box.half_extents.y() * box.axes.col(1).head<2>(),
                        c = box.center.head<2>() + moved;
  figure.polygon(
      {c - x - y, c + x - y, c + x + y, c - x + y}, plot::Ink::b,
      stroke == plot::Stroke::solid ? plot::Fill::wash : plot::Fill::none, stroke);
}

/// A and B where each has moved by half the depth.
void add_halves(
    plot::Figure2d& figure, const Sphere<double>& sphere, const Obb<double>& box,
    const Manifold<double>& manifold)
{
  const Eigen::Vector2d half = penetration_distance(manifold) * manifold.normal.head<2>();
  const Eigen::Vector2d center = sphere.center.head<2>() - half;
  figure.circle(center, sphere.radius, plot::Ink::a, plot::Fill::none, plot::Stroke::dotted);
  add_box(figure, box, half, plot::Stroke::dotted);
}

} // namespace

void figure(Page& page)
{
  const plot::View view{{-2.9, -2.1}, {2.9, 2.1}, page.fit(480)};
  const plot::Figure2d empty("sphere_box", "", view);
  const int method = page.choice("method", {"plain_sphere_box", "sphere_box_as_published"});
  const Eigen::Vector2d handle = page.handle("A", empty, {0.7, 0.55}, plot::Ink::a);
  const Eigen::Vector2d towards = page.handle("turn B", empty, {2.45, 0.3}, plot::Ink::b);
  const double radius = page.slider("radius of A", 0.1, 1, 0.5, "m");
  const bool snapped = page.toggle("A on a grid of 0.1 m, B upright");
  const bool halves = page.toggle("each moved by half the depth");

  const Eigen::Vector2d at = snapped ? Eigen::Vector2d((handle * 10).array().round() / 10) : handle;
  const double length = towards.norm();
  const Eigen::Vector2d u =
      snapped || length == 0 ? Eigen::Vector2d(1, 0) : Eigen::Vector2d(towards / length);
  Matrix3<double> axes;
  axes << u.x(), -u.y(), 0, u.y(), u.x(), 0, 0, 0, 1;
  const Sphere<double> sphere{{at.x(), at.y(), 0}, radius};
  const Obb<double> box{{0, 0, 0}, axes, {1.8, 1, 1}};
  const std::optional<Manifold<double>> manifold = manifold_by(method, sphere, box);
  show_numbers(page, sphere, box, manifold);

  plot::Figure2d figure("sphere_box_live", "", view);
  figure.describe("A ball and a box; an arrow shows by which move the ball leaves the box.")
      .keep_free(handle, handle_room)
      .keep_free(towards, handle_room);
  add_box(figure, box, {0, 0}, plot::Stroke::solid);
  figure.segment({0, 0}, towards, plot::Ink::muted, plot::Stroke::dotted, 1.2)
      .label(
          (axes * Vector3<double>(-1.5, -0.75, 0)).head<2>(), "B", plot::Side::centre, plot::Ink::b)
      .label(at + radius * Eigen::Vector2d(-0.6, 0.5), "A", plot::Side::centre, plot::Ink::a);
  if (manifold)
  {
    add_way_out(figure, sphere, *manifold, "−d n");
    const Eigen::Vector2d contact = manifold->points[0].position.head<2>();
    figure.arrow(contact, contact + 0.45 * manifold->normal.head<2>(), plot::Ink::ink, "n");
    if (halves)
    {
      add_halves(figure, sphere, box, *manifold);
    }
  }
  else
  {
    figure.circle(at, radius, plot::Ink::a);
  }
  page.draw(figure.svg());
}

} // namespace cookbook::live
