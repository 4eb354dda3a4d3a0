#pragma once

/// \file
/// \brief Sixteen ways in which two boxes meet, one for each lane of a register.

#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// A pair of boxes by name.
struct Lane
{
  std::string name;    ///< what the boxes do
  BoxPair<float> pair; ///< box A and box B
};

/// A lane of a pair whose numbers are rounded to float.
inline Lane lane(const std::string& name, const Obb<double>& a, const Obb<double>& b)
{
  return {name, {to_float(a), to_float(b)}};
}

/// B on a slab A: from face on face to just touching.
inline std::vector<Lane> lanes_on_a_slab()
{
  const Vector3<double> up(0, 1, 0), along(0, 0, 1), half(0.5, 0.5, 0.5);
  const Obb<double> slab = upright({0, -0.2, 0}, {0.9, 0.2, 0.8});
  const double eighth = std::atan(1.0);
  const Matrix3<double> straight = Matrix3<double>::Identity(), ridge = turned(eighth, along);
  const Matrix3<double> corner = turned(std::atan(std::sqrt(0.5)), {1, 0, 0}) * ridge;
  return {
      lane("face on face", slab, {{0.2, 0.4, 0.1}, straight, half}),
      lane("turned by 45°", slab, {{0, 0.4, 0}, turned(eighth, up), {0.8, 0.5, 0.8}}),
      lane("over a corner", slab, {{0.8, 0.4, 0.7}, turned(0.4, up), half}),
      lane("tilted", slab, {{0, 0.48, 0}, turned(0.06, along), half}),
      lane("edge on face", slab, {{0, 0.6, 0}, ridge, half}),
      lane("corner on face", slab, {{0, 0.75, 0}, corner, half}),
      lane("B below A", slab, {{0.3, -0.8, 0}, straight, half}),
      lane("touching", slab, {{0, 0.5, 0}, straight, half}),
      lane("apart", slab, {{0, 0.7, 0}, straight, half})};
}

/// Sixteen lanes.
inline std::vector<Lane> sixteen_lanes()
{
  const Vector3<double> up(0, 1, 0), along(0, 0, 1), beam(0.4, 0.4, 0.7);
  const double eighth = std::atan(1.0);
  const Matrix3<double> ridge = turned(eighth, along), across = turned(1.2, up) * ridge;
  const Obb<double> cube = upright({0, 0, 0}, {0.5, 0.5, 0.5}), roof{{0, 0, 0}, ridge, beam};
  std::vector<Lane> lanes = lanes_on_a_slab();
  for (const Lane& more : std::vector<Lane>{
           lane("edge on edge", roof, {{0.1, 0.95, 0.1}, across, beam}),
           lane("apart by edges", roof, {{0.1, 1.25, 0.1}, across, beam}),
           lane("side by side", cube, {{0.9, 0.3, 0.2}, turned(0.1, up), cube.half_extents}),
           lane("a plate in a cube", cube, upright({0.05, 0.1, 0}, {0.9, 0.05, 0.8})),
           lane("deep", cube, {{0.15, 0.25, 0.1}, turned(0.7, {1, 2, 3}), cube.half_extents}),
           lane(
               "B inside A", upright({0, 0.1, 0}, {0.8, 0.7, 0.7}),
               {{0.1, 0.3, 0.1}, ridge, {0.2, 0.2, 0.2}}),
           lane("in one place", cube, cube)})
  {
    lanes.push_back(more);
  }
  return lanes;
}

} // namespace cookbook
