/// \file
/// \brief A crate on another, turned by 45°: eight contact points, and the four that are kept.

// [example]
#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/contact_reduction/contact_reduction.hpp"
#include <iostream>

int main()
{
  using namespace cookbook;
  const Matrix3<double> straight = Matrix3<double>::Identity();
  Matrix3<double> turned;
  turned << std::sqrt(0.5), 0, std::sqrt(0.5), 0, 1, 0, -std::sqrt(0.5), 0, std::sqrt(0.5);
  const auto all =
      box_box<double>({{0, 0, 0}, straight, {1, 1, 1}}, {{0, 1.9, 0}, turned, {1, 1, 1}});
  std::cout << all->points.size() << " points\n";
  for (const ContactPoint<double>& point : reduced(*all).points)
  {
    std::cout << point.position.transpose() << "\n";
  }
}
// [example]
