#pragma once

/// \file
/// \brief Two boxes that meet, as a picture: with the normal, the depth and the points.

#include "02_primitives/shapes/shapes.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "tools/plot/figures/figure3d.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace cookbook
{

/// Two boxes and what they do.
struct BoxScene
{
  std::string name;        ///< of the contact
  Obb<double> a;           ///< below
  Obb<double> b;           ///< above
  Vector3<double> label_a; ///< [m], world, where the figure names A
  Vector3<double> label_b; ///< [m], world
  double pitch = 0.4;      ///< [rad], from how far above it is seen
};

/// The boxes of a scene, with their names.
inline plot::Figure3d boxes_figure(const BoxScene& scene, const plot::Camera& camera)
{
  plot::Figure3d figure("contacts", scene.name, camera);
  figure.box(scene.a.center, scene.a.axes, scene.a.half_extents, plot::Ink::a)
      .box(scene.b.center, scene.b.axes, scene.b.half_extents, plot::Ink::b)
      .label(scene.label_a, "A", plot::Side::centre, plot::Ink::a)
      .label(scene.label_b, "B", plot::Side::centre, plot::Ink::b);
  return figure;
}

/// Adds a depth as a dimension line to the right of both boxes, as the camera sees them, but not
/// farther right [m] than `most`.
inline void add_depth(
    plot::Figure3d& figure, const BoxScene& scene, const ContactPoint<double>& deepest,
    const Vector3<double>& normal, double yaw, double most)
{
  const Vector3<double> right(std::cos(yaw), 0, -std::sin(yaw));
  const auto half_width = [&right](const Obb<double>& box) {
    return box.center.dot(right) + box.half_extents.dot((box.axes.transpose() * right).cwiseAbs());
  };
  const double beside = std::min(most, std::max(half_width(scene.a), half_width(scene.b)) + 0.2);
  const Vector3<double> half = normal * deepest.depth / 2;
  const Vector3<double> out = (beside - deepest.position.dot(right)) * right;
  for (const Vector3<double>& end : {half, Vector3<double>(-half)})
  {
    figure.segment(
        deepest.position + end, deepest.position + end + 1.05 * out, plot::Ink::muted,
        plot::Stroke::solid, 0.8);
  }
  figure.dimension(
      deepest.position + half + out, deepest.position - half + out,
      number(std::round(deepest.depth * 1e3) * 1e-3));
}

/// Adds a manifold to the figure of its boxes. Red stems are the depths of the points; the depth of
/// the whole stands beside the boxes, the normal in the middle of the points. One without points
/// adds nothing.
template <std::size_t Capacity>
void add_contacts(
    plot::Figure3d& figure, const BoxScene& scene, const Manifold<double, Capacity>& manifold,
    double yaw, double most = std::numeric_limits<double>::max())
{
  if (manifold.points.empty())
  {
    return;
  }
  Vector3<double> middle(0, 0, 0);
  const ContactPoint<double>* deepest = &manifold.points[0];
  for (const ContactPoint<double>& point : manifold.points)
  {
    const Vector3<double> half = manifold.normal * point.depth / 2;
    figure
        .segment(
            point.position - half, point.position + half, plot::Ink::overlap, plot::Stroke::solid,
            3)
        .point(point.position);
    middle += point.position / static_cast<double>(manifold.points.size());
    deepest = point.depth > deepest->depth ? &point : deepest;
  }
  figure.arrow(middle, middle + 0.7 * manifold.normal, plot::Ink::ink, "n");
  if (deepest->depth > 0)
  {
    add_depth(figure, scene, *deepest, manifold.normal, yaw, most);
  }
}

/// The boxes of a scene with their manifold.
template <std::size_t Capacity>
plot::Figure3d contacts_figure(
    const BoxScene& scene, const Manifold<double, Capacity>& manifold, const plot::Camera& camera)
{
  plot::Figure3d figure = boxes_figure(scene, camera);
  add_contacts(figure, scene, manifold, camera.yaw);
  return figure;
}

} // namespace cookbook
