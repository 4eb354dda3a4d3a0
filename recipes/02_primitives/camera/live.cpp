/// \file
/// \brief A pixel to be dragged: its ray, what it hits, and which of two things are in view.

#include "02_primitives/camera/trial/camera_figures.hpp"
#include "02_primitives/casts/casts.hpp"
#include "02_primitives/plain_camera/plain_camera.hpp"
#include "tools/live/page.hpp"

#include <optional>

namespace cookbook::live
{

void figure(Page& page)
{
  const double x = page.slider("eye x", -4, 4, -0.5, "m");
  ViewScene scene = view_scene(x);
  scene.sphere.center.x() = page.slider("ball x", -4, 4, 1.3, "m");
  const double width = page.fit(440);

  // The picture stands below the view from outside: the handle is a pixel of it.
  const plot::Figure2d empty(
      "camera_picture", "what the camera sees", {{0, 0}, scene.camera.size, width});
  const plot::Panel outside = outside_figure(scene, picked_point(scene), width).panel("measured");
  const Eigen::Vector2d picked = page.handle(
      "pixel", drag_plane(empty, {0, outside.height + 22}), {190, 200}, plot::Ink::overlap);
  scene.pixel = {std::clamp(picked.x(), 0.0, 480.0), std::clamp(320 - picked.y(), 0.0, 320.0)};

  const Ray<double> ray = picking_ray(scene.camera, scene.pixel);
  const Obb<double> box{scene.box.center(), Matrix3<double>::Identity(), scene.box.sizes() / 2};
  const std::optional<Hit<double, 3>> at_box = cast(ray, box), at_ball = cast(ray, scene.sphere);
  const bool ball_first = at_ball && (!at_box || at_ball->t < at_box->t);
  const std::optional<Hit<double, 3>> hit = ball_first ? at_ball : at_box;
  page.text("the ray meets", ball_first ? "the ball" : at_box ? "the box" : "neither");
  if (hit)
  {
    page.number("distance", hit->t, "m");
  }
  const Frustum<double> frustum =
      frustum_planes(clip_from_world(scene.camera), DepthRange::minus_one_to_one);
  page.text(
      "the ball is",
      is_culled(frustum, scene.sphere) ? "culled: out of view" : "in view, or nearly");
  page.text("the box is", is_culled(frustum, box) ? "culled: out of view" : "in view, or nearly");
  plot::Grid grid("camera_live", "", 1);
  grid.describe("A box and a ball before a camera, its frustum, and the picture that it takes.");
  grid.add(outside_figure(scene, hit ? hit->point : ray.origin + 6 * ray.direction, width))
      .add(picture_figure(scene, width));
  page.draw(grid.svg());
}

} // namespace cookbook::live
