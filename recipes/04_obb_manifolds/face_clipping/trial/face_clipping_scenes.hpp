#pragma once

/// \file
/// \brief The three scenes of face clipping.

#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/box_cases/trial/contacts_figure.hpp"

#include <vector>

namespace cookbook
{

/// A face on a face, a corner on a face, an edge on an edge.
inline std::vector<BoxScene> box_scenes()
{
  const double eighth_turn = std::atan(1.0), corner_turn = std::atan(std::sqrt(2.0));
  const Obb<double> slab = upright({0, 0, 0}, {1.2, 0.3, 1});
  const Matrix3<double> leaning = turned(-0.11, {1, 0, 0.4}) * turned(0.35, {0, 1, 0});
  return {
      {"face on face",
       slab,
       {{0.05, 0.68, 0.15}, leaning, {1.2, 0.45, 0.8}},
       {-0.9, 0, -1},
       {-0.6, 0.9, 0}},
      {"corner on face",
       slab,
       {{0.2, 1.1, 0.1}, turned(corner_turn, {-1, 0, 1}), {0.55, 0.55, 0.55}},
       {-0.9, 0, -1},
       {0.2, 1.5, 0.1}},
      {"edge on edge",
       {{0, 0, 0}, turned(eighth_turn, {1, 0, 0}), {1.2, 0.5, 0.5}},
       {{0.2, 1.25, 0.1},
        turned(-0.4, {0, 1, 0}) * turned(eighth_turn, {0, 0, 1}),
        {0.5, 0.5, 1.2}},
       {-0.9, -0.1, -0.4},
       {-0.15, 1.35, -0.15}}};
}

} // namespace cookbook
