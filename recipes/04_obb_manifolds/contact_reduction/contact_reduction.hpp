#pragma once

/// \file
/// \brief Keeps four contact points of a manifold that has more: deepest, farthest, widest.

#include "03_sphere_manifolds/manifold/manifold.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cookbook
{

// [doubled_area]
/// Twice the area [m²] of the triangle p, q, r seen against the normal; negative if it turns
/// clockwise there.
template <class Real>
Real doubled_area(
    const Vector3<Real>& normal, const Vector3<Real>& p, const Vector3<Real>& q,
    const Vector3<Real>& r)
{
  return normal.dot((q - p).cross(r - p));
}
// [doubled_area]

// [keeping]
/// The number of points that are kept.
inline constexpr std::size_t most_kept = 4;

/// A manifold and which of its points are kept so far.
template <class Real, std::size_t Capacity>
struct Keeping
{
  const Manifold<Real, Capacity>& manifold; ///< all points
  Real tolerance;                           ///< [m], lengths that differ by less may be equal
  std::array<bool, Capacity> kept{};        ///< by a point's number

  /// Keeps the point with the highest score, of those left, and returns where it is; the first of
  /// all that come within a tie of each other.
  template <class Score>
  Vector3<Real> keep(Real tie, const Score& score)
  {
    std::size_t best = Capacity;
    Real most = Real(0);
    for (std::size_t i = 0; i < manifold.points.size(); ++i)
    {
      const Real now = score(manifold.points[i]);
      if (!kept[i] && (best == Capacity || now > most + tie))
      {
        best = i;
        most = now;
      }
    }
    kept[best] = true;
    return manifold.points[best].position;
  }

  /// The kept points, in the order they had.
  Manifold<Real, most_kept> result() const
  {
    Manifold<Real, most_kept> few{manifold.normal, manifold.depth, {}};
    for (std::size_t i = 0; i < manifold.points.size(); ++i)
    {
      if (kept[i])
      {
        few.points.push_back(manifold.points[i]);
      }
    }
    return few;
  }
};

/// No point kept yet, or all of them if they are no more than four.
///
/// Coordinates have been rounded at their own size, so that is what the tolerance is a part of.
template <class Real, std::size_t Capacity>
Keeping<Real, Capacity> keeping(const Manifold<Real, Capacity>& manifold)
{
  Keeping<Real, Capacity> few{manifold, Real(0), {}};
  for (const ContactPoint<Real>& point : manifold.points)
  {
    few.tolerance = std::max(few.tolerance, point.position.cwiseAbs().maxCoeff());
  }
  few.tolerance *= Real(32) * std::numeric_limits<Real>::epsilon();
  few.kept.fill(manifold.points.size() <= most_kept);
  return few;
}
// [keeping]

// [contact_reduction]
/// Keeps the point that adds most to the triangle p, q, r.
template <class Real, std::size_t Capacity>
void keep_fourth(
    Keeping<Real, Capacity>& few, const Vector3<Real>& p, const Vector3<Real>& q,
    const Vector3<Real>& r)
{
  const Vector3<Real>& n = few.manifold.normal;
  const Real turn = doubled_area(n, p, q, r) < Real(0) ? Real(-1) : Real(1);
  few.keep(
      few.tolerance * (q - p).norm(),
      [&](const ContactPoint<Real>& point)
      {
        const Vector3<Real>& x = point.position;
        const Real beyond = std::min(
            {turn * doubled_area(n, p, q, x), turn * doubled_area(n, q, r, x),
             turn * doubled_area(n, r, p, x)});
        return -beyond;
      });
}

/// Up to four points of a manifold: the deepest, the one farthest from it, the one that makes the
/// largest triangle with them, the one that adds most area to that; O15.
///
/// Four or fewer points are all kept. Scores that differ by no more than rounding are ties, and
/// the point that comes first wins; so points in one place or on one line have an answer too.
/// Normal and depth stay, points keep their order and features.
template <class Real, std::size_t Capacity>
Manifold<Real, most_kept> reduced(const Manifold<Real, Capacity>& manifold)
{
  using std::abs;
  Keeping<Real, Capacity> few = keeping(manifold);
  if (manifold.points.size() > most_kept)
  {
    const Vector3<Real> p =
        few.keep(few.tolerance, [](const ContactPoint<Real>& point) { return point.depth; });
    const Vector3<Real> q = few.keep(
        few.tolerance,
        [&](const ContactPoint<Real>& point) { return (point.position - p).norm(); });
    const Vector3<Real> r = few.keep(
        few.tolerance * (q - p).norm(), [&](const ContactPoint<Real>& point)
        { return abs(doubled_area(manifold.normal, p, q, point.position)); });
    keep_fourth(few, p, q, r);
  }
  return few.result();
}
// [contact_reduction]

} // namespace cookbook
