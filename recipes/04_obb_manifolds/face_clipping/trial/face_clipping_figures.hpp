#pragma once

/// \file
/// \brief The figures of face clipping: one cut after the other, and three kinds of contact.

#include "04_obb_manifolds/face_clipping/face_clipping.hpp"
#include "04_obb_manifolds/face_clipping/trial/face_clipping_scenes.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/panel.hpp"
#include "tools/program/table.hpp"

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
inline plot::Figure2d reference_figure(const BoxFace<double>& reference, const std::string& title)
{
  plot::Figure2d figure("face_clipping", title, {{-1.75, -1.75}, {1.75, 1.75}, 189});
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
    const BoxFace<double>& reference, int side)
{
  plot::Figure2d figure =
      reference_figure(reference, "cut " + std::to_string(side + 1) + ": " + corners(after));
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
    const FacePolygon<double>& polygon, const BoxFace<double>& reference, double widest_separation)
{
  plot::Figure2d figure = reference_figure(reference, "depths at the corners [m]");
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

/// How the incident face is cut at one side of the reference face after the other.
inline std::string clip_figure(const BoxScene& scene)
{
  const BoxesInFrameOfA<double> boxes =
      boxes_in_frame_of_a(scene.a, scene.b, *separating_axes(scene.a, scene.b));
  const BoxFace<double> reference = face_along<double>(boxes.a, boxes.least.normal);
  const BoxFace<double> incident = face_along<double>(boxes.b, -boxes.least.normal);
  FacePolygon<double> polygon = seen_from(reference, incident);
  plot::Grid grid("face_clipping", "", 2);
  grid.describe("The rectangle of a face of B, cut at the four sides of a face of A.");
  plot::Figure2d start = reference_figure(reference, "two faces: " + corners(polygon));
  grid.add(start.polygon(flat(polygon), plot::Ink::b));
  for (int side = 0; side < 4; ++side)
  {
    const FacePolygon<double> inside = cut_at_side(polygon, reference, side, boxes.tolerance);
    grid.add(cut_figure(polygon, inside, reference, side));
    polygon = inside;
  }
  return grid.add(depths_figure(polygon, reference, boxes.widest_separation)).svg();
}

/// The three scenes, with normal, depth and points.
inline plot::Grid contacts_grid()
{
  plot::Grid grid("face_clipping_contacts", "", 2);
  grid.describe("Two boxes that meet face on face, corner on face and edge on edge.");
  for (const BoxScene& scene : box_scenes())
  {
    grid.add(contacts_figure(scene, *face_clipping(scene.a, scene.b), {2.5, 0.3, 189, 210, 22}));
  }
  return grid;
}

} // namespace cookbook
