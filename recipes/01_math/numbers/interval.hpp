#pragma once

/// \file
/// \brief Intervals of numbers: overlap, clamp, and what an empty one answers.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cookbook
{

// [interval]
/// All numbers from `least` to `most`, both included; empty where `least` is not below or at
/// `most`.
template <class Real>
struct Interval
{
  Real least; ///< the lower end
  Real most;  ///< the upper end
};

/// The interval that holds nothing; `hull` grows it to any other.
template <class Real>
Interval<Real> empty_interval()
{
  const Real infinite = std::numeric_limits<Real>::infinity();
  return {infinite, -infinite};
}

/// Whether an interval holds no number; one with an end that is NaN holds none.
template <class Real>
bool is_empty(const Interval<Real>& i)
{
  return !(i.least <= i.most);
}

/// The smallest interval that holds another one and a number; NaN adds nothing.
template <class Real>
Interval<Real> hull(const Interval<Real>& i, Real x)
{
  return {std::min(i.least, x), std::max(i.most, x)};
}

/// The numbers that two intervals have in common; empty where there are none.
template <class Real>
Interval<Real> intersection(const Interval<Real>& a, const Interval<Real>& b)
{
  return {std::max(a.least, b.least), std::min(a.most, b.most)};
}
// [interval]

// [interval_overlap]
/// How far one of two intervals must move until they only touch; negative: the gap between them.
///
/// Its sign is exact: zero means that they touch, not that they nearly do. An empty interval is
/// infinitely far from all others. Infinite where the true answer does not fit.
template <class Real>
Real interval_overlap(const Interval<Real>& a, const Interval<Real>& b)
{
  if (is_empty(a) || is_empty(b))
  {
    return -std::numeric_limits<Real>::infinity();
  }
  return std::min(a.most - b.least, b.most - a.least);
}
// [interval_overlap]

// [clamp]
/// The number of an interval that is nearest to `x`; nothing where the interval is empty or `x` is
/// NaN.
template <class Real>
std::optional<Real> clamp(Real x, const Interval<Real>& i)
{
  const bool no_number = std::isnan(x);
  if (is_empty(i) || no_number)
  {
    return std::nullopt;
  }
  return std::max(i.least, std::min(x, i.most));
}
// [clamp]

} // namespace cookbook
