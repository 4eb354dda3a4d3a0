#pragma once

/// \file
/// \brief What the pictures of contact_reduction are made of: ways to keep four points of an
/// octagon.

#include "04_obb_manifolds/contact_reduction/trial/contact_reduction_pitfalls.hpp"
#include "04_obb_manifolds/contact_reduction/trial/contact_reduction_truth.hpp"
#include "04_obb_manifolds/contact_reduction/trial/contact_support.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/program/table.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// One degree [rad].
inline const double degree = std::atan(1.0) / 45;

/// A number with at most four decimals.
inline std::string cell(double x)
{
  return number(std::round(x * 1e4) * 1e-4);
}

/// A manifold of which four points are kept.
using Few = Manifold<double, most_kept>;

/// A way to keep four points, by its name.
struct Way
{
  std::string name;                     ///< of its function
  Few (*keep)(const Manifold<double>&); ///< what it keeps
};

/// A weight that stands over the octagon, near the rim.
inline const Vector3<double> weight(0.95, 1, -0.4);

/// All ways, the best first.
inline const std::vector<Way> ways = {
    {"best of 70", best_four<8>},
    {"reduced", reduced<double, 8>},
    {"reduced_over the weight",
     [](const Manifold<double>& many) { return reduced_over(many, weight); }},
    {"four_deepest", four_deepest<double, 8>}};

/// Fills what is lost between one kept corner and the next.
inline void draw_lost(plot::Figure2d& figure, const std::vector<Corner>& corners, const Few& few)
{
  const std::size_t count = few.points.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t to = few.points[(i + 1) % count].feature;
    std::vector<Corner> lost{corners[few.points[i].feature]};
    for (std::size_t next = few.points[i].feature; next != to;)
    {
      next = (next + 1) % corners.size();
      lost.push_back(corners[next]);
    }
    figure.region(lost);
  }
}

/// The octagon from above, with what is lost, and the points, with the deepest named.
inline plot::Figure2d octagon_figure(const Way& way)
{
  const Manifold<double> octagon = turned_squares(45 * degree, 1e-3);
  const Few few = way.keep(octagon);
  const std::string title =
      way.name + ": " + cell(area(support(few))) + " of " + cell(area(support(octagon))) + " m²";
  plot::Figure2d figure("contact_reduction", title, {{-1.5, -1.5}, {1.5, 1.5}, 189});
  figure.box({0, 0}, 0, {1, 1}, plot::Ink::a, plot::Fill::none)
      .box({0, 0}, 45 * degree, {1, 1}, plot::Ink::b, plot::Fill::none);
  std::vector<Corner> corners;
  for (const ContactPoint<double>& point : octagon.points)
  {
    corners.push_back({point.position.x(), -point.position.z()});
    figure.dot(corners.back(), plot::Ink::muted);
  }
  draw_lost(figure, corners, few);
  for (const ContactPoint<double>& point : few.points)
  {
    figure.point(corners[point.feature], plot::Ink::ink, point.depth == few.depth ? "deepest" : "");
  }
  return figure.dot({0, 0}, plot::Ink::ink, "middle");
}

/// The area that each way spans while the upper square turns.
inline plot::Chart yaw_chart()
{
  plot::Chart chart(
      "contact_reduction_yaw", "", {"turned by [°]", {}, 0, 90}, {"area spanned [m²]", {}, 0, 4.2});
  chart.describe("Area that all points, four spread points and the four deepest span, over yaw.")
      .size(400, 340);
  const auto line = [&](const std::string& name, std::size_t look, const auto& keep)
  {
    std::vector<Eigen::Vector2d> points;
    for (int yaw = 1; yaw < 90; ++yaw)
    {
      points.push_back({double(yaw), area(support(keep(turned_squares(yaw * degree, 1e-3))))});
    }
    plot::Look shown = plot::series_look(look);
    shown.marker = plot::Marker::none;
    chart.line(name, points, shown);
  };
  line("all 8", 0, [](const Manifold<double>& many) { return many; });
  line(ways[0].name, 1, ways[0].keep);
  line(ways[1].name, 2, ways[1].keep);
  line(ways[3].name, 3, ways[3].keep);
  return chart;
}

} // namespace cookbook
