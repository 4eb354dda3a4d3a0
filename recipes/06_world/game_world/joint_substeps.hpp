#pragma once

/// \file
/// \brief In how many substeps an island with joints is solved directly.

#include "06_world/constraints/taut_pull.hpp"

#include <algorithm>
#include <cmath>

namespace cookbook
{

// [joint_substeps]
/// How an island with joints is solved directly; R63.
struct JointSubsteps
{
  int fewest = 6;                            ///< in a frame
  int most = 16;                             ///< where joints are taut
  double squared_swing = most_squared_swing; ///< [1], above which joints swing bodies implicitly
};

/// How many substeps a step takes in which joints swing a body by so many radians.
inline int substeps_of(const JointSubsteps& joints, double swing)
{
  const double asked = std::ceil(swing / std::sqrt(most_squared_swing));
  return static_cast<int>(
      std::clamp<double>(asked, joints.fewest, std::max(joints.fewest, joints.most)));
}
// [joint_substeps]

} // namespace cookbook
