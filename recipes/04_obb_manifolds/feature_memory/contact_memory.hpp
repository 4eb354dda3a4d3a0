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

/// For the points of this frame what was known of those of the frame before that have the same
/// feature, each point another; `Warm{}` for points that are new.
template <class Warm, class Before, class Known, class Now>
PerPoint<Warm> carried_points(const Before& before, const Known& known, const Now& now)
{
  PerPoint<Warm> carried{};
  for (std::size_t i = 0; i < now.size(); ++i)
  {
    for (std::size_t j = 0; j < before.size(); ++j)
    {
      if (now[i].feature == before[j].feature)
      {
        carried[i] = known[j];
      }
    }
  }
  return carried;
}

/// The same for the points of two manifolds.
template <class Real, class Warm>
PerPoint<Warm>
carried_by_id(const Manifold<Real>& before, const PerPoint<Warm>& warm, const Manifold<Real>& now)
{
  return carried_points<Warm>(before.points, warm, now.points);
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
