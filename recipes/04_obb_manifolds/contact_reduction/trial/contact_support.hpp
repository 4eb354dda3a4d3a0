#pragma once

/// \file
/// \brief Keeps four contact points so that they still hold a given point: the centre of mass.

#include "04_obb_manifolds/contact_reduction/contact_reduction.hpp"

#include <optional>

namespace cookbook
{

// [is_over]
/// Whether a point lies in the triangle or on its rim, seen along the normal; one without an area
/// holds nothing.
template <class Real>
bool is_over(
    const Vector3<Real>& point, const Vector3<Real>& normal, const Vector3<Real>& p,
    const Vector3<Real>& q, const Vector3<Real>& r)
{
  const Real turn = doubled_area(normal, p, q, r);
  const auto inside = [&](const Vector3<Real>& from, const Vector3<Real>& to)
  { return turn * doubled_area(normal, from, to, point) >= Real(0); };
  return turn != Real(0) && inside(p, q) && inside(q, r) && inside(r, p);
}
// [is_over]

// [reduced_over]
/// The numbers of two points that make the largest triangle over `center` together with p.
template <class Real, std::size_t Capacity>
std::optional<std::array<std::size_t, 2>>
widest_over(const Keeping<Real, Capacity>& few, const Vector3<Real>& p, const Vector3<Real>& center)
{
  using std::abs;
  const auto& [normal, depth, points] = few.manifold;
  std::optional<std::array<std::size_t, 2>> widest;
  Real most = Real(0);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t j = i + 1; j < points.size(); ++j)
    {
      const Vector3<Real>&q = points[i].position, &r = points[j].position;
      const Real tie = few.tolerance * (q - p).norm();
      const Real now = abs(doubled_area(normal, p, q, r));
      if (now > most + tie && is_over(center, normal, p, q, r))
      {
        widest = {i, j};
        most = now;
      }
    }
  }
  return widest;
}

/// Up to four points of a manifold that hold what all of them hold of `center` [m], world: the
/// deepest, the two that make the largest triangle over it, the one that adds most area to that.
///
/// The convex hull of the kept points is over `center` wherever that of all points is; where that
/// is not, or where it is on the rim and rounding says otherwise, the answer is reduced().
template <class Real, std::size_t Capacity>
Manifold<Real, most_kept>
reduced_over(const Manifold<Real, Capacity>& manifold, const Vector3<Real>& center)
{
  Keeping<Real, Capacity> few = keeping(manifold);
  if (manifold.points.size() <= most_kept)
  {
    return few.result();
  }
  const Vector3<Real> p =
      few.keep(few.tolerance, [](const ContactPoint<Real>& point) { return point.depth; });
  const auto widest = widest_over(few, p, center);
  if (!widest)
  {
    return reduced(manifold);
  }
  const auto [i, j] = *widest;
  few.kept[i] = few.kept[j] = true;
  keep_fourth(few, p, manifold.points[i].position, manifold.points[j].position);
  return few.result();
}
// [reduced_over]

} // namespace cookbook
