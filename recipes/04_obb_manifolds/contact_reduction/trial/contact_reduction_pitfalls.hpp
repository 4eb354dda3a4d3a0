#pragma once

/// \file
/// \brief A way to keep four contact points that is in use and fails: kept to show where.

#include "04_obb_manifolds/contact_reduction/contact_reduction.hpp"

namespace cookbook
{

// [four_deepest]
/// Keeps the four deepest points, wherever they are; of equal ones those that come first.
template <class Real, std::size_t Capacity>
Manifold<Real, most_kept> four_deepest(const Manifold<Real, Capacity>& manifold)
{
  Keeping<Real, Capacity> few = keeping(manifold);
  for (std::size_t i = most_kept; i > 0 && manifold.points.size() > most_kept; --i)
  {
    few.keep(few.tolerance, [](const ContactPoint<Real>& point) { return point.depth; });
  }
  return few.result();
}
// [four_deepest]

} // namespace cookbook
