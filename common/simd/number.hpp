#pragma once

/// \file
/// \brief What plain numbers and packs of numbers have in common.

#include <cstdint>
#include <type_traits>
#include <utility>

/// The instruction set this file is compiled for; a name of its own keeps the linker from ever
/// taking one instruction set's functions for another's.
#ifndef COOKBOOK_INSTRUCTION_SET
#define COOKBOOK_INSTRUCTION_SET portable
#endif

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// What a number is made of: a pack of its lanes, a plain number of itself.
template <class Number>
struct PartOf
{
  using type = Number; ///< the plain number
};

/// What comparing two numbers gives: true or false, or a pack's mask.
template <class Number>
using MaskOf = decltype(std::declval<Number>() < std::declval<Number>());

/// One of two numbers, as select() of packs is for each lane.
template <class Real>
Real select(bool first, const Real& yes, const Real& no)
{
  return first ? yes : no;
}

/// The larger of two numbers, the second if they are equal; packs: of each lane.
template <class Number>
Number larger(const Number& x, const Number& y)
{
  return select(x > y, x, y);
}

/// The smaller of two numbers, the second if they are equal; packs: of each lane.
template <class Number>
Number smaller(const Number& x, const Number& y)
{
  return select(x < y, x, y);
}

/// Whether a test holds, where it is of one pair: itself.
inline bool any(bool mask)
{
  return mask;
}

/// A bit for a test, where it is of one pair.
inline std::uint32_t bits_of(bool mask)
{
  return mask;
}

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
