/// \file
/// \brief A crate on the edge of a table.

// [example]
#include "04_obb_manifolds/plain_box_box/plain_box_box.hpp"

#include <iostream>

int main()
{
  const Eigen::AngleAxisd tilt(0.1, Eigen::Vector3d::UnitZ());
  const cookbook::Obb<double> table{{0, 0, 0}, Eigen::Matrix3d::Identity(), {1, 0.5, 1}};
  const cookbook::Obb<double> crate{{0.7, 0.98, 0}, tilt.toRotationMatrix(), {0.5, 0.5, 0.5}};
  if (const auto manifold = cookbook::plain_box_box(table, crate))
  {
    std::cout.precision(4);
    std::cout << "normal " << manifold->normal.transpose() << ", depth " << manifold->depth << '\n';
    for (const auto& [position, depth, feature] : manifold->points)
    {
      std::cout << "point " << position.transpose() << ", depth " << depth << ", id " << feature
                << '\n';
    }
  }
}
// [example]
