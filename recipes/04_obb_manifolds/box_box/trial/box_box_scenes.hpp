#pragma once

/// \file
/// \brief The scenes of box_box's program: the ways in which two boxes meet.

#include "04_obb_manifolds/face_clipping/trial/face_clipping_scenes.hpp"

#include <cmath>
#include <vector>

namespace cookbook
{

/// Two boxes that meet in seven ways, and two that do not; all but the last are drawn.
inline std::vector<BoxScene> box_box_scenes()
{
  const double eighth_turn = std::atan(1.0), corner_turn = std::atan(std::sqrt(2.0));
  const Obb<double> slab = upright({0, 0, 0}, {1, 0.3, 1});
  const Vector3<double> cube(0.5, 0.5, 0.5);
  const Obb<double> ridge{{0, 0, 0}, turned(eighth_turn, {1, 0, 0}), {1.1, 0.5, 0.5}};
  return {
      {"face on face",
       slab,
       {{0, 0.7, 0}, turned(eighth_turn, {0, 1, 0}), {1, 0.5, 1}},
       {0.75, -0.1, -1},
       {0.95, 0.9, -0.45}},
      {"edge on edge",
       ridge,
       {{0.2, std::sqrt(2.0) - 0.15, 0.1}, turned(eighth_turn, {0, 0, 1}), {0.5, 0.5, 1.1}},
       {-0.9, -0.1, -0.4},
       {-0.1, 1.35, -0.3}},
      {"corner on face",
       slab,
       {{0.2, 0.15 + std::sqrt(0.75), 0.1}, turned(corner_turn, {-1, 0, 1}), cube},
       {0.75, -0.1, -1},
       {0.2, 1.15, 0.1}},
      {"deep",
       upright({0, 0, 0}, {0.9, 0.6, 0.9}),
       upright({0, 0.5, 0.2}, {0.25, 0.25, 0.25}),
       {0.7, 0, -0.9},
       {-0.32, 0.75, -0.1}},
      {"thin plates",
       upright({0, 0, 0}, {1, 0.03, 1}),
       {{0.2, 0.05, 0.1}, turned(0.5, {0, 1, 0}), {0.9, 0.03, 0.6}},
       {-0.8, 0.03, 0.8},
       {0.4, 0.08, 0.2},
       0.9},
      {"touching",
       upright({0, 0, 0}, {0.6, 0.6, 0.6}),
       upright({1.1, 0.2, 0}, cube),
       {0, 0, -0.6},
       {1.1, 0.1, -0.5}},
      {"apart", slab, upright({0, 1, 0}, cube), {0, 0, 0}, {0, 1, 0}}};
}

} // namespace cookbook
