/// \file
/// \brief Lowers a ball through the ground, and draws it with its centre below the surface.

#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

const Plane<double> ground{{0, 1, 0}, 0};

Sphere<double> sphere_at(double height)
{
  return {{0, height, 0}, 0.5};
}

void print_descent()
{
  Table table({"height", "depth", "normal y", "contact y"});
  for (const double height : {0.75, 0.5, 0.25, 0.0, -0.25, -1.0})
  {
    const std::optional<Manifold<double>> manifold = plain_sphere_plane(sphere_at(height), ground);
    if (!manifold)
    {
      table.row({number(height), "apart", "", ""});
      continue;
    }
    table.row(
        {number(height), number(manifold->depth), number(manifold->normal.y()),
         number(manifold->points[0].position.y())});
  }
  std::cout << table.text();
}

/// Draws one ball at `x`, moved there only for the picture.
void draw_sphere(plot::Figure2d& figure, double height, double x)
{
  const Sphere<double> sphere = sphere_at(height);
  const Manifold<double> manifold = plain_sphere_plane(sphere, ground).value();
  const Eigen::Vector2d center(x, height);
  const Eigen::Vector2d contact(x, manifold.points[0].position.y());
  const Eigen::Vector2d lowest(x + 0.62, height - sphere.radius);
  figure.circle(center, sphere.radius, plot::Ink::a)
      .dot(center, plot::Ink::a)
      .dimension(lowest, {lowest.x(), 0}, "d = " + number(manifold.depth))
      .segment({x, height - sphere.radius}, lowest, plot::Ink::faint)
      .arrow(
          contact, contact + 0.55 * manifold.normal.head<2>(), plot::Ink::ink, "n",
          plot::Side::left)
      .point(contact);
}

void draw(const Arguments& arguments)
{
  plot::Figure2d figure("sphere_plane", "", {{-0.6, -1.5}, {5.2, 0.95}, 400});
  figure.describe("A ball above, in and below the surface of the ground, with depth and normal.")
      .half_plane({0, 1}, ground.distance);
  draw_sphere(figure, 0.375, 0);
  draw_sphere(figure, 0, 1.95);
  draw_sphere(figure, -0.5, 3.9);
  save_figure(arguments, "sphere_plane.svg", figure.svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "sphere_plane", .summary = "The manifold of a sphere and the solid below a plane."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_descent();
        draw(given);
      });
}
