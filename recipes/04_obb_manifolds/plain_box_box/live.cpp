/// \file
/// \brief Two boxes to be dragged and turned: the manifold of each method, and the fifteen overlaps
/// that it comes from.

#include "03_sphere_manifolds/collision/trial/collision_names.hpp"
#include "04_obb_manifolds/plain_box_box/trial/plain_box_box_dragged.hpp"
#include "tools/live/page.hpp"

namespace cookbook::live
{

namespace
{

constexpr double degree = std::numbers::pi / 180; // [rad]
constexpr double depth_of_b = 0.1; // [m], where the plane stands that B is dragged in

/// A vector to three decimals, in brackets.
std::string written(const Vector3<double>& v)
{
  const auto rounded = [](double x) { return number(std::round(x * 1e3) * 1e-3 + 0.0); };
  return "(" + rounded(v.x()) + ", " + rounded(v.y()) + ", " + rounded(v.z()) + ")";
}

/// The camera and its frame, `width` pixels wide.
plot::Figure3d empty_scene(const plot::Camera& camera, const plot::Frame& frame)
{
  return plot::Figure3d("contacts", "", camera).frame(frame);
}

/// B, at the handle that moves it, turned by the one that turns it after a yaw [rad].
Obb<double> box_at(const Eigen::Vector2d& at, const Eigen::Vector2d& towards, double yaw)
{
  const double length = towards.norm();
  const Eigen::Vector2d u = length > 0 ? Eigen::Vector2d(towards / length) : Eigen::Vector2d(1, 0);
  Matrix3<double> roll;
  roll << u.x(), -u.y(), 0, u.y(), u.x(), 0, 0, 0, 1;
  return {{at.x(), at.y(), depth_of_b}, roll * turned(yaw, {0, 1, 0}), {0.75, 0.5, 0.6}};
}

/// A box as a line of C++.
std::string code_of(const char* name, const Obb<double>& box)
{
  std::string axes;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      char text[32];
      std::snprintf(text, sizeof text, "%.17g", box.axes(row, column));
      axes += (axes.empty() ? "" : ", ") + std::string(text);
    }
  }
  const std::string axes_name = std::string("axes_") + name;
  const auto list = [](const Vector3<double>& v)
  { return "{" + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + "}"; };
  return "Matrix3<double> " + axes_name + ";\n" + axes_name + " << " + axes +
         ";\nconst Obb<double> " + name + "{" + list(box.center) + ", " + axes_name + ", " +
         list(box.half_extents) + "};\n";
}

/// How far two boxes overlap [m]; negative where a gap separates them.
double overlap_of(const Obb<double>& a, const Obb<double>& b)
{
  const std::array<std::optional<double>, box_axes> overlaps = axes_overlaps(a, b);
  return *overlaps[static_cast<std::size_t>(least_axis(overlaps))];
}

/// What the answer says, and what becomes of the overlap once B has moved by it.
void show_numbers(Page& page, const BoxAnswer& answer, const Obb<double>& a, const Obb<double>& b)
{
  page.text("boxes", answer.manifold ? "overlap" : "are apart");
  page.text(
      answer.manifold ? "best axis" : "separating axis",
      answer.axis < 0 ? "none" : axis_name(answer.axis));
  if (!answer.manifold)
  {
    for (const char* name : {"depth", "normal", "contact points", "once B has moved"})
    {
      page.text(name, "–"); // the lines stay, so that nothing jumps
    }
    return;
  }
  const Vector3<double> move = answer.manifold->depth * answer.manifold->normal;
  page.number("depth", answer.manifold->depth, "m");
  page.text("normal", written(answer.manifold->normal));
  page.text("contact points", std::to_string(answer.manifold->points.size()));
  const Obb<double> moved{b.center + move, b.axes, b.half_extents};
  page.text("once B has moved", left_after_move(overlap_of(a, moved)));
}

} // namespace

void figure(Page& page)
{
  const bool wide = page.width() >= 600;
  const double bars = wide ? 300 : page.fit(480);
  const double width = wide ? std::min(480.0, page.fit(1000) - bars - 22) : page.fit(520);
  const int method = page.choice("method", box_answer_names());
  const double yaw = page.slider("view from", -60, 60, -28, "°") * degree;
  const plot::Camera camera{yaw, 0.3, width, wide ? 480 : 0.85 * width, 10};
  const plot::Frame frame{{0.35, 0.45, 0}, 4.4};
  const plot::Figure3d empty = empty_scene(camera, frame);

  const Vector3<double> x(1, 0, 0), y(0, 1, 0), origin(0, 0, depth_of_b);
  const Eigen::Vector2d at =
      page.handle("B", drag_plane(empty, origin, x, y), {0.45, 0.98}, plot::Ink::b)
          .cwiseMax(Eigen::Vector2d(-1.5, -1.1))
          .cwiseMin(Eigen::Vector2d(2.1, 2));
  const Vector3<double> center(at.x(), at.y(), depth_of_b);
  const Eigen::Vector2d towards =
      page.handle("turn B", drag_plane(empty, center, x, y), {1.26, 0.34}, plot::Ink::ink);
  const double yaw_of_b = page.slider("yaw of B", -90, 90, 40, "°") * degree;
  const double slope = page.slider("slope of A", -45, 45, 18, "°") * degree;
  const bool moved = page.toggle("move B by depth and normal");

  const Obb<double> a{{0, 0, 0}, turned(slope, {0, 0, 1}), {1.2, 0.35, 1}};
  const Obb<double> b = box_at(at, towards, yaw_of_b);
  const BoxAnswer answer = box_answer(method, a, b);
  show_numbers(page, answer, a, b);
  const BoxScene scene{
      "", a, b, a.axes * Vector3<double>(-0.9, -0.1, 1),
      b.center + b.axes * Vector3<double>(-0.5, 0.3, 0)};
  plot::Figure3d figure = boxes_figure(scene, camera).frame(frame);
  figure.segment(
      center, center + Vector3<double>(towards.x(), towards.y(), 0), plot::Ink::muted,
      plot::Stroke::dotted, 1.2);
  if (answer.manifold)
  {
    add_contacts(figure, scene, *answer.manifold, yaw, 2.1);
    if (moved)
    {
      const Vector3<double> move = answer.manifold->depth * answer.manifold->normal;
      figure.box(b.center + move, b.axes, b.half_extents, plot::Ink::ink);
    }
  }
  plot::Grid grid("plain_box_box_live", "", wide ? 2 : 1);
  grid.describe("Two boxes with their manifold, and their overlap along each of fifteen axes.");
  page.draw(grid.add(figure).add(overlaps_chart(answer, bars)).svg());
  page.code(
      code_of("a", a) + code_of("b", b) + "const auto manifold = " +
      box_answer_names()[static_cast<std::size_t>(method)] + "(a, b);\n");
}

} // namespace cookbook::live
