/// \file
/// \brief Two cubes edge to edge that are apart: fifteen axes see it, six do not.

// [example]
#include "04_obb_manifolds/box_failures/trial/box_pitfalls.hpp"
#include <iostream>

int main()
{
  using namespace cookbook;
  const double s = std::sqrt(0.5);
  Matrix3<double> corner_up; // by 45° about (-1, 1, 0)
  corner_up << 0.5 + s / 2, s / 2 - 0.5, 0.5, s / 2 - 0.5, 0.5 + s / 2, 0.5, -0.5, -0.5, s;
  const Obb<double> a{{0, 0, 0}, Matrix3<double>::Identity(), {1, 1, 1}};
  const Obb<double> b{{2.25, 2.25, 0}, corner_up, {1, 1, 1}};
  std::cout << "fifteen axes: " << (separating_axes(a, b) ? "overlap" : "apart") << "\n";
  if (const auto least = six_axes(a, b))
  {
    std::cout << "six axes: overlap, " << least->depth << " deep\n";
  }
}
// [example]
