#pragma once

/// \file
/// \brief The figure of edge functions: a triangle on a grid of pixels.

#include "02_primitives/plain_picture/plain_picture.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// The square of a pixel, as a figure with y up has it.
inline std::vector<Eigen::Vector2d> square(double x, double y)
{
  return {{x, -y}, {x + 1, -y}, {x + 1, -y - 1}, {x, -y - 1}};
}

/// A triangle in a picture, y down, and a pixel at which its edge functions are asked.
struct EdgesScene
{
  Vector2<double> a{2.2, 8.6};  ///< [pixels]
  Vector2<double> b{6.6, 0.7};  ///< [pixels]
  Vector2<double> c{14.3, 7.2}; ///< [pixels]
  Vector2<double> p{12.5, 3.5}; ///< [pixels] a centre
  bool either_order = false;    ///< whether corners that turn the other way make a triangle too

  /// The edge functions of a to b, b to c and c to a at a point.
  Vector3<double> functions(const Vector2<double>& at) const
  {
    return {edge_function(a, b, at), edge_function(b, c, at), edge_function(c, a, at)};
  }

  /// Whether a centre is in the triangle.
  bool covers(const Vector2<double>& at) const
  {
    const Vector3<double> e = functions(at);
    return e.minCoeff() > 0 || (either_order && e.maxCoeff() < 0);
  }
};

/// The part of the picture that the figure of edge functions shows, 16 by 10 pixels, y up.
inline plot::View edges_view(double width)
{
  return {{-0.6, -10.4}, {16.6, 0.9}, width};
}

/// A triangle on a grid of pixels: those whose centres it covers.
inline plot::Figure2d edges_figure(const EdgesScene& scene, double width)
{
  plot::Figure2d figure("picture_edges", "", edges_view(width));
  figure.describe("A triangle on a grid of pixels; the pixels whose centres are inside are blue.");
  for (int i = 0; i < 160; ++i)
  {
    const double x = i % 16, y = std::floor(i / 16.0);
    if (scene.covers({x + 0.5, y + 0.5}))
    {
      figure.region(square(x, y), plot::Ink::a);
    }
    figure.polygon(square(x, y), plot::Ink::faint, plot::Fill::none);
  }
  const auto up = [](const Vector2<double>& p) { return Eigen::Vector2d(p.x(), -p.y()); };
  figure.arrow(up(scene.a), up(scene.b), plot::Ink::ink)
      .arrow(up(scene.b), up(scene.c), plot::Ink::ink)
      .arrow(up(scene.c), up(scene.a), plot::Ink::ink);
  const Vector2<double> middle = (scene.a + scene.b + scene.c) / 3;
  const auto outside = [&](const Vector2<double>& corner)
  {
    const Vector2<double> out = corner - middle;
    return up(corner + 0.9 / std::max(out.norm(), 0.9) * out);
  };
  figure.label(outside(scene.a), "a", plot::Side::centre)
      .label(outside(scene.b), "b", plot::Side::centre)
      .label(outside(scene.c), "c", plot::Side::centre);
  const Vector3<double> e = scene.functions(scene.p);
  const auto whole = [](double x) { return std::to_string(std::lround(x)); };
  figure.point(
      up(scene.p), plot::Ink::overlap, whole(e.x()) + ", " + whole(e.y()) + ", " + whole(e.z()));
  return figure;
}

} // namespace cookbook
