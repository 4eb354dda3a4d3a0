#pragma once

/// \file
/// \brief Groups: three or four numbers that belong to one pair, computed with at once.

#include "common/simd/halves.hpp"
#include "common/simd/several.hpp"

#include <cstddef>
#include <type_traits>
#include <utility>

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi" // as in pack.hpp
#endif

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// Four plain numbers in a register, or in two where one is too small.
template <class Real>
using FourNumbers =
    std::conditional_t<(4 * sizeof(Real) > register_size), Halves<Real>, Pack<Real, 4>>;

/// Four plain numbers, side by side.
template <class Real>
FourNumbers<Real> four(const Real& x, const Real& y, const Real& z, const Real& w)
{
  if constexpr (std::is_same_v<FourNumbers<Real>, Halves<Real>>)
  {
    using Half = Pack<Real, 2>;
    return {Half::of(typename Half::Lanes{x, y}), Half::of(typename Half::Lanes{z, w})};
  }
  else
  {
    return Pack<Real, 4>::of(typename Pack<Real, 4>::Lanes{x, y, z, w});
  }
}

// [group]
/// Three or four numbers of a pair side by side: for plain numbers the lanes of a register, of
/// which the fourth may be idle; for packs, with a pair in every lane, as many packs.
template <class Real, int Size>
using Group =
    std::conditional_t<std::is_floating_point_v<Real>, FourNumbers<Real>, Several<Real, Size>>;

/// A group of given numbers; an idle fourth lane holds the third again.
template <class Real>
Group<Real, 3> group(const Real& x, const Real& y, const Real& z)
{
  Group<Real, 3> result;
  if constexpr (std::is_floating_point_v<Real>)
  {
    result = four(x, y, z, z);
  }
  else
  {
    result.lane[0] = x;
    result.lane[1] = y;
    result.lane[2] = z;
  }
  return result;
}

/// A group of four numbers.
template <class Real>
Group<Real, 4> group(const Real& x, const Real& y, const Real& z, const Real& w)
{
  Group<Real, 4> result;
  if constexpr (std::is_floating_point_v<Real>)
  {
    result = four(x, y, z, w);
  }
  else
  {
    result.lane[0] = x;
    result.lane[1] = y;
    result.lane[2] = z;
    result.lane[3] = w;
  }
  return result;
}

/// The first three lanes moved one on: y, z, x.
template <class Real>
Pack<Real, 4> turned_once(const Pack<Real, 4>& v)
{
  return Pack<Real, 4>::of(__builtin_shufflevector(v.lanes, v.lanes, 1, 2, 0, 0));
}

/// The first three lanes moved two on: z, x, y.
template <class Real>
Pack<Real, 4> turned_twice(const Pack<Real, 4>& v)
{
  return Pack<Real, 4>::of(__builtin_shufflevector(v.lanes, v.lanes, 2, 0, 1, 1));
}

/// The last three lanes.
template <class Real>
Pack<Real, 4> last_three(const Pack<Real, 4>& v)
{
  return Pack<Real, 4>::of(__builtin_shufflevector(v.lanes, v.lanes, 1, 2, 3, 3));
}

/// The three packs moved one on: y, z, x.
template <class Number>
Several<Number, 3> turned_once(const Several<Number, 3>& v)
{
  return group(v[1], v[2], v[0]);
}

/// The three packs moved two on: z, x, y.
template <class Number>
Several<Number, 3> turned_twice(const Several<Number, 3>& v)
{
  return group(v[2], v[0], v[1]);
}

/// Four packs of four as a square whose rows become columns.
template <class Real>
void transpose(Pack<Real, 4>& a, Pack<Real, 4>& b, Pack<Real, 4>& c, Pack<Real, 4>& d)
{
  const auto low_ab = __builtin_shufflevector(a.lanes, b.lanes, 0, 4, 1, 5);
  const auto low_cd = __builtin_shufflevector(c.lanes, d.lanes, 0, 4, 1, 5);
  const auto high_ab = __builtin_shufflevector(a.lanes, b.lanes, 2, 6, 3, 7);
  const auto high_cd = __builtin_shufflevector(c.lanes, d.lanes, 2, 6, 3, 7);
  a.lanes = __builtin_shufflevector(low_ab, low_cd, 0, 1, 4, 5);
  b.lanes = __builtin_shufflevector(low_ab, low_cd, 2, 3, 6, 7);
  c.lanes = __builtin_shufflevector(high_ab, high_cd, 0, 1, 4, 5);
  d.lanes = __builtin_shufflevector(high_ab, high_cd, 2, 3, 6, 7);
}

/// Three rows of three made columns.
template <class Real>
void transpose(Pack<Real, 4> (&rows)[3])
{
  Pack<Real, 4> idle = rows[2];
  transpose(rows[0], rows[1], rows[2], idle);
}

/// Three rows of three made columns.
template <class Real>
void transpose(Halves<Real> (&rows)[3])
{
  Halves<Real> idle = rows[2];
  transpose(rows[0], rows[1], rows[2], idle);
}

/// Three rows of three made columns.
template <class Number>
void transpose(Several<Number, 3> (&rows)[3])
{
  using std::swap;
  swap(rows[0].lane[1], rows[1].lane[0]);
  swap(rows[0].lane[2], rows[2].lane[0]);
  swap(rows[1].lane[2], rows[2].lane[1]);
}
// [group]

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
