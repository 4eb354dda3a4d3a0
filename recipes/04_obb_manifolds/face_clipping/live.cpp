/// \file
/// \brief Face clipping step by step: a face of B, dragged and turned over a face of A.

#include "04_obb_manifolds/face_clipping/trial/face_clipping_figures.hpp"
#include "tools/live/page.hpp"

#include <numbers>

namespace cookbook::live
{

namespace
{

const Obb<double> box_a = upright({0, 0, 0}, {1.2, 0.3, 1});

/// B over A's top, whose x and y are the world's z and x: moved, turned and leaning by `lean`
/// [rad].
Obb<double> box_over(const Eigen::Vector2d& at, const Eigen::Vector2d& towards, double lean)
{
  const double length = towards.norm();
  const Eigen::Vector2d u = length > 0 ? Eigen::Vector2d(towards / length) : Eigen::Vector2d(0, 1);
  Matrix3<double> yaw;
  yaw << u.y(), 0, -u.x(), 0, 1, 0, u.x(), 0, u.y();
  return {{at.y(), 0.68, at.x()}, turned(lean, {-1, 0, -0.4}) * yaw, {1.2, 0.45, 0.8}};
}

/// The two boxes, with what is left of B's face after so many cuts.
plot::Figure3d
space_figure(const Obb<double>& b, const Clipping& clipping, int cuts, const plot::Camera& camera)
{
  const BoxScene scene{
      "", box_a, b, {-1.2, -0.05, -0.6}, b.center + b.axes * Vector3<double>(-0.9, 0.25, 0)};
  plot::Figure3d figure = boxes_figure(scene, camera);
  std::vector<Vector3<double>> corners;
  const FacePolygon<double>& polygon = clipping.polygons[std::size_t(cuts)];
  for (int i = 0; i < polygon.size; ++i)
  {
    const BoxFace<double>& reference = clipping.reference;
    corners.push_back(reference.center + reference.axes * polygon[i].point);
  }
  return figure.frame({{0, 0.35, 0}, 3.7}).polygon(corners, plot::Ink::overlap);
}

/// The corners, and those that are contact points.
void show_numbers(Page& page, const Clipping& clipping, int cuts)
{
  const FacePolygon<double>& polygon = clipping.polygons[std::size_t(cuts)];
  page.text("corners", std::to_string(polygon.size));
  if (cuts < 4)
  {
    return;
  }
  int points = 0;
  double deepest = 0;
  for (int i = 0; i < polygon.size; ++i)
  {
    points += polygon[i].point.z() <= clipping.boxes.widest_separation ? 1 : 0;
    deepest = std::max(deepest, -polygon[i].point.z());
  }
  page.text("contact points", std::to_string(points));
  page.number("deepest", deepest, "m");
  page.number("gap allowed", clipping.boxes.widest_separation, "m");
}

} // namespace

void figure(Page& page)
{
  const bool wide = page.width() >= 600;
  const double width = wide ? std::min(380.0, (page.fit(1000) - 22) / 2) : page.fit(380);
  const plot::Camera camera{-1.15, 0.5, width, wide ? width : 0.7 * width, 10};
  const Eigen::Vector2d offset =
      wide ? Eigen::Vector2d(width + 22, 0) : Eigen::Vector2d(0, camera.height + 22);
  const plot::Figure2d empty("plane", "one line", {{-1.75, -1.75}, {1.75, 1.75}, width});

  const int step =
      page.choice("step", {"two faces", "cut 1", "cut 2", "cut 3", "cut 4", "depths"}, 2);
  const double limit = 1.6;
  const Eigen::Vector2d at = page.handle("B", drag_plane(empty, offset), {0.15, 0.05}, plot::Ink::b)
                                 .cwiseMax(-limit)
                                 .cwiseMin(limit);
  DragPlane around = drag_plane(empty, offset);
  around.origin += at.x() * around.across + at.y() * around.up;
  const Eigen::Vector2d towards = page.handle("turn B", around, {-0.48, 1.31}, plot::Ink::ink);
  const double lean = page.slider("lean of B", -15, 15, 6.3, "°") * std::numbers::pi / 180;

  const Obb<double> b = box_over(at, towards, lean);
  const double overlap =
      axis_overlap(relative_boxes(box_a, b), 1).overlap; // A's top, however B is turned
  const Clipping clipping = clipping_of(box_a, b, {{0, 1, 0}, std::max(0.0, overlap), 1});
  const int cuts = std::min(step, 4);
  show_numbers(page, clipping, cuts);
  plot::Figure2d plane = clip_step_figure(clipping, step, width);
  plane.segment(at, at + towards, plot::Ink::muted, plot::Stroke::dotted, 1.2);
  plot::Grid grid("face_clipping_live", "", wide ? 2 : 1);
  grid.describe("Two boxes, and the face of B in the plane of A's top while it is cut.");
  page.draw(grid.add(space_figure(b, clipping, cuts, camera)).add(plane).svg());
}

} // namespace cookbook::live
