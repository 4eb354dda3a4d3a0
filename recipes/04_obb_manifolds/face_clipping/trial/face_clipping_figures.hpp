#pragma once

/// \file
/// \brief The figures of face clipping: one cut after the other, and three kinds of contact.

#include "04_obb_manifolds/face_clipping/face_clipping.hpp"
#include "04_obb_manifolds/face_clipping/trial/face_clipping_scenes.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/panel.hpp"
#include "tools/program/table.hpp"

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

/// The corners of a polygon in the reference face's plane.
inline std::vector<Eigen::Vector2d> flat(const FacePolygon<double>& polygon)
{
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < polygon.size; ++i)
  {
    corners.push_back(polygon[i].point.head<2>());
  }
  return corners;
}

/// The reference face's side 0 … 3 as a line across the picture.
inline std::pair<Eigen::Vector2d, Eigen::Vector2d>
line_of_side(const BoxFace<double>& reference, int side)
{
  const double sign = side == 1 || side == 2 ? 1 : -1;
  const double at = sign * reference.half_sides[side % 2 == 0 ? 1 : 0];
  return side % 2 == 0 ? std::pair(Eigen::Vector2d(-1.7, at), Eigen::Vector2d(1.7, at))
                       : std::pair(Eigen::Vector2d(at, -1.7), Eigen::Vector2d(at, 1.7));
}

/// A picture of the reference face's plane with nothing but the reference face.
inline plot::Figure2d
reference_figure(const BoxFace<double>& reference, const std::string& title, double width = 189)
{
  plot::Figure2d figure("face_clipping", title, {{-1.75, -1.75}, {1.75, 1.75}, width});
  figure.box({0, 0}, 0, reference.half_sides, plot::Ink::a, plot::Fill::none);
  return figure;
}

/// How many corners a polygon has, in words.
inline std::string corners(const FacePolygon<double>& polygon)
{
  return std::to_string(polygon.size) + " corners";
}

/// One cut: what was there before, dotted, and what is left, with its new corners.
inline plot::Figure2d cut_figure(
    const FacePolygon<double>& before, const FacePolygon<double>& after,
    const BoxFace<double>& reference, int side, double width)
{
  plot::Figure2d figure =
      reference_figure(reference, "cut " + std::to_string(side + 1) + ": " + corners(after), width);
  const auto [from, to] = line_of_side(reference, side);
  figure.polygon(flat(before), plot::Ink::muted, plot::Fill::none, plot::Stroke::dotted)
      .polygon(flat(after), plot::Ink::b)
      .segment(from, to, plot::Ink::ink, plot::Stroke::dashed);
  const int cut = reference.edges[std::size_t(side)];
  for (int i = 0; i < after.size; ++i)
  {
    if (after[i].edge == cut || after[i - 1].edge == cut)
    {
      figure.dot(after[i].point.head<2>(), plot::Ink::overlap);
    }
  }
  return figure;
}

/// What is left, with its depths; corners with a gap too wide are not marked as contact points.
inline plot::Figure2d depths_figure(
    const FacePolygon<double>& polygon, const BoxFace<double>& reference, double widest_separation,
    double width)
{
  plot::Figure2d figure = reference_figure(reference, "depths at the corners [m]", width);
  figure.polygon(flat(polygon), plot::Ink::b);
  for (const PolygonCorner<double>& corner :
       std::span(polygon.corners).first(std::size_t(polygon.size)))
  {
    const Eigen::Vector2d at = corner.point.head<2>();
    const std::string text = number(std::round(corner.point.z() * -1e3) * 1e-3);
    corner.point.z() <= widest_separation
        ? figure.point(at).label(at, text, plot::Side::automatic, plot::Ink::overlap)
        : figure.dot(at, plot::Ink::muted, text);
  }
  return figure;
}

/// A face of B above a face of A, and what is left of it after each cut.
struct Clipping
{
  BoxesInFrameOfA<double> boxes;
  BoxFace<double> reference;                   ///< of A
  std::array<FacePolygon<double>, 5> polygons; ///< after 0 … 4 cuts
};

/// How the face of B that lies along A's axis of least overlap is cut.
inline Clipping
clipping_of(const Obb<double>& a, const Obb<double>& b, const LeastOverlap<double>& least)
{
  const BoxesInFrameOfA<double> boxes = boxes_in_frame_of_a(a, b, least);
  const BoxFace<double> reference = face_along<double>(boxes.a, boxes.least.normal);
  Clipping clipping{boxes, reference, {}};
  clipping.polygons[0] = seen_from(reference, face_along<double>(boxes.b, -boxes.least.normal));
  for (int side = 0; side < 4; ++side)
  {
    clipping.polygons[std::size_t(side + 1)] =
        cut_at_side(clipping.polygons[std::size_t(side)], reference, side, boxes.tolerance);
  }
  return clipping;
}

/// Step 0 … 5 of clipping: the two faces, four cuts, and the depths of what is left.
inline plot::Figure2d clip_step_figure(const Clipping& clipping, int step, double width = 189)
{
  const auto& [boxes, reference, polygons] = clipping;
  if (step == 0)
  {
    return reference_figure(reference, "two faces: " + corners(polygons[0]), width)
        .polygon(flat(polygons[0]), plot::Ink::b);
  }
  return step < 5 ? cut_figure(
                        polygons[std::size_t(step - 1)], polygons[std::size_t(step)], reference,
                        step - 1, width)
                  : depths_figure(polygons[4], reference, boxes.widest_separation, width);
}

/// How the incident face is cut at one side of the reference face after the other.
inline std::string clip_figure(const BoxScene& scene)
{
  const Clipping clipping = clipping_of(scene.a, scene.b, *separating_axes(scene.a, scene.b));
  plot::Grid grid("face_clipping", "", 2);
  grid.describe("The rectangle of a face of B, cut at the four sides of a face of A.");
  for (int step = 0; step < 6; ++step)
  {
    grid.add(clip_step_figure(clipping, step));
  }
  return grid.svg();
}

} // namespace cookbook
