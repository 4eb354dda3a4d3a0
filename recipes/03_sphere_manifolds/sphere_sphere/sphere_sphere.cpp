/// \file
/// \brief Brings two unit spheres closer and closer, and draws them where they overlap by half.

#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"
#include "03_sphere_manifolds/manifold/trial/pairs_file.hpp"
#include "common/plot/figures/figure2d.hpp"
#include "common/program/program.hpp"
#include "common/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

const Sphere<double> sphere_a{{0, 0, 0}, 1};

Sphere<double> sphere_b_at(double distance)
{
  return {{distance, 0, 0}, 1};
}

// [print_approach]
void print_approach()
{
  Table table({"distance", "depth", "each moves", "normal x", "contact x"});
  for (const double distance : {2.5, 2.0, 1.9, 1.5, 1.0, 0.5, 0.0})
  {
    const std::optional<Manifold<double>> manifold = sphere_sphere(sphere_a, sphere_b_at(distance));
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
// [print_approach]

Eigen::Vector2d flat(const Vector3<double>& v)
{
  return {v.x(), v.y()};
}

void draw(const Arguments& arguments)
{
  const Sphere<double> b = sphere_b_at(1.5);
  const Manifold<double> manifold = sphere_sphere(sphere_a, b).value();
  const Vector3<double> contact = manifold.points[0].position;
  const Vector3<double> half = manifold.normal * penetration_distance(manifold);
  const Vector3<double> below(0, -1.2, 0);

  plot::Figure2d figure("sphere_sphere", "", {{-1.3, -1.65}, {2.8, 1.25}, 640});
  figure.describe("Two unit spheres, 1.5 apart, with normal, depth and contact point.")
      .circle(flat(sphere_a.center), sphere_a.radius, plot::Ink::a)
      .circle(flat(b.center), b.radius, plot::Ink::b)
      .lens(flat(sphere_a.center), sphere_a.radius, flat(b.center), b.radius)
      .segment(flat(sphere_a.center), flat(b.center), plot::Ink::muted, plot::Stroke::dashed)
      .dot(flat(sphere_a.center), plot::Ink::a, "A", plot::Side::left)
      .dot(flat(b.center), plot::Ink::b, "B", plot::Side::right)
      .segment(flat(contact - half), flat(contact - half + below), plot::Ink::faint)
      .segment(flat(contact + half), flat(contact + half + below), plot::Ink::faint)
      .dimension(
          flat(contact - half + below), flat(contact + half + below),
          "depth " + number(manifold.depth), 0, plot::Ink::overlap)
      .arrow(flat(contact), flat(contact + 0.6 * manifold.normal), plot::Ink::ink, "normal")
      .point(flat(contact), plot::Ink::overlap, "contact point", plot::Side::above);
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
