/// \file
/// \brief Brings two unit spheres closer and closer, and draws them where they overlap by half.

#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"
#include "03_sphere_manifolds/manifold/trial/pairs_file.hpp"
#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "03_sphere_manifolds/sphere_sphere/trial/sphere_sphere_figures.hpp"
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
  save_figure(
      arguments, "sphere_sphere.svg", sphere_sphere_figure(sphere_a, sphere_b_at(1.5)).svg());
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
