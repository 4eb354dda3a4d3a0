#pragma once

/// \file
/// \brief The camera's figures: a scene, what the camera sees of it, and a wall that six planes
/// keep.

#include "02_primitives/camera/camera.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/figures/figure3d.hpp"
#include "tools/plot/panel.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace cookbook
{

/// What the first figure shows: a camera, the two things before it, and the pixel that is picked.
struct ViewScene
{
  Camera<double> camera;
  Eigen::AlignedBox<double, 3> box; ///< [m]
  Sphere<double> sphere;            ///< [m]
  Vector<double, 2> pixel;          ///< [pixels]
};

/// The scene of the first figure; the camera sees less than usual, so that what it sees is large.
/// `x` is that of the eye [m].
inline ViewScene view_scene(double x = -0.5)
{
  const Matrix4<double> lens = *perspective(0.7, 1.5, 1.6, 6.5);
  return {
      {look_at<double>({x, 2, 4.5}, {0.3, 0.3, 0}, {0, 1, 0}), lens, {480, 320}},
      {Vector3<double>(-1, 0, -1), Vector3<double>(0.2, 1, 0.2)},
      {{1.3, 0.5, 0.3}, 0.5},
      {190, 165}};
}

/// Where the ray of the picked pixel meets the plane of the box's front face.
inline Vector3<double> picked_point(const ViewScene& scene)
{
  const Ray<double> ray = picking_ray(scene.camera, scene.pixel);
  const double t = (scene.box.max().z() - ray.origin.z()) / ray.direction.z();
  return ray.origin + t * ray.direction;
}

/// The scene from outside: the eye, the frustum, and the ray of one pixel to a point.
inline plot::Figure3d
outside_figure(const ViewScene& scene, const Vector3<double>& picked, double width = 440)
{
  const std::array<Vector3<double>, 8> corners = *view_corners<double>(scene.camera, -1, 1);
  const Vector3<double> eye = scene.camera.pose.translation();
  plot::Figure3d figure("camera_outside", "the scene from outside", {1.15, 0.3, width, 300, 20});
  figure.plane({0, 0, 0}, {0, 1, 0}, 2.5, 5)
      .box(scene.box.center(), Matrix3<double>::Identity(), scene.box.sizes() / 2, plot::Ink::a)
      .sphere(scene.sphere.center, scene.sphere.radius, plot::Ink::b);
  for (unsigned i = 0; i < 4; ++i)
  {
    figure.segment(eye, corners[i], plot::Ink::muted, plot::Stroke::dotted, 1)
        .segment(corners[i], corners[i + 4], plot::Ink::muted, plot::Stroke::solid, 1);
  }
  for (const unsigned first : {0U, 4U})
  {
    figure.polyline(
        {corners[first], corners[first + 1], corners[first + 3], corners[first + 2],
         corners[first]},
        plot::Ink::muted, plot::Stroke::solid, 1.2);
  }
  figure.point(eye, plot::Ink::ink, "eye", plot::Side::above)
      .segment(eye, picked, plot::Ink::overlap)
      .point(picked, plot::Ink::overlap);
  return figure;
}

/// Where a point is seen, as a figure with y up has it.
inline Eigen::Vector2d seen_at(const Camera<double>& camera, const Vector3<double>& point)
{
  const PixelDepth<double> seen = *to_pixel(camera, point);
  return {seen.pixel.x(), camera.size.y() - seen.pixel.y()};
}

/// The outline of a sphere as the camera sees it: the circle where rays from the eye touch it.
inline std::vector<Eigen::Vector2d>
seen_outline(const Camera<double>& camera, const Sphere<double>& sphere)
{
  const Vector3<double> to_eye = camera.pose.translation() - sphere.center;
  const double fraction = sphere.radius * sphere.radius / to_eye.squaredNorm();
  const double radius = sphere.radius * std::sqrt(1 - fraction);
  const Vector3<double> u = to_eye.cross(Vector3<double>::UnitY()).normalized();
  const Vector3<double> v = to_eye.cross(u).normalized();
  std::vector<Eigen::Vector2d> outline;
  for (int i = 0; i < 60; ++i)
  {
    const double angle = i * std::numbers::pi / 30;
    const Vector3<double> around = std::cos(angle) * u + std::sin(angle) * v;
    outline.push_back(seen_at(camera, sphere.center + fraction * to_eye + radius * around));
  }
  return outline;
}

/// What the camera sees: each corner of the box sent through to_pixel, and the outline of the
/// sphere.
inline plot::Figure2d picture_figure(const ViewScene& scene, double width = 440)
{
  const Camera<double>& camera = scene.camera;
  const auto corner = [&](unsigned i)
  {
    using Box = Eigen::AlignedBox<double, 3>;
    return seen_at(camera, scene.box.corner(static_cast<Box::CornerType>(i)));
  };
  plot::Figure2d figure("camera_picture", "what the camera sees", {{0, 0}, camera.size, width});
  for (const double i : {-2.0, -1.0, 0.0, 1.0, 2.0})
  {
    figure.segment(seen_at(camera, {i, 0, -2}), seen_at(camera, {i, 0, 2}), plot::Ink::faint);
    figure.segment(seen_at(camera, {-2, 0, i}), seen_at(camera, {2, 0, i}), plot::Ink::faint);
  }
  figure.polygon({corner(4), corner(5), corner(7), corner(6)}, plot::Ink::a)
      .polygon({corner(6), corner(7), corner(3), corner(2)}, plot::Ink::a)
      .polygon({corner(5), corner(1), corner(3), corner(7)}, plot::Ink::a)
      .polygon(seen_outline(camera, scene.sphere), plot::Ink::b)
      .polygon({{1, 1}, {479, 1}, {479, 319}, {1, 319}}, plot::Ink::muted, plot::Fill::none)
      .point(
          {scene.pixel.x(), camera.size.y() - scene.pixel.y()}, plot::Ink::overlap, "picked",
          plot::Side::below);
  return figure;
}

/// The first figure of the page.
inline plot::Grid camera_figure()
{
  const ViewScene scene = view_scene();
  plot::Grid grid("camera", "", 1);
  grid.describe("A box and a ball before a camera, its frustum, and the picture that it takes.")
      .add(outside_figure(scene, picked_point(scene)))
      .add(picture_figure(scene));
  return grid;
}

/// From above: a wall that is outside of the view, but not behind any one plane.
inline plot::Figure2d wall_figure()
{
  plot::Figure2d figure("camera_wall", "", {{-14, -3}, {22, 21}, 440});
  figure.describe("A view from above, the six planes as dashed lines, and a wall beyond a corner.")
      .segment({-3, -3}, {21, 21}, plot::Ink::muted, plot::Stroke::dashed, 1)
      .segment({3, -3}, {-14, 14}, plot::Ink::muted, plot::Stroke::dashed, 1)
      .segment({-14, 10}, {22, 10}, plot::Ink::muted, plot::Stroke::dashed, 1)
      .segment({-14, 1}, {22, 1}, plot::Ink::muted, plot::Stroke::dashed, 1)
      .polygon({{-1, 1}, {1, 1}, {10, 10}, {-10, 10}}, plot::Ink::a)
      .polygon({{11, 0}, {12.5, 0}, {12.5, 20}, {11, 20}}, plot::Ink::b)
      .dot({0, 0}, plot::Ink::ink, "eye", plot::Side::below)
      .label({0, 7}, "in view", plot::Side::centre, plot::Ink::a)
      .label({12.6, 5}, "wall", plot::Side::right, plot::Ink::b)
      .label({-13.9, 10}, "far", plot::Side::above_right, plot::Ink::muted)
      .label({-13.9, 1}, "near", plot::Side::above_right, plot::Ink::muted);
  return figure;
}

} // namespace cookbook
