#pragma once

/// \file
/// \brief Four numbers in two registers: for numbers so wide that four do not fit into one.

#include "common/simd/pack.hpp"

#include <concepts>
#include <cstdint>
#include <type_traits>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// Four numbers as two packs of two: what Pack<Real, 4> is, lane for lane.
///
/// A compiler also splits a pack that is wider than a register, but not always well: g++ 12 takes
/// comparisons and moves between lanes apart, number by number.
template <class Real>
struct Halves
{
  using Half = Pack<Real, 2>;

  Half low;  ///< the first two
  Half high; ///< the last two

  Halves() = default;
  Halves(Real same) : low(same), high(same) {} ///< the same in every lane
  Halves(const Half& first, const Half& last) : low(first), high(last) {} ///< of two packs

  /// The i-th number, i < 4.
  template <std::integral Whole>
  Real operator[](Whole i) const
  {
    return i < 2 ? low[i] : high[i - 2];
  }

  /// What a comparison gives.
  struct Mask
  {
    typename Half::Mask low;  ///< of the first two
    typename Half::Mask high; ///< of the last two

    friend Mask operator&(const Mask& a, const Mask& b) { return {a.low & b.low, a.high & b.high}; }
    friend Mask operator|(const Mask& a, const Mask& b) { return {a.low | b.low, a.high | b.high}; }
    friend std::uint32_t bits_of(const Mask& mask)
    {
      return cookbook::bits_of(mask.low) | cookbook::bits_of(mask.high) << 2;
    }
  };

  friend Halves operator+(const Halves& a, const Halves& b)
  {
    return {a.low + b.low, a.high + b.high};
  }
  friend Halves operator-(const Halves& a, const Halves& b)
  {
    return {a.low - b.low, a.high - b.high};
  }
  friend Halves operator*(const Halves& a, const Halves& b)
  {
    return {a.low * b.low, a.high * b.high};
  }
  friend Halves operator/(const Halves& a, const Halves& b)
  {
    return {a.low / b.low, a.high / b.high};
  }
  friend Halves operator-(const Halves& a) { return {-a.low, -a.high}; }
  friend Halves max(const Halves& a, const Halves& b)
  {
    return {max(a.low, b.low), max(a.high, b.high)};
  }
  friend Halves min(const Halves& a, const Halves& b)
  {
    return {min(a.low, b.low), min(a.high, b.high)};
  }
  friend Halves abs(const Halves& a) { return {abs(a.low), abs(a.high)}; }
  friend Mask operator<(const Halves& a, const Halves& b)
  {
    return {a.low < b.low, a.high < b.high};
  }
  friend Mask operator<=(const Halves& a, const Halves& b)
  {
    return {a.low <= b.low, a.high <= b.high};
  }
  friend Halves select(const Mask& mask, const Halves& yes, const Halves& no)
  {
    return {
        cookbook::select(mask.low, yes.low, no.low),
        cookbook::select(mask.high, yes.high, no.high)};
  }
};

/// Number I of a pair and number J of another, 0 or 1 each.
template <int I, int J, class Real>
Pack<Real, 2> pair_of(const Pack<Real, 2>& a, const Pack<Real, 2>& b)
{
  return Pack<Real, 2>::of(shuffled<I, J + 2>(a.lanes, b.lanes));
}

/// The first three lanes moved one on: y, z, x.
template <class Real>
Halves<Real> turned_once(const Halves<Real>& v)
{
  return {pair_of<1, 0>(v.low, v.high), pair_of<0, 0>(v.low, v.low)};
}

/// The first three lanes moved two on: z, x, y.
template <class Real>
Halves<Real> turned_twice(const Halves<Real>& v)
{
  return {pair_of<0, 0>(v.high, v.low), pair_of<1, 1>(v.low, v.low)};
}

/// Four rows of four made columns.
template <class Real>
void transpose(Halves<Real> (&rows)[4])
{
  const Halves<Real> p = rows[0], q = rows[1], r = rows[2], s = rows[3];
  rows[0] = {pair_of<0, 0>(p.low, q.low), pair_of<0, 0>(r.low, s.low)};
  rows[1] = {pair_of<1, 1>(p.low, q.low), pair_of<1, 1>(r.low, s.low)};
  rows[2] = {pair_of<0, 0>(p.high, q.high), pair_of<0, 0>(r.high, s.high)};
  rows[3] = {pair_of<1, 1>(p.high, q.high), pair_of<1, 1>(r.high, s.high)};
}

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
