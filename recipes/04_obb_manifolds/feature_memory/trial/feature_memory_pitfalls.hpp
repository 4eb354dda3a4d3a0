#pragma once

/// \file
/// \brief A way to know contact points again that is in use and fails: kept to show where.

#include "04_obb_manifolds/feature_memory/feature_memory.hpp"

namespace cookbook
{

// [carried_by_index]
/// Takes the first point of a frame for the first of the frame before, and so on.
template <class Real, class Warm>
PerPoint<Warm> carried_by_index(
    const Manifold<Real>& before, const PerPoint<Warm>& warm, const Manifold<Real>& now)
{
  PerPoint<Warm> carried{};
  for (std::size_t i = 0; i < std::min(before.points.size(), now.points.size()); ++i)
  {
    carried[i] = warm[i];
  }
  return carried;
}
// [carried_by_index]

} // namespace cookbook
