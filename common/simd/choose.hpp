#pragma once

/// \file
/// \brief One of three: which lane of a group is meant, for one pair or for a pair in every lane.

#include "common/simd/group.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi" // as in pack.hpp
#endif

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

// [which]
/// A number that counts things: a whole number, or for packs one of the pack's own kind.
template <class Real>
using Index = std::conditional_t<std::is_floating_point_v<Real>, int, Real>;

/// A whole number as an index.
template <class Real>
Index<Real> index(int i)
{
  return static_cast<std::conditional_t<std::is_floating_point_v<Real>, int, float>>(i);
}

/// Which of three lanes is meant, where that differs from pair to pair.
template <class Number>
struct Which
{
  typename Number::Mask is[3]; ///< set where the lane is meant

  /// Lane 0, 1 or 2.
  explicit Which(const Number& index)
      : is{index < Number(0.5f), (Number(0.5f) < index) & (index < Number(1.5f)),
           Number(1.5f) < index}
  {
  }
  /// The mask of each lane.
  Which(
      const typename Number::Mask& x, const typename Number::Mask& y,
      const typename Number::Mask& z)
      : is{x, y, z}
  {
  }
};

/// The lane after the one that is meant; lane 0 after lane 2.
template <class Number>
Which<Number> next(const Which<Number>& which)
{
  return {which.is[2], which.is[0], which.is[1]};
}

/// The lane after lane i.
inline int next(int i)
{
  return i == 2 ? 0 : i + 1;
}

/// Which lane an index 0, 1 or 2 means.
template <class Number>
Which<Number> which(const Number& index)
{
  return Which<Number>(index);
}

/// Which lane an index 0, 1 or 2 means: itself.
inline int which(int index)
{
  return index;
}

/// One of three things of each pair.
template <class Things, class Number>
auto chosen(const Things& things, const Which<Number>& which)
{
  return select(which.is[0], things[0], select(which.is[1], things[1], things[2]));
}

/// The i-th of three things: itself, not a copy.
template <class Things>
const auto& chosen(const Things& things, int i)
{
  return things[i];
}

/// The i-th of three numbers in one register.
template <class Real>
Real chosen(const Pack<Real, 4>& numbers, int i)
{
  return numbers[i];
}

/// The i-th of three numbers in two registers.
template <class Real>
Real chosen(const Halves<Real>& numbers, int i)
{
  return numbers[i];
}
// [which]

/// An index divided by three, without the rest.
inline int third(int i)
{
  return i / 3;
}

/// An index of 0 to 8 divided by three, without the rest.
template <class Number>
Number third(const Number& i)
{
  const Number zero(0), one(1);
  return select(Number(2.5f) < i, one, zero) + select(Number(5.5f) < i, one, zero);
}

/// The first place at which masks of three lanes each are set, counted through; one of them is.
template <class Real, std::size_t Count>
Index<Real> first_set(const typename Group<Real, 3>::Mask (&masks)[Count])
{
  if constexpr (std::is_floating_point_v<Real>)
  {
    std::uint32_t bits = 0; // the idle fourth lane is set only where the third is
    for (std::size_t i = 0; i < Count; ++i)
    {
      bits |= bits_of(masks[i]) << 3 * i;
    }
    return std::countr_zero(bits);
  }
  else
  {
    int place = 3 * Count - 1;
    Real first = index<Real>(place);
    while (place-- > 0)
    {
      first = select(masks[place / 3].lane[place % 3], index<Real>(place), first);
    }
    return first;
  }
}

/// Whether a test holds, where it is of one pair only: itself.
inline bool any(bool mask)
{
  return mask;
}

/// Whether any number of the pair has the mask set.
template <class Real>
requires std::is_floating_point_v<Real>
bool any_lane(const typename Group<Real, 3>::Mask& mask)
{
  return any(mask);
}

/// Whether all three numbers of a pair have the mask set, for every pair.
template <class Number>
requires(!std::is_floating_point_v<Number>) typename Number::Mask
    all_lanes(const typename Several<Number, 3>::Mask& mask)
{
  return mask.lane[0] & mask.lane[1] & mask.lane[2];
}

/// Whether any number of a pair has the mask set, for every pair.
template <class Number>
requires(!std::is_floating_point_v<Number>) typename Number::Mask
    any_lane(const typename Several<Number, 3>::Mask& mask)
{
  return mask.lane[0] | mask.lane[1] | mask.lane[2];
}

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
