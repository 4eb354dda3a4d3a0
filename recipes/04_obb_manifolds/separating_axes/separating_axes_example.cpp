/// \file
/// \brief Two bars that cross, ridge into ridge.

// [example]
#include "04_obb_manifolds/separating_axes/separating_axes.hpp"

#include <iostream>

int main()
{
  const double quarter = std::acos(0.0) / 2;
  const Eigen::AngleAxisd about_x(quarter, Eigen::Vector3d::UnitX());
  const Eigen::AngleAxisd about_z(quarter, Eigen::Vector3d::UnitZ());
  const cookbook::Obb<double> a{{0, 0, 0}, about_x.toRotationMatrix(), {2, 0.5, 0.5}};
  const cookbook::Obb<double> b{{0.3, 1.3, 0.1}, about_z.toRotationMatrix(), {0.5, 0.5, 2}};
  if (const auto least = cookbook::separating_axes(a, b))
  {
    std::cout.precision(4);
    std::cout << "axis " << least->axis << ", depth " << least->depth << " m\n";
    std::cout << "normal y " << least->normal.y() << '\n';
  }
}
// [example]
