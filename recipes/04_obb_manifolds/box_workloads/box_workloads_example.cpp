/// \file
/// \brief How often do two methods disagree on boxes that rest on each other?

// [example]
#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"
#include "04_obb_manifolds/face_clipping/face_clipping.hpp"
#include <iostream>

int main()
{
  using namespace cookbook;
  int fewer = 0, shallower = 0;
  for (const auto& [a, b] : box_workload("resting", 1000).pairs)
  {
    const auto steady = box_box(a, b), least = face_clipping(a, b);
    fewer += steady && least && least->points.size() < steady->points.size() ? 1 : 0;
    shallower += steady && least && least->depth < 0.95f * steady->depth ? 1 : 0;
  }
  std::cout << "face_clipping has fewer points than box_box: " << fewer << " of 1000\n"
            << "and less than 95 % of its depth: " << shallower << "\n";
}
// [example]
