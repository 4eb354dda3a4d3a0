#pragma once

/// \file
/// \brief A beam that lies on its edge, where an axis of edges has one point for a whole stretch.

#include "04_obb_manifolds/face_clipping/box_features.hpp"
#include "04_obb_manifolds/feature_memory/trial/feature_memory_scenes.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <cmath>

namespace cookbook
{

/// The beam and the cube below it, from above: where the beam's edge leaves the cube's top.
inline plot::Figure2d beam_figure()
{
  const auto from_above = [](const Vector3<double>& v) { return Eigen::Vector2d(v.x(), v.z()); };
  const auto [cube, beam] = jittered_beam().front();
  const BoxEdge<double> edge = edge_along<double>({beam, 0}, 2, {0, -1, 0});
  const Eigen::Vector2d middle = from_above(edge.middle), way = from_above(edge.direction);
  const Eigen::Vector2d aside(way.y(), -way.x());
  const double width = std::abs(aside.dot(from_above(beam.axes.col(0)))) * beam.half_extents.x() +
                       std::abs(aside.dot(from_above(beam.axes.col(1)))) * beam.half_extents.y();
  const auto where_z = [&](double z) -> Eigen::Vector2d
  { return middle + (z - middle.y()) / way.y() * way; };
  const double rim = cube.half_extents.z();
  plot::Figure2d figure("feature_memory_beam", "", {{-1.1, -0.95}, {1.1, 0.95}, 420});
  figure.describe("A beam that lies on its edge across a cube touches along a stretch.")
      .box({0, 0}, 0, {cube.half_extents.x(), rim}, plot::Ink::a)
      .box(
          from_above(beam.center), std::atan2(way.y(), way.x()), {edge.half_length, width},
          plot::Ink::b)
      .segment(
          middle - edge.half_length * way, middle + edge.half_length * way, plot::Ink::b,
          plot::Stroke::dotted)
      .segment(where_z(-rim), where_z(rim), plot::Ink::overlap, plot::Stroke::solid, 3)
      .point(where_z(rim), plot::Ink::overlap, "now here")
      .point(where_z(-rim), plot::Ink::overlap, "now there");
  return figure;
}

} // namespace cookbook
