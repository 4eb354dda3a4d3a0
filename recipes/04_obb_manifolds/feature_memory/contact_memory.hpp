#pragma once

/// \file
/// \brief What is known of a contact from one frame to the next.

#include "03_sphere_manifolds/manifold/manifold.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace cookbook
{

// [feature_id]
/// The axis, 0 … 14, that the manifold of a contact point was built on; part of its feature, O17.
inline int axis_of_feature(std::uint32_t feature)
{
  return static_cast<int>(feature / 64);
}

/// The axis that a manifold was built on; −1 if there is none.
template <class Real>
int axis_of(const std::optional<Manifold<Real>>& manifold)
{
  return manifold ? axis_of_feature(manifold->points[0].feature) : -1;
}

/// For each point of a manifold what belongs to it.
template <class Warm>
using PerPoint = std::array<Warm, 8>;

/// The place of the point that has a feature, among points of which each has another; how many
/// there are if none has it.
template <class Points>
std::size_t find_feature(const Points& points, std::uint32_t feature)
{
  std::size_t i = 0;
  while (i < points.size() && points[i].feature != feature)
  {
    ++i;
  }
  return i;
}

/// What was known of the points of the frame before, for the points of this one that have the same
/// feature; `Warm{}` for points that are new.
template <class Real, class Warm>
PerPoint<Warm>
carried_by_id(const Manifold<Real>& before, const PerPoint<Warm>& warm, const Manifold<Real>& now)
{
  PerPoint<Warm> carried{};
  for (std::size_t i = 0; i < now.points.size(); ++i)
  {
    const std::size_t known = find_feature(before.points, now.points[i].feature);
    if (known < before.points.size())
    {
      carried[i] = warm[known];
    }
  }
  return carried;
}
// [feature_id]

// [contact_memory]
/// What is known of two boxes from one frame to the next.
template <class Real, class Warm>
struct ContactMemory
{
  std::optional<Manifold<Real>> manifold; ///< nothing where they are apart
  PerPoint<Warm> warm;                    ///< of each point, such as the impulse it has taken up
};
// [contact_memory]

} // namespace cookbook
