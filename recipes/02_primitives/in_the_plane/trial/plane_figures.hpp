#pragma once

/// \file
/// \brief The scene of shapes in the plane, and its figures.

#include "02_primitives/in_the_plane/in_the_plane.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/panel.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// Shapes around a turned rectangle.
struct PlaneScene
{
  OrientedRectangle<double> oriented{{0, 0}, std::atan2(3, 4), {1.5, 0.75}}; ///< in the middle
  Vector<double, 2> point{-1.8, 1.6};                                        ///< up on the left
  Segment2<double> segment{{-3, -1.5}, {-0.5, -2.25}};                       ///< down on the left
  Circle<double> circle{{3, 1}, 0.75};                                       ///< on the right
  Rectangle<double> rectangle{{2, -1.5}, {1, 0.5}};                          ///< down on the right
};

/// The scene, and the way from the turned rectangle to each of the others.
inline plot::Figure2d closest_figure()
{
  using plot::Ink;
  using plot::Side;
  const PlaneScene scene;
  plot::Figure2d figure("in_the_plane", "", {{-3.4, -2.75}, {4.1, 2.35}, 400});
  figure.describe("A turned rectangle, and the closest points of four shapes around it.")
      .box(scene.oriented.center, scene.oriented.angle, scene.oriented.half_extents, Ink::a)
      .segment(scene.segment.start, scene.segment.end, Ink::b, plot::Stroke::solid, 2.4)
      .circle(scene.circle.center, scene.circle.radius, Ink::b)
      .box(scene.rectangle.center, 0, scene.rectangle.half_extents, Ink::b)
      .dot(scene.point, Ink::b);
  const auto between = [&](const ClosestPoints<double, 2>& found)
  { figure.segment(found.a, found.b, Ink::overlap).dot(found.a, Ink::ink).dot(found.b, Ink::ink); };
  between(closest_points(scene.point, scene.oriented));
  between(closest_points(scene.segment, scene.oriented));
  between(closest_points(scene.circle, scene.oriented));
  between(closest_points(scene.rectangle, scene.oriented));
  figure.label({0, 0}, "turned rectangle", Side::centre, Ink::a)
      .label(scene.point, "point", Side::left, Ink::b)
      .label({-2.2, -1.8}, "segment", Side::below, Ink::b)
      .label(scene.circle.center, "circle", Side::centre, Ink::b)
      .label(scene.rectangle.center, "rectangle", Side::centre, Ink::b);
  return figure;
}

/// The corners of a rectangle that is turned.
inline std::vector<Eigen::Vector2d> corners_of(const OrientedRectangle<double>& rectangle)
{
  const PlaneForm<double> form =
      form_of(rectangle, PlaneView<double>(Vector<double, 2>(0, 0), 1.0));
  return {form.corner.begin(), form.corner.end()};
}

/// Draws the projection of a shape on an axis through `foot`, and the rays of light that make it.
inline void draw_projection(
    plot::Figure2d& figure, const std::vector<Eigen::Vector2d>& corners,
    const Eigen::Vector2d& foot, const Eigen::Vector2d& axis, plot::Ink ink)
{
  const auto projection = projection_on<double>(corners, axis);
  const double start = axis.dot(foot);
  for (const double at : {projection.least, projection.most})
  {
    const auto corner = std::find_if(
        corners.begin(), corners.end(),
        [&](const Eigen::Vector2d& one) { return axis.dot(one) == at; });
    figure.segment(*corner, foot + (at - start) * axis, plot::Ink::muted, plot::Stroke::dashed, 1);
  }
  figure.segment(
      foot + (projection.least - start) * axis, foot + (projection.most - start) * axis, ink,
      plot::Stroke::solid, 6);
}

/// Two turned rectangles, and their projections along x and along an axis of one of them.
inline plot::Figure2d projection_figure(bool separated)
{
  using plot::Ink;
  using plot::Side;
  const OrientedRectangle<double> a{{0, 0}, 0.6, {1.2, 0.5}};
  const OrientedRectangle<double> b{
      separated ? Eigen::Vector2d(0.45, 2.1) : Eigen::Vector2d(0.9, 1.1),
      separated ? 0.35 : -0.5,
      {1.1, 0.4}};
  plot::Figure2d figure(
      separated ? "projections_apart" : "projections_overlap",
      separated ? "Apart: the projections on u have a gap" : "Overlap: no axis shows a gap",
      {{-3.3, -2.2}, {2.4, separated ? 3.0 : 2.2}, 400});
  const std::vector<Eigen::Vector2d> of_a = corners_of(a), of_b = corners_of(b);
  const Eigen::Vector2d u(-std::sin(a.angle), std::cos(a.angle)), along(u.y(), -u.x());
  const Eigen::Vector2d foot = -2.1 * along - 0.9 * u, floor(0, -1.95);
  figure.segment({-1.6, -1.95}, {2.2, -1.95}, Ink::muted, plot::Stroke::solid, 1)
      .segment(foot - 0.2 * u, foot + 3.6 * u, Ink::muted, plot::Stroke::solid, 1);
  draw_projection(figure, of_a, floor, {1, 0}, Ink::a);
  draw_projection(figure, of_b, floor + Eigen::Vector2d(0, 0.12), {1, 0}, Ink::b);
  draw_projection(figure, of_a, foot, u, Ink::a);
  draw_projection(figure, of_b, foot - (separated ? 0 : 0.12) * along, u, Ink::b);
  figure.polygon(of_a, Ink::a)
      .polygon(of_b, Ink::b)
      .label({2.25, -1.95}, "x", Side::right, Ink::muted)
      .label(foot + 3.6 * u, "u", Side::above, Ink::muted)
      .label(a.center, "A", Side::centre, Ink::a)
      .label(b.center, "B", Side::centre, Ink::b);
  if (separated)
  {
    const double end = projection_on<double>(of_a, u).most - u.dot(foot);
    const double start = projection_on<double>(of_b, u).least - u.dot(foot);
    figure.dimension(foot + end * u, foot + start * u, "gap", 14);
  }
  return figure;
}

/// Both projection figures, one above the other.
inline plot::Grid projection_figures()
{
  plot::Grid grid("in_the_plane_projections", "", 1);
  grid.describe("Projections of two rectangles on two axes: with a gap between them, and without.");
  grid.add(projection_figure(true)).add(projection_figure(false));
  return grid;
}

/// A ray through the two slabs of a rectangle: it enters where the later of two entries is.
inline plot::Figure2d slab_figure()
{
  using plot::Ink;
  using plot::Side;
  const Rectangle<double> box{{3, 1.5}, {1.25, 0.75}};
  const Ray2<double> ray{{0, -0.35}, {2, 0.8}};
  plot::Figure2d figure("in_the_plane_slabs", "", {{-0.6, -0.8}, {5.9, 2.7}, 400});
  figure.describe("A ray enters the slab between two upright lines, then the one between two level "
                  "ones, and with it the rectangle.");
  for (const double side : {-1.0, 1.0})
  {
    const double x = box.center.x() + side * box.half_extents.x();
    const double y = box.center.y() + side * box.half_extents.y();
    figure.segment({x, -0.7}, {x, 2.6}, Ink::muted, plot::Stroke::dashed, 1)
        .segment({-0.5, y}, {5.7, y}, Ink::muted, plot::Stroke::dashed, 1);
  }
  const auto hit = cast(ray, box);
  figure.box(box.center, 0, box.half_extents, Ink::b)
      .arrow(ray.origin, ray.origin + 2.75 * ray.direction, Ink::a);
  const double enters_x = 1.75 / 2, leaves_x = 4.25 / 2;
  figure.dot(ray.origin + enters_x * ray.direction, Ink::a, "enters x", Side::above_left)
      .dot(ray.origin + leaves_x * ray.direction, Ink::a, "leaves x", Side::below_right)
      .point(hit->point, Ink::ink, "enters y", Side::above_left)
      .arrow(hit->point, hit->point + 0.6 * hit->normal, Ink::ink, "n", Side::right)
      .dot(ray.origin, Ink::a, "o", Side::below);
  return figure;
}

} // namespace cookbook
