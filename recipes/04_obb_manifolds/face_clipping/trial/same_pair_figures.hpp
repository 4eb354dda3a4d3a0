#pragma once

/// \file
/// \brief The points that each method finds for one pair of boxes, side by side.

#include "04_obb_manifolds/box_as_published/trial/box_as_published.hpp"
#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/contact_reduction/contact_reduction.hpp"
#include "04_obb_manifolds/edge_clipping/edge_clipping.hpp"
#include "04_obb_manifolds/face_clipping/trial/face_clipping_figures.hpp"
#include "04_obb_manifolds/gjk_epa/gjk_epa.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

/// Marks a contact point with its depth, unless a point close by says the same already.
struct DepthLabels
{
  std::vector<std::pair<Eigen::Vector2d, std::string>> written; ///< where, and what

  /// The label of a point; empty if it need not be said again.
  std::string of(const Eigen::Vector2d& at, double depth)
  {
    const std::string text = number(std::round(depth * 1e3) * 1e-3);
    const bool again = std::any_of(
        written.begin(), written.end(),
        [&](const auto& label) { return label.second == text && (label.first - at).norm() < 0.3; });
    written.push_back({at, text});
    return again ? "" : text;
  }
};

/// The points of a manifold over the reference face, with their depths.
template <std::size_t Capacity>
plot::Figure2d points_figure(
    const std::string& method, const Manifold<double, Capacity>& manifold, const BoxScene& scene)
{
  const BoxesInFrameOfA<double> boxes =
      boxes_in_frame_of_a(scene.a, scene.b, *separating_axes(scene.a, scene.b));
  const BoxFace<double> reference = face_along<double>(boxes.a, boxes.least.normal);
  const BoxFace<double> incident = face_along<double>(boxes.b, -boxes.least.normal);
  const std::size_t count = manifold.points.size();
  plot::Figure2d figure = reference_figure(
      reference, method + ": " + std::to_string(count) + (count == 1 ? " point" : " points"));
  figure.polygon(flat(seen_from(reference, incident)), plot::Ink::b);
  DepthLabels labels;
  for (const ContactPoint<double>& point : manifold.points)
  {
    const Vector3<double> from_a = scene.a.axes.transpose() * (point.position - scene.a.center);
    const Eigen::Vector2d at =
        (reference.axes.transpose() * (from_a - reference.center)).template head<2>();
    figure.point(at).label(
        at, labels.of(at, point.depth), plot::Side::automatic, plot::Ink::overlap);
  }
  return figure;
}

/// What six methods make of two boxes that meet at a face of A.
inline plot::Grid same_pair_figure(const BoxScene& scene)
{
  const Manifold<double> all = face_clipping(scene.a, scene.b).value();
  plot::Grid grid("face_clipping_methods", "", 2);
  grid.describe("The contact points of six methods for the same two boxes, with their depths.");
  return grid.add(points_figure("box_as_published", *box_as_published(scene.a, scene.b), scene))
      .add(points_figure("edge_clipping", *edge_clipping(scene.a, scene.b), scene))
      .add(points_figure("gjk_epa", *gjk_epa(scene.a, scene.b), scene))
      .add(points_figure("face_clipping", all, scene))
      .add(points_figure("reduced", reduced(all), scene))
      .add(points_figure("box_box", *box_box(scene.a, scene.b), scene));
}

} // namespace cookbook
