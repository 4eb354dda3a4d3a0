#pragma once

/// \file
/// \brief What comparing two rows gives.

#include "common/simd/choose.hpp"

#include <bit>
#include <cstdint>
#include <functional>
#include <iterator>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// What a function gives of each part of two rows, or of two masks.
template <class Result, class Parts, class Function>
Result each(const Parts& a, const Parts& b, const Function& function)
{
  Result result;
  for (int i = 0; i < static_cast<int>(std::size(a.part)); ++i)
  {
    result.part[i] = function(a.part[i], b.part[i]);
  }
  return result;
}

/// For each number of a row a yes or a no; `PerPart` of them in each of its parts.
template <class Real, class Part, int Parts, int PerPart>
struct RowMask
{
  MaskOf<Part> part[Parts]; ///< of each part

  friend RowMask operator&(const RowMask& a, const RowMask& b)
  {
    return each<RowMask>(a, b, std::bit_and());
  }
  friend RowMask operator|(const RowMask& a, const RowMask& b)
  {
    return each<RowMask>(a, b, std::bit_or());
  }

  /// A bit for each number, that of the first lowest.
  std::uint32_t bits() const
  {
    std::uint32_t bits = 0;
    for (int i = 0; i < Parts; ++i)
    {
      bits |= bits_of(part[i]) << PerPart * i;
    }
    return bits;
  }

  /// Whether all of three are set; packs: of every pair.
  MaskOf<Real> all() const
  {
    if constexpr (PerPart == 1)
    {
      return part[0] & part[1] & part[2];
    }
    else
    {
      return bits() == 15;
    }
  }

  /// Whether any of three is set; packs: of every pair.
  MaskOf<Real> any() const
  {
    if constexpr (PerPart == 1)
    {
      return part[0] | part[1] | part[2];
    }
    else
    {
      return bits() != 0;
    }
  }
};

/// The first place that is set in masks of three each, counted through; one of them is.
template <class Real, class Part, int Parts, int PerPart, int Count>
Index<Real> first_set(const RowMask<Real, Part, Parts, PerPart> (&masks)[Count])
{
  if constexpr (PerPart == 1)
  {
    int place = 3 * Count - 1;
    Index<Real> first = index<Real>(place);
    while (place-- > 0)
    {
      first = select(masks[place / 3].part[place % 3], index<Real>(place), first);
    }
    return first;
  }
  else
  {
    std::uint32_t bits = 0; // the idle fourth is set only where the third is
    for (int i = 0; i < Count; ++i)
    {
      bits |= masks[i].bits() << 3 * i;
    }
    return std::countr_zero(bits);
  }
}

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
