/// \file
/// \brief Two spheres to be dragged: their normal, depth and contact point.

#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"
#include "03_sphere_manifolds/sphere_sphere/trial/sphere_sphere_figures.hpp"
#include "tools/live/page.hpp"

namespace cookbook::live
{

void figure(Page& page)
{
  const plot::View view{{-2, -1.6}, {3, 1.6}, page.fit(480)};
  const plot::Figure2d empty("sphere_sphere", "", view);
  const Eigen::Vector2d at = page.handle("B", empty, {1.5, 0}, plot::Ink::b);
  const double radius = page.slider("radius of B", 0.1, 1.5, 1, "m");
  const Sphere<double> a{{0, 0, 0}, 1}, b{{at.x(), at.y(), 0}, radius};

  const std::optional<Manifold<double>> manifold = sphere_sphere(a, b);
  page.number("distance", (b.center - a.center).norm(), "m");
  page.text("spheres", manifold ? "overlap or touch" : "are apart");
  if (manifold)
  {
    page.number("depth", manifold->depth, "m");
    page.number("each moves", penetration_distance(*manifold), "m");
    page.text(
        "normal", "(" + number(manifold->normal.x()) + ", " + number(manifold->normal.y()) + ")");
  }
  page.draw(sphere_sphere_figure(a, b, view).svg());
}

} // namespace cookbook::live
