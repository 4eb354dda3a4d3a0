/// \file
/// \brief Slides a ball into a box and out through its nearest face, and draws the way.

#include "03_sphere_manifolds/sphere_box/sphere_box.hpp"
#include "03_sphere_manifolds/manifold/trial/pairs_file.hpp"
#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "03_sphere_manifolds/sphere_box/trial/sphere_box_figures.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

const Obb<double> box{{0, 0, 0}, Matrix3<double>::Identity(), {2, 1, 1}};

/// The path of the ball: down through the top, along the inside, near the right face.
const Sphere<double> path[] = {{{-2.3, 1.2, 0}, 0.5},   {{-1.2, 1.25, 0}, 0.5},
                               {{-0.5, 0.75, 0}, 0.5},  {{0.4, 0.25, 0}, 0.5},
                               {{1.25, 0.125, 0}, 0.5}, {{2.25, 0, 0}, 0.5}};

void print_path()
{
  Table table({"ball x", "ball y", "depth", "normal x", "normal y", "contact x", "contact y"});
  for (const Sphere<double>& sphere : path)
  {
    const Manifold<double> manifold = plain_sphere_box(sphere, box).value();
    const Vector3<double>& contact = manifold.points[0].position;
    table.row(
        {number(sphere.center.x()), number(sphere.center.y()), number(manifold.depth),
         number(manifold.normal.x()), number(manifold.normal.y()), number(contact.x()),
         number(contact.y())});
  }
  std::cout << table.text();
}

void draw(const Arguments& arguments)
{
  plot::Figure2d figure("sphere_box", "", {{-2.9, -1.1}, {3.1, 2.1}, 400});
  figure.describe("A ball slides into a box; arrows show how each position leaves it.")
      .box(box.center.head<2>(), 0, box.half_extents.head<2>(), plot::Ink::b)
      .label({-1.7, -0.75}, "B", plot::Side::centre, plot::Ink::b)
      .label(
          path[0].center.head<2>() + Eigen::Vector2d(-0.2, 0.1), "A", plot::Side::left,
          plot::Ink::a);
  for (const Sphere<double>& sphere : path)
  {
    add_way_out(
        figure, sphere, plain_sphere_box(sphere, box).value(), &sphere == &path[3] ? "−d n" : "");
  }
  save_figure(arguments, "sphere_box.svg", figure.svg());
}

} // namespace

int main(int argc, char** argv)
{
  return run_pairs_program(
      argc, argv,
      {.name = "sphere_box",
       .summary = "The manifold of a sphere and an oriented box, inside and outside.",
       .pairs_header = "ax,ay,az,ar,bx,by,bz,bqw,bqx,bqy,bqz,bhx,bhy,bhz"},
      [](const PairsRow& row, auto zero)
      {
        using Real = decltype(zero);
        return sphere_box(sphere_at<Real>(row, 0), obb_at<Real>(row, 4));
      },
      [](const Arguments& given)
      {
        print_path();
        draw(given);
      });
}
