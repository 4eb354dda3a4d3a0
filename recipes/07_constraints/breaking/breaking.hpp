#pragma once

/// \file
/// \brief Joints that break where they are pulled too hard, and which have.

#include "06_world/constraints/joint_set.hpp"

#include <cstddef>
#include <vector>

namespace cookbook
{

// [breaking]
/// The joints of a set that have broken, by their numbers; R62.
template <JointKind Kind>
std::vector<std::size_t> broken_joints(const JointSet<Kind>& joints)
{
  std::vector<std::size_t> broken;
  for (std::size_t i = 0; i < joints.size(); ++i)
  {
    if (joints.is_broken(i))
    {
      broken.push_back(i);
    }
  }
  return broken;
}
// [breaking]

} // namespace cookbook
