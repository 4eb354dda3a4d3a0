#pragma once

/// \file
/// \brief A picture of a cloth, its cells shaded by how they stand in the light.

#include "07_constraints/cloth/cloth.hpp"
#include "07_constraints/cloth/trial/seen_cells.hpp"
#include "common/math/trigonometry.hpp"
#include "tools/plot/annotate.hpp"
#include "tools/plot/panel.hpp"
#include "tools/plot/svg.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

/// A cloth and the spheres and boxes below it; `panel` is what a plot::Grid asks for.
class ShadedCloth
{
public:
  ShadedCloth(Cloth cloth, Obstacles obstacles, ClothView view)
      : cloth_(std::move(cloth)), obstacles_(std::move(obstacles)), view_(std::move(view))
  {
    const SineCosine<double> yaw = sine_cosine(view_.yaw), pitch = sine_cosine(view_.pitch);
    to_camera_ << yaw.cosine, 0, -yaw.sine,                             //
        -yaw.sine * pitch.sine, pitch.cosine, -yaw.cosine * pitch.sine, //
        yaw.sine * pitch.cosine, pitch.sine, yaw.cosine * pitch.cosine;
  }

  /// The picture without its document.
  plot::Panel panel(const std::string&) const
  {
    plot::Sketch sketch;
    const double top = plot::title_height(view_.title, view_.width);
    plot::write_title(sketch, view_.title, view_.width);
    std::vector<SeenCell> cells = seen_cells(top);
    std::stable_sort(
        cells.begin(), cells.end(),
        [](const SeenCell& a, const SeenCell& b) { return a.nearness < b.nearness; });
    draw_cells(sketch, cells, false);
    draw_obstacles(sketch, top);
    draw_cells(sketch, cells, true);
    const std::vector<plot::Rect> labels =
        plot::write_labels(sketch, {0, 0, view_.width, view_.height + top});
    return {view_.width, view_.height + top, view_.title, view_.description, sketch.body, labels};
  }

  /// The picture on its own.
  std::string svg(const std::string& name) const { return plot::document(name, panel(name)); }

private:
  Eigen::Vector3d camera(const Vector3<double>& x) const { return to_camera_ * (x - view_.center); }

  Eigen::Vector2d pixel(const Vector3<double>& x, double top) const
  {
    const Eigen::Vector3d at = camera(x) * (view_.width / view_.meters);
    return {view_.width / 2 + at.x(), top + view_.height / 2 - at.y()};
  }

  /// Whether a point is on the side of all obstacles that is seen.
  bool is_over(const Vector3<double>& x) const
  {
    const Vector3<double> view = to_camera_.row(2);
    bool over = true;
    const Sphere<double> wide{x, 1e3};
    const auto look = [&](const auto& contact) { over = over && contact->normal.dot(view) < 0; };
    for (const Sphere<double>& sphere : obstacles_.spheres)
    {
      look(plain_sphere_sphere(wide, sphere));
    }
    for (const Capsule<double>& capsule : obstacles_.capsules)
    {
      look(plain_sphere_capsule(wide, capsule));
    }
    for (const Obb<double>& box : obstacles_.boxes)
    {
      look(plain_sphere_box(wide, box));
    }
    return over;
  }

  /// The mean normal, not of length one, of the cells around a particle.
  std::vector<Vector3<double>> normals() const
  {
    const auto& x = cloth_.particles.positions;
    std::vector<Vector3<double>> sums(x.size(), Vector3<double>(0, 0, 0));
    for (const auto& [a, b, c] : cloth_.triangles)
    {
      const Vector3<double> n = normalize<double>((x[c] - x[a]).cross(x[b] - x[a])).unit;
      sums[a] += n;
      sums[b] += n;
      sums[c] += n;
    }
    return sums;
  }

  std::vector<SeenCell> seen_cells(double top) const
  {
    const Eigen::Vector3d light = view_.light.normalized();
    const std::vector<Vector3<double>> around = normals();
    const auto& x = cloth_.particles.positions;
    std::vector<SeenCell> cells;
    for (std::size_t i = 0; i + cloth_.columns + 1 < x.size(); ++i)
    {
      const std::size_t below = i + cloth_.columns;
      if (i % cloth_.columns + 1 == cloth_.columns)
      {
        continue; // the last column
      }
      const Eigen::Vector3d flat = to_camera_ * (x[i + 1] - x[below]).cross(x[below + 1] - x[i]);
      const Vector3<double> sum = around[i] + around[i + 1] + around[below] + around[below + 1];
      const Eigen::Vector3d n = to_camera_ * normalize<double>(sum).unit;
      const double lit = (flat.z() < 0 ? -1 : 1) * n.dot(light);
      const Vector3<double> middle = (x[i] + x[i + 1] + x[below] + x[below + 1]) / 4;
      cells.push_back(
          {{pixel(x[i], top), pixel(x[below], top), pixel(x[below + 1], top), pixel(x[i + 1], top)},
           camera(middle).z(),
           std::clamp(0.75 - 0.8 * lit, 0.0, 1.0),
           flat.z() < 0,
           is_over(middle),
           i % cloth_.columns,
           i / cloth_.columns});
    }
    return cells;
  }

  void draw_obstacles(plot::Sketch& sketch, double top) const
  {
    const double scale = view_.width / view_.meters;
    const plot::svg::Pen pen{plot::Ink::muted, plot::Stroke::solid, 1.4};
    for (const Sphere<double>& sphere : obstacles_.spheres)
    {
      const Eigen::Vector2d at = pixel(sphere.center, top);
      sketch.body += plot::svg::circle(at, sphere.radius * scale, pen, plot::Fill::wash);
    }
    for (const Capsule<double>& capsule : obstacles_.capsules)
    {
      const Eigen::Vector2d start = pixel(capsule.segment.start, top);
      const Eigen::Vector2d end = pixel(capsule.segment.end, top);
      sketch.body += plot::svg::line(
          start, end, {plot::Ink::muted, plot::Stroke::solid, 2 * capsule.radius * scale});
    }
    for (const Obb<double>& box : obstacles_.boxes)
    {
      for (int face = 0; face < 6; ++face)
      {
        const Vector3<double> n = box.axes.col(face / 2) * (face % 2 == 0 ? 1.0 : -1.0);
        if (n.dot(Vector3<double>(to_camera_.row(2))) > 0)
        {
          const Vector3<double> u =
              box.axes.col((face / 2 + 1) % 3) * box.half_extents[(face / 2 + 1) % 3];
          const Vector3<double> v =
              box.axes.col((face / 2 + 2) % 3) * box.half_extents[(face / 2 + 2) % 3];
          const Vector3<double> m = box.center + n * box.half_extents[face / 2];
          sketch.body += plot::svg::polygon(
              {pixel(m + u + v, top), pixel(m + u - v, top), pixel(m - u - v, top),
               pixel(m - u + v, top)},
              pen, plot::Fill::wash);
        }
      }
    }
  }

  Cloth cloth_;
  Obstacles obstacles_;
  ClothView view_;
  Matrix3<double> to_camera_;
};

} // namespace cookbook
