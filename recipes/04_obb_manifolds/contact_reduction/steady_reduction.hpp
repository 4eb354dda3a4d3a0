#pragma once

/// \file
/// \brief Keeps the four contact points of the frame before, as long as they are good enough.

#include "04_obb_manifolds/contact_reduction/contact_reduction.hpp"

namespace cookbook
{

// [spread]
/// Twice the area [m²] that up to four points span, seen along the normal.
///
/// It is the product of the two diagonals of a quadrilateral, and which two of the three ways to
/// pair four points they are is told by its being the largest.
template <class Real>
Real doubled_spread(const Manifold<Real, most_kept>& few)
{
  using std::abs;
  const auto& points = few.points;
  if (points.size() < most_kept)
  {
    return Real(0);
  }
  const auto product = [&](std::size_t p, std::size_t q, std::size_t r, std::size_t s)
  {
    const Vector3<Real> first = points[q].position - points[p].position;
    const Vector3<Real> second = points[s].position - points[r].position;
    return abs(few.normal.dot(first.cross(second)));
  };
  return std::max({product(0, 1, 2, 3), product(0, 2, 1, 3), product(0, 3, 1, 2)});
}

/// The depth [m] of the deepest point.
template <class Real>
Real deepest_of(const Manifold<Real, most_kept>& few)
{
  Real deepest = few.points[0].depth;
  for (const ContactPoint<Real>& point : few.points)
  {
    deepest = std::max(deepest, point.depth);
  }
  return deepest;
}
// [spread]

// [steadily_reduced]
/// The points of a manifold that have the features of those kept in the frame before.
template <class Real, std::size_t Capacity>
Manifold<Real, most_kept>
kept_before(const Manifold<Real, Capacity>& manifold, const Manifold<Real, most_kept>& before)
{
  Keeping<Real, Capacity> few = keeping(manifold);
  for (std::size_t i = 0; i < manifold.points.size(); ++i)
  {
    few.kept[i] = std::any_of(
        before.points.begin(), before.points.end(),
        [&](const ContactPoint<Real>& point)
        { return point.feature == manifold.points[i].feature; });
  }
  return few.result();
}

/// As reduced(), but with the points of the frame before as long as all four are there, span three
/// quarters of what new ones would, and leave nothing that is deeper by more than a hundredth of
/// their spread.
///
/// The spread is the root of twice the area, about the size of the smaller face.
template <class Real, std::size_t Capacity>
Manifold<Real, most_kept>
steadily_reduced(const Manifold<Real, Capacity>& manifold, const Manifold<Real, most_kept>& before)
{
  using std::sqrt;
  const Manifold<Real, most_kept> fresh = reduced(manifold);
  const Manifold<Real, most_kept> old = kept_before(manifold, before);
  const Real spread = doubled_spread(fresh), old_spread = doubled_spread(old);
  const bool all_there = old.points.size() == fresh.points.size();
  const bool good = all_there && old_spread >= Real(0.75) * spread &&
                    deepest_of(fresh) - deepest_of(old) <= Real(0.01) * sqrt(spread);
  return good ? old : fresh;
}
// [steadily_reduced]

} // namespace cookbook
