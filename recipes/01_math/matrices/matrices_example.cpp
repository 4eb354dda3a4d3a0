/// \file
/// Determinant and inverse, as a page shows them.

// [example]
#include "01_math/matrices/cofactors.hpp"

#include <cstdio>

int main()
{
  using namespace cookbook;
  Matrix3<double> m; // stretches x by two, and shears y along it
  m << 2, 1, 0,      //
      0, 1, 0,       //
      0, 0, 1;
  const Matrix3<double> inverse = adjugate_inverse<double, 3>(m);
  const Vector3<double> v(3, 1, 5), there = m * v, back = inverse * there;
  std::printf("volume of the unit cube's image: %.1f\n", m.determinant());
  std::printf("there: (%.1f, %.1f, %.1f)\n", there.x(), there.y(), there.z());
  std::printf("back:  (%.1f, %.1f, %.1f)\n", back.x(), back.y(), back.z());
}
// [example]
