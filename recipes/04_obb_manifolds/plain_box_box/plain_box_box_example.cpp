#include "04_obb_manifolds/plain_box_box/plain_box_box.hpp"

#include <cstdio>

int main()
{
  const Eigen::AngleAxisd tilt(0.1, Eigen::Vector3d::UnitZ());
  const cookbook::Obb<double> table{{0, 0, 0}, Eigen::Matrix3d::Identity(), {1, 0.5, 1}};
  const cookbook::Obb<double> crate{{0.7, 0.98, 0}, tilt.toRotationMatrix(), {0.5, 0.5, 0.5}};
  if (const auto manifold = cookbook::plain_box_box(table, crate))
  {
    const Eigen::Vector3d& n = manifold->normal;
    std::printf("normal %g %g %g, depth %.4f m\n", n.x(), n.y(), n.z(), manifold->depth);
    for (const auto& [position, depth, feature] : manifold->points)
    {
      std::printf("point %.4f %.4f %4.1f, ", position.x(), position.y(), position.z());
      std::printf("depth %.4f m, feature %u\n", depth, feature);
    }
  }
}
