#pragma once

/// \file
/// \brief One of three: which number of a row is meant, for one pair or for each pair of a pack.

#include "common/simd/number.hpp"

#include <type_traits>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

// [which]
/// A number that counts things: a whole number, or for packs one of the pack's own kind.
template <class Number>
using Index = std::conditional_t<std::is_same_v<MaskOf<Number>, bool>, int, Number>;

/// A whole number as an index.
template <class Number>
Index<Number> index(int i)
{
  return static_cast<typename PartOf<Index<Number>>::type>(i);
}

/// Which of three numbers is meant, where that differs from pair to pair.
template <class Number>
struct Which
{
  MaskOf<Number> is[3]; ///< set where it is meant

  /// By its index, 0, 1 or 2.
  explicit Which(const Number& index)
      : is{index < Number(0.5f), (Number(0.5f) < index) & (index < Number(1.5f)),
           Number(1.5f) < index}
  {
  }
  /// By masks: where it is the first, the second, the third.
  Which(const MaskOf<Number>& x, const MaskOf<Number>& y, const MaskOf<Number>& z) : is{x, y, z} {}
};

/// The number after the one that is meant; the first after the third.
template <class Number>
Which<Number> next(const Which<Number>& which)
{
  return {which.is[2], which.is[0], which.is[1]};
}

/// The number after the i-th; the first after the third.
inline int next(int i)
{
  return i == 2 ? 0 : i + 1;
}

/// Which number an index 0, 1 or 2 means.
template <class Number>
Which<Number> which(const Number& index)
{
  return Which<Number>(index);
}

/// Which number an index 0, 1 or 2 means: itself.
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

/// The i-th of three things: itself, not a copy, where it is kept by itself.
template <class Things>
decltype(auto) chosen(const Things& things, int i)
{
  return things[i];
}
// [which]

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
