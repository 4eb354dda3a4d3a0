/// \file
/// \brief One ray at four shapes.

// [example]
#include "02_primitives/plain_casts/plain_casts.hpp"

#include <iostream>

using namespace cookbook;

int main()
{
  using V = Vector3<double>;
  const Ray<double> ray{{0, 3, 0}, {4, -3, 0}};
  const auto t_of = [](std::optional<double> t) { return t.value_or(-1); }; // -1: a miss
  std::cout << "plane: " << t_of(ray_plane(ray, {{0, 1, 0}, 0})) << '\n'
            << "sphere: " << t_of(ray_sphere(ray, {{4, 0, 0}, 2})) << '\n'
            << "box: " << t_of(ray_box(ray, {V(2, 0, -1), V(4, 2, 1)})) << '\n'
            << "triangle: " << t_of(ray_triangle(ray, {{2, 0, -1}, {2, 4, -1}, {2, 0, 3}})) << '\n'
            << "behind: " << t_of(ray_sphere(ray, {{-4, 6, 0}, 2})) << '\n';
}
// [example]
