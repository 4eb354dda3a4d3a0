#pragma once

/// \file
/// \brief All pairs of boxes of the table of failing cases: sizes, places and published faults too.

#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/box_cases/trial/box_size_cases.hpp"
#include "04_obb_manifolds/gjk_epa/trial/gjk_epa_box_cases.hpp"
#include "common/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

// [fault_cases]
/// Cases of the published faults that show most on other boxes than those of the rows above.
inline std::vector<BoxCase> fault_cases()
{
  const Vector3<double> one(1, 1, 1), up(0, 1, 0), tiny(0.004, 0.004, 0.004);
  const Obb<double> cube = upright({0, 0, 0}, one), above = upright({0, 1.9, 0}, one);
  const Matrix3<double> anyhow = rational_rotation<double>(1, 2, 3, 3);
  std::vector<Vector3<double>> turned_contacts;
  for (const Vector3<double>& corner : rectangle(1, 0.95, 1))
  {
    turned_contacts.push_back(anyhow * corner);
  }
  BoxCase small{
      "X16",
      "two cubes of 8 mm",
      upright({0, 0, 0}, tiny),
      upright({0, 0.0076, 0}, tiny),
      0.0004,
      up,
      rectangle(0.004, 0.0038, 0.004)};
  small.tolerance = 4e-9;
  BoxCase features{
      "X17",
      "two cubes, one shifted; which features meet",
      cube,
      upright({0.3, 1.9, 0.2}, one),
      0.1,
      up,
      {{1, 0.95, 1}, {1, 0.95, -0.8}, {-0.7, 0.95, 1}, {-0.7, 0.95, -0.8}}};
  features.features = true;
  const Matrix3<double> corner_up = turned(std::atan(1.0), {-1, 1, 0});
  return {
      {"X08",
       "the cubes of G1, B named A",
       {{2.25, 2.25, 0}, corner_up, one},
       cube,
       -1,
       {0, 0, 0},
       {}},
      {"X10", "two cubes 100 m apart", cube, upright({60, 0, 80}, one), -1, {0, 0, 0}, {}},
      {"X11", "a plate through a cube", upright({0, 0.5, 0}, one), upright({0, 0, 0}, {5, 0.1, 5}),
       0.6, -up, rectangle(1, -0.2, 1)},
      {"X12", "a post through a slab, its foot below", upright({0, 0, 0}, {2, 0.5, 2}),
       upright({0, 0.4, 0}, {0.5, 1, 0.5}), 1.1, up, rectangle(0.5, -0.05, 0.5)},
      {"X13",
       "a cube that touches a block's side",
       upright({0, 0, 0}, {1, 2, 3}),
       upright({2, 0, 0}, one),
       0,
       {1, 0, 0},
       {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}}},
      {"X15", "two cubes, one on the other, turned anyhow", placed(cube, anyhow),
       placed(above, anyhow), 0.1, anyhow.col(1), turned_contacts},
      small,
      features};
}

/// Two long bars, ridge on ridge, that cross at 1.5°, turned anyhow; `depth` [m] is negative for a
/// gap.
inline BoxCase bars_case(double depth)
{
  const double eighth = std::atan(1.0), height = std::sqrt(8.0) - depth;
  const Matrix3<double> ridge = turned(eighth, {1, 0, 0}), yaw = turned(eighth / 30, {0, 1, 0});
  const Matrix3<double> anyhow = rational_rotation<double>(1, 2, 3, 3);
  const Vector3<double> half(10, 1, 1);
  BoxCase pair{
      "X14-b",
      "the same, apart",
      placed({{0, 0, 0}, ridge, half}, anyhow),
      placed({{0, height, 0}, yaw * ridge, half}, anyhow),
      depth,
      {0, 0, 0},
      {}};
  if (depth >= 0)
  {
    pair.id = "X14";
    pair.scene = "two long bars, ridge on ridge at 1.5°";
    pair.normal = anyhow.col(1);
    pair.contacts = {anyhow * Vector3<double>(0, height / 2, 0)};
  }
  return pair;
}
// [fault_cases]

/// All pairs, in the order of their ids.
inline std::vector<BoxCase> all_box_cases()
{
  std::vector<BoxCase> cases = box_cases();
  for (const std::vector<BoxCase>& more :
       {size_cases(), level_cases(), fault_cases(),
        std::vector<BoxCase>{bars_case(0.01), bars_case(-0.01)}})
  {
    cases.insert(cases.end(), more.begin(), more.end());
  }
  const auto earlier = [](const BoxCase& a, const BoxCase& b)
  {
    const auto key = [](const std::string& id)
    { return std::pair(id[0], std::stoi(id.substr(1))); };
    return key(a.id) < key(b.id);
  };
  std::stable_sort(cases.begin(), cases.end(), earlier);
  return cases;
}

} // namespace cookbook
