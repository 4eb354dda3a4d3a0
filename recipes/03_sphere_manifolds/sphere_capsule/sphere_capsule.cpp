/// \file
/// \brief Moves a ball along a capsule, and draws the ball of the capsule that it meets.

#include "03_sphere_manifolds/sphere_capsule/sphere_capsule.hpp"
#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

const Capsule<double> capsule{{{-1, 0, 0}, {1, 0, 0}}, 0.5};

Sphere<double> sphere_at(double x)
{
  return {{x, 0.75, 0}, 0.5};
}

void print_flight()
{
  Table table({"ball x", "closest x", "depth", "normal x", "normal y"});
  for (const double x : {-2.0, -1.5, -1.0, 0.0, 0.5, 1.25, 1.75})
  {
    const Vector3<double> closest = closest_point(capsule.segment, sphere_at(x).center);
    const std::optional<Manifold<double>> manifold = plain_sphere_capsule(sphere_at(x), capsule);
    if (!manifold)
    {
      table.row({number(x), number(closest.x()), "apart", "", ""});
      continue;
    }
    table.row(
        {number(x), number(closest.x()), number(manifold->depth), number(manifold->normal.x()),
         number(manifold->normal.y())});
  }
  std::cout << table.text();
}

void draw_sphere(plot::Figure2d& figure, double x)
{
  const Sphere<double> sphere = sphere_at(x);
  const Manifold<double> manifold = plain_sphere_capsule(sphere, capsule).value();
  const Eigen::Vector2d closest = closest_point(capsule.segment, sphere.center).head<2>();
  const Eigen::Vector2d contact = manifold.points[0].position.head<2>();
  const Eigen::Vector2d center = sphere.center.head<2>();
  const Eigen::Vector2d normal = manifold.normal.head<2>();
  const double half = penetration_distance(manifold);
  figure.circle(closest, capsule.radius, plot::Ink::b, plot::Fill::none, plot::Stroke::dashed)
      .circle(center, sphere.radius, plot::Ink::a)
      .lens(center, sphere.radius, closest, capsule.radius)
      .segment(center, closest, plot::Ink::muted, plot::Stroke::dotted)
      .arrow(closest, closest + 0.4 * normal, plot::Ink::ink, "n", plot::Side::right)
      .dimension(contact - half * normal, contact + half * normal, "d", -55)
      .dot(center, plot::Ink::a, "c", plot::Side::right)
      .dot(closest, plot::Ink::b, "q", plot::Side::left)
      .point(contact);
}

void draw(const Arguments& arguments)
{
  plot::Figure2d figure("sphere_capsule", "", {{-1.6, -0.6}, {1.9, 1.35}, 400});
  figure.describe("Two balls on a capsule; each meets the ball of the capsule closest to it.")
      .capsule(
          capsule.segment.start.head<2>(), capsule.segment.end.head<2>(), capsule.radius,
          plot::Ink::b)
      .segment(
          capsule.segment.start.head<2>(), capsule.segment.end.head<2>(), plot::Ink::b,
          plot::Stroke::dashed);
  draw_sphere(figure, -0.5);
  draw_sphere(figure, 1.25);
  figure.label({-0.5, 1.05}, "A", plot::Side::centre, plot::Ink::a)
      .label({1.25, 1.05}, "A", plot::Side::centre, plot::Ink::a)
      .label({0.25, -0.3}, "B", plot::Side::centre, plot::Ink::b);
  save_figure(arguments, "sphere_capsule.svg", figure.svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "sphere_capsule", .summary = "The manifold of a sphere and a capsule."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_flight();
        draw(given);
      });
}
