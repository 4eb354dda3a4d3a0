/// \file
/// \brief Brings two unit spheres closer and closer, and draws them where they overlap by half.

#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"
#include "03_sphere_manifolds/manifold/trial/pairs_file.hpp"
#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

const Sphere<double> sphere_a{{0, 0, 0}, 1};

Sphere<double> sphere_b_at(double distance)
{
  return {{distance, 0, 0}, 1};
}

void print_approach()
{
  Table table({"distance", "depth", "each moves", "normal x", "contact x"});
  for (const double distance : {2.5, 2.0, 1.9, 1.5, 1.0, 0.5, 0.0})
  {
    const std::optional<Manifold<double>> manifold =
        plain_sphere_sphere(sphere_a, sphere_b_at(distance));
    if (!manifold)
    {
      table.row({number(distance), "apart", "", "", ""});
      continue;
    }
    table.row(
        {number(distance), number(manifold->depth), number(penetration_distance(*manifold)),
         number(manifold->normal.x()), number(manifold->points[0].position.x())});
  }
  std::cout << table.text();
}

void draw(const Arguments& arguments)
{
  const Sphere<double> b = sphere_b_at(1.5);
  const Manifold<double> manifold = plain_sphere_sphere(sphere_a, b).value();
  const Eigen::Vector2d center_a = sphere_a.center.head<2>(), center_b = b.center.head<2>();
  const Eigen::Vector2d n = manifold.normal.head<2>();
  const Eigen::Vector2d deepest_a = center_a + sphere_a.radius * n;
  const Eigen::Vector2d deepest_b = center_b - b.radius * n;
  plot::Figure2d figure("sphere_sphere", "", {{-1.1, -1.45}, {2.6, 1.15}, 400});
  figure.describe("Two unit spheres, 1.5 apart, with normal, depth and contact point.")
      .circle(center_a, sphere_a.radius, plot::Ink::a)
      .circle(center_b, b.radius, plot::Ink::b)
      .lens(center_a, sphere_a.radius, center_b, b.radius)
      .dimension(center_a, center_a + Eigen::Vector2d(-0.6, 0.8), "r_{A}", 0, plot::Ink::a)
      .dimension(center_b, center_b + Eigen::Vector2d(0.6, 0.8), "r_{B}", 0, plot::Ink::b)
      .dimension(center_a, center_b, "|t|", 62, plot::Ink::ink)
      .dimension(
          deepest_b, deepest_a, "depth d = " + number(manifold.depth), -130, plot::Ink::overlap)
      .dot(center_a, plot::Ink::a, "A", plot::Side::left)
      .dot(center_b, plot::Ink::b, "B", plot::Side::right)
      .arrow(deepest_a, deepest_a + 0.4 * n, plot::Ink::ink, "n", plot::Side::above)
      .dot(deepest_a, plot::Ink::a, "a", plot::Side::above)
      .dot(deepest_b, plot::Ink::b, "b", plot::Side::above)
      .point(
          manifold.points[0].position.head<2>(), plot::Ink::ink, "contact point",
          plot::Side::below);
  save_figure(arguments, "sphere_sphere.svg", figure.svg());
}

} // namespace

int main(int argc, char** argv)
{
  return run_pairs_program(
      argc, argv,
      {.name = "sphere_sphere",
       .summary = "The manifold of two spheres: normal, depth and contact point.",
       .pairs_header = "ax,ay,az,ar,bx,by,bz,br"},
      [](const PairsRow& row, auto zero)
      {
        using Real = decltype(zero);
        return sphere_sphere(sphere_at<Real>(row, 0), sphere_at<Real>(row, 4));
      },
      [](const Arguments& given)
      {
        print_approach();
        draw(given);
      });
}
