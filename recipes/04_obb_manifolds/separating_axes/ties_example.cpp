/// \file
/// \brief Flush cubes in float, turned together: whichever way, the same axis decides.

// [example]
#include "04_obb_manifolds/separating_axes/separating_axes.hpp"
#include <iostream>

int main()
{
  using namespace cookbook;
  const Vector3<float> about = Vector3<float>(1, 2, 2) / 3, one(1, 1, 1);
  for (const float angle : {0.0f, 0.3f, 1.0f, 2.0f})
  {
    const Matrix3<float> turn = Eigen::AngleAxisf(angle, about).toRotationMatrix();
    const Vector3<float> above = turn * Vector3<float>(0, 1.9f, 0);
    const auto least = separating_axes<float>({{0, 0, 0}, turn, one}, {above, turn, one});
    std::cout << "turned by " << angle << ": axis " << least->axis << "\n";
  }
}
// [example]
