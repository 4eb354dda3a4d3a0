#pragma once

/// \file
/// \brief Whether two manifolds are the same to the last bit.

#include "03_sphere_manifolds/manifold/manifold.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cookbook
{

/// The same number, sign of zero included; not a number is one answer, whatever its bits.
template <class Real>
bool same_bits(Real x, Real y)
{
  return (x == y && std::signbit(x) == std::signbit(y)) || (std::isnan(x) && std::isnan(y));
}

template <class Real>
bool same_bits(const Vector3<Real>& v, const Vector3<Real>& w)
{
  return same_bits(v.x(), w.x()) && same_bits(v.y(), w.y()) && same_bits(v.z(), w.z());
}

template <class Real>
bool same_bits(const ContactPoint<Real>& p, const ContactPoint<Real>& q)
{
  return same_bits(p.position, q.position) && same_bits(p.depth, q.depth) && p.feature == q.feature;
}

/// The same points in the same order, or nothing twice.
template <class Real>
bool same_bits(const std::optional<Manifold<Real>>& x, const std::optional<Manifold<Real>>& y)
{
  if (!x || !y)
  {
    return !x && !y;
  }
  return same_bits(x->normal, y->normal) && same_bits(x->depth, y->depth) &&
         std::equal(
             x->points.begin(), x->points.end(), y->points.begin(), y->points.end(),
             [](const auto& p, const auto& q) { return same_bits(p, q); });
}

} // namespace cookbook
