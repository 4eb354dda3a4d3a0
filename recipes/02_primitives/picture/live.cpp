/// \file
/// \brief A triangle to be dragged over a grid of pixels: its edge functions, and what it covers.

#include "02_primitives/picture/trial/edges_figure.hpp"
#include "tools/live/page.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
#include <cmath>

namespace cookbook::live
{

namespace
{

/// The point of a picture that a handle stands at; the figure has y up.
Vector2<double>
dragged(Page& page, const std::string& name, const Vector2<double>& start, plot::Ink ink)
{
  const plot::Figure2d empty("picture_edges", "", edges_view(page.fit(480)));
  const Eigen::Vector2d at = page.handle(name, empty, {start.x(), -start.y()}, ink);
  return {at.x(), -at.y()};
}

/// The centre of the pixel of the figure's picture that is closest to a point.
Vector2<double> centre_near(const Vector2<double>& p)
{
  const auto pixel = [](double x, double last)
  { return std::min(std::max(std::floor(x), 0.0), last); };
  return {pixel(p.x(), 15) + 0.5, pixel(p.y(), 9) + 0.5};
}

} // namespace

void figure(Page& page)
{
  EdgesScene scene;
  scene.a = dragged(page, "a", scene.a, plot::Ink::ink);
  scene.b = dragged(page, "b", scene.b, plot::Ink::ink);
  scene.c = dragged(page, "c", scene.c, plot::Ink::ink);
  scene.p = centre_near(dragged(page, "pixel", scene.p, plot::Ink::overlap));
  scene.either_order = page.choice("corners", {"clockwise", "in either order"}) == 1;

  const Vector3<double> e = scene.functions(scene.p);
  const double area = edge_function(scene.a, scene.b, scene.c);
  page.number("edge a to b", e.x(), "pixels²");
  page.number("edge b to c", e.y(), "pixels²");
  page.number("edge c to a", e.z(), "pixels²");
  if (area != 0)
  {
    page.text(
        "u, v, w",
        number(e.y() / area) + ", " + number(e.z() / area) + ", " + number(e.x() / area));
  }
  page.text("the pixel is", scene.covers(scene.p) ? "covered" : "not covered");
  int covered = 0;
  for (int i = 0; i < 160; ++i)
  {
    covered += scene.covers({i % 16 + 0.5, std::floor(i / 16.0) + 0.5}) ? 1 : 0;
  }
  page.number("pixels covered", covered);
  page.number("area", area / 2, "pixels²");
  page.draw(edges_figure(scene, page.fit(480)).svg());
}

} // namespace cookbook::live
