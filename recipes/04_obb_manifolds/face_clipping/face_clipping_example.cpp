/// \file
/// \brief A cube on a cube, tilted by a ten-thousandth: the least overlap, and a face preferred.

// [example]
#include "04_obb_manifolds/face_clipping/face_clipping.hpp"
#include "04_obb_manifolds/plain_box_box/plain_box_box.hpp"

#include <iostream>

int main()
{
  const Eigen::AngleAxisd tilt(1e-4, Eigen::Vector3d(1, 5, 2).normalized());
  const Eigen::Vector3d half(0.5, 0.5, 0.5);
  const cookbook::Obb<double> below{{0, 0, 0}, Eigen::Matrix3d::Identity(), half};
  const cookbook::Obb<double> above{{0, 0.999, 0}, tilt.toRotationMatrix(), half};
  const auto exact = cookbook::face_clipping(below, above);
  const auto preferred = cookbook::plain_box_box(below, above);
  std::cout.precision(6);
  std::cout << "least overlap: " << exact->depth << " m, " << exact->points.size() << " point\n";
  std::cout << "face preferred: " << preferred->depth << " m, " << preferred->points.size();
  std::cout << " points\n";
}
// [example]
