/// \file
/// \brief How far points are from a box.

// [example]
#include "02_primitives/closest_point_box/closest_point_box.hpp"

#include <iostream>

using namespace cookbook;

int main()
{
  const Obb<double> box{{0, 0, 0}, Matrix3<double>::Identity(), {2, 1, 1}};
  const auto print = [&](const Vector3<double>& p)
  {
    const Vector3<double> q = box_coordinates(box, p);
    const Direction<double> out = signed_distance_box(q, box.half_extents);
    std::cout << "distance " << signed_distance(box, p) << ", out along "
              << (box.axes * out.unit).transpose() << '\n';
  };
  print({5, 5, 0});
  print({1.5, 0.25, 0});
}
// [example]
