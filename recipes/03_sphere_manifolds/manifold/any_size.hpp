#pragma once

/// \file
/// \brief Answers for shapes of any finite size, also where sums and squares of their numbers would
/// be infinite.

#include "03_sphere_manifolds/manifold/scaled.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cookbook
{

/// The largest of a box's lengths, without sign.
template <class Real>
Real largest(const Obb<Real>& box)
{
  return box.center.cwiseAbs().cwiseMax(box.half_extents).maxCoeff();
}

// [at_any_size]
/// Numbers up to this size have sums that fit.
template <class Real>
inline const Real sums_fit = std::numeric_limits<Real>::max() / Real(16);

/// Numbers up to this size have sums of squares that fit.
template <class Real>
inline const Real squares_fit = std::sqrt(std::numeric_limits<Real>::max()) / Real(16);

/// The manifold that `find(a, b)` gives for shapes of numbers up to `most`; larger ones are made
/// that small first, and the answer is enlarged. Powers of two are exact.
template <class Real, class First, class Second, class Find>
std::optional<Manifold<Real>>
at_any_size(const First& a, const Second& b, Real most, const Find& find)
{
  const Real size = std::max(largest(a), largest(b));
  if (!(size > most))
  {
    return find(a, b);
  }
  const int exponent = std::ilogb(size) - std::ilogb(most) + 1;
  const std::optional<Manifold<Real>> found = find(scaled(a, -exponent), scaled(b, -exponent));
  return found ? std::optional(scaled(*found, exponent)) : std::nullopt;
}
// [at_any_size]

} // namespace cookbook
