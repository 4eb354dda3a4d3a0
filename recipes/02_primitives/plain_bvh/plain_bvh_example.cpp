/// \file
/// \brief A ray at a thousand triangles.

// [example]
#include "02_primitives/plain_bvh/plain_bvh.hpp"

#include <iostream>

using namespace cookbook;

int main()
{
  TriangleMesh<double> steps; // 1000 triangles, a metre apart, each at the height of its number
  for (int i = 0; i < 1000; ++i)
  {
    const double h = i;
    steps.vertices.insert(steps.vertices.end(), {{h, h, -1}, {h + 1, h, -1}, {h, h, 1}});
    steps.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const auto bvh = build_bvh(steps);
  const Ray<double> down{{640.25, 2000, 0}, {0, -1, 0}};
  std::cout << "t = " << cast_bvh(down, steps, *bvh).value() << '\n';
}
// [example]
