/// \file
/// Draws scenes: planes as background, and the bodies in front of it.

#include "06_world/scene_figures/trial/scene_figures.hpp"
#include "06_world/scene_figures/trial/scene_bounds_figures.hpp"
#include "06_world/scene_figures/trial/scene_motion_figures.hpp"
#include "tools/plot/figures/figure2d.hpp"

namespace cookbook
{
namespace
{

using Eigen::Vector2d;

constexpr double followed = 6; // [m] from the start, where the start itself is not larger

void require_frames(const Scene& scene, const std::vector<Frame>& frames)
{
  const auto fits = [&scene](const Frame& frame)
  { return frame.bodies.size() == scene.bodies.size() && std::isfinite(frame.time); };
  if (frames.empty() || !std::all_of(frames.begin(), frames.end(), fits))
  {
    throw std::invalid_argument(
        "a picture of scene " + scene.name + " needs frames of all its bodies");
  }
}

Projection projection(const SceneView& view, const std::string& title)
{
  return {
      picture_axes(view.yaw, view.pitch),
      {view.min.x(), view.max.y()},
      view.width / (view.max.x() - view.min.x()),
      plot::title_height(title, view.width)};
}

/// Draws a part of a plane as a grid, where it is seen from above.
void draw_patch(plot::Figure2d& figure, const PlaneShape& plane, const SceneView& view)
{
  const Matrix3<double> axes = picture_axes(view.yaw, view.pitch);
  const Vector3<double> towards = axes.row(2);
  const Vector2d middle = (view.min + view.max) / 2;
  const Vector3<double> seen = axes.topRows<2>().transpose() * middle;
  const Vector3<double> foot =
      seen + towards * ((plane.offset - plane.normal.dot(seen)) / plane.normal.dot(towards));
  const bool level = std::abs(plane.normal.y()) > 0.5;
  const Vector3<double> aside = level ? Vector3<double>(1, 0, 0) : Vector3<double>(0, 1, 0);
  const double reach = 0.55 * (view.max.x() - view.min.x());
  const Vector3<double> u = reach * plane.normal.cross(aside).normalized();
  const Vector3<double> v = plane.normal.cross(u);
  const auto at = [&](double s, double t) -> Vector2d
  { return (axes * (foot + s * u + t * v)).head<2>(); };
  figure.polygon({at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)}, plot::Ink::faint);
  for (const double s : {-0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75})
  {
    figure.segment(at(s, -1), at(s, 1), plot::Ink::faint, plot::Stroke::solid, 0.9);
    figure.segment(at(-1, s), at(1, s), plot::Ink::faint, plot::Stroke::solid, 0.9);
  }
}

/// Title and planes.
plot::Figure2d background(const std::string& title, const Scene& scene, const SceneView& view)
{
  plot::Figure2d figure("scene", title, {view.min, view.max, view.width});
  const Matrix3<double> axes = picture_axes(view.yaw, view.pitch);
  for (const SceneBody& body : scene.bodies)
  {
    if (const auto* const plane = std::get_if<PlaneShape>(&body.shape))
    {
      const Vector3<double> normal = axes * plane->normal;
      if (std::abs(normal.z()) < 1e-6)
      {
        figure.half_plane(normal.head<2>(), plane->offset);
      }
      else
      {
        draw_patch(figure, *plane, view);
      }
    }
  }
  return figure;
}

/// The drawing of one panel: background, bodies within the picture, and what lies below it.
plot::Panel panel_of(
    const std::string& id, const std::string& title, const plot::Figure2d& background,
    const std::string& bodies, const std::string& below, double height_below)
{
  plot::Panel panel = background.panel(id);
  const double top = plot::title_height(title, panel.width);
  panel.body += plot::svg::clipped(bodies, id + "-bodies", 0, top, panel.width, panel.height - top);
  panel.body += below;
  panel.height += height_below;
  return panel;
}

} // namespace

SceneView view_of(
    const Scene& scene, const std::vector<Frame>& frames, double width, double yaw, double pitch)
{
  require_frames(scene, frames);
  const Matrix3<double> axes = picture_axes(yaw, pitch);
  PictureBounds bounds = bounds_of(scene, frames.front(), axes, true);
  if (bounds.isEmpty())
  {
    bounds = PictureBounds(Vector2d(-1, -1), Vector2d(1, 1));
  }
  const double side = bounds.sizes().maxCoeff();
  const Vector2d beyond = Vector2d::Constant(std::max(side, followed));
  const PictureBounds limit(bounds.min() - beyond, bounds.max() + beyond);
  bounds.extend(bounds_of(scene, frames.front(), axes, false).intersection(limit));
  for (const Frame& frame : frames)
  {
    bounds.extend(bounds_of(scene, frame, axes, true).intersection(limit));
  }
  const Vector2d margin = Vector2d::Constant(0.08 * bounds.sizes().maxCoeff());
  PictureBounds shown(bounds.min() - margin, bounds.max() + margin);
  const double missing = shown.sizes().y() / 1.2 - shown.sizes().x();
  const Vector2d wider(std::max(0.0, missing / 2), 0);
  return {yaw, pitch, shown.min() - wider, shown.max() + wider, width};
}

SceneFigure::SceneFigure(std::string name, Draw draw)
    : name_(std::move(name)), draw_(std::move(draw))
{
  plot::svg::require_name(name_);
}

SceneFigure& SceneFigure::describe(std::string text)
{
  description_ = std::move(text);
  return *this;
}

plot::Panel SceneFigure::panel(const std::string& id) const
{
  plot::Panel panel = draw_(id);
  panel.description = description_;
  return panel;
}

std::string SceneFigure::svg() const
{
  return plot::document(name_, panel(name_));
}

SceneFigure scene_picture(
    const std::string& name, const std::string& title, const Scene& scene, const Frame& frame,
    const SceneView& view)
{
  require_frames(scene, {frame});
  const Projection project = projection(view, title);
  const std::vector<plot::Ink> inks = inks_of(scene);
  std::string paths;
  for (const std::size_t i : drawing_order(scene, {frame}, view))
  {
    const SceneBody& body = scene.bodies[i];
    const Outline outline = body_outline(body, frame.bodies[i], project);
    paths +=
        body_path(outline_data(outline, ball_radius(body, project.scale)), inks[i], is_front(view));
  }
  const plot::Figure2d behind = background(title, scene, view);
  return {name, [=](const std::string& id) { return panel_of(id, title, behind, paths, "", 0); }};
}

SceneFigure scene_animation(
    const std::string& name, const std::string& title, const Scene& scene,
    const std::vector<Frame>& frames, const SceneView& view, const Pace& pace)
{
  require_frames(scene, frames);
  const double duration = frames.back().time - frames.front().time;
  if (!(duration > 0))
  {
    return scene_picture(name, title, scene, frames.front(), view);
  }
  const Projection project = projection(view, title);
  const double frames_wanted = std::max(1.0, 30 * duration * pace.slowness);
  std::size_t stride = static_cast<std::size_t>(
      std::max(1.0, std::round(static_cast<double>(frames.size()) / frames_wanted)));
  const auto draw = [&]
  { return moving_bodies(scene, frames, view, project, stride, pace.slowness); };
  std::string paths = draw();
  while (paths.size() > pace.most_bytes && stride < frames.size())
  {
    stride += std::max<std::size_t>(1, stride / 4);
    paths = draw();
  }
  const plot::Figure2d behind = background(title, scene, view);
  const double bottom = behind.panel(name).height;
  const std::string below =
      time_axis(frames.front().time, frames.back().time, bottom, view.width, pace.slowness);
  return {name, [=](const std::string& id) {
            return panel_of(id, title, behind, paths, below, time_axis_height);
          }};
}

plot::Grid scene_strip(
    const std::string& name, const Scene& scene, const std::vector<Frame>& frames,
    const std::vector<double>& times, const SceneView& view, int columns)
{
  plot::Grid grid(name, "", columns);
  for (const double time : times)
  {
    const Frame& frame = frame_at(frames, time);
    const std::string title = plot::significant(frame.time, 3) + " s";
    grid.add(scene_picture(name, title, scene, frame, view));
  }
  return grid;
}

plot::Grid scene_gallery(
    const std::string& name, const Scene& scene, const std::vector<NamedFrame>& frames,
    const SceneView& view, int columns)
{
  plot::Grid grid(name, "", columns);
  for (const NamedFrame& one : frames)
  {
    grid.add(scene_picture(name, one.name, scene, one.frame, view));
  }
  return grid;
}

} // namespace cookbook
