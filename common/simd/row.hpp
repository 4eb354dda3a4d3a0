#pragma once

/// \file
/// \brief Rows: the three numbers of a pair that belong together, and four of them, whatever they
/// are kept in.

#include "common/simd/choose.hpp"

#include <cstddef>
#include <cstdint>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

// [row]
/// What a type of rows must offer: its number type, the type of four, and how they are made and
/// asked. Here for groups; registers.hpp has it for registers.
template <class Row>
struct RowTraits;

/// Groups of three, and of four.
template <class Plain, int Size>
struct RowTraits<Group<Plain, Size>>
{
  using Number = Plain;                        ///< what it has three of
  using Four = Group<Plain, 4>;                ///< the same with four
  using Mask = typename Group<Plain, 3>::Mask; ///< what comparing three gives

  /// Three numbers.
  static Group<Plain, 3> three(const Plain& x, const Plain& y, const Plain& z)
  {
    return group(x, y, z);
  }

  /// Four numbers.
  static Four four(const Plain& x, const Plain& y, const Plain& z, const Plain& w)
  {
    Four result;
    result.at[0] = x;
    result.at[1] = y;
    result.at[2] = z;
    result.at[3] = w;
    return result;
  }

  /// Whether all three are set; packs: for every pair.
  static MaskOf<Plain> all(const Mask& mask) { return mask.at[0] & mask.at[1] & mask.at[2]; }

  /// Whether any is set; packs: for every pair.
  static MaskOf<Plain> any(const Mask& mask) { return mask.at[0] | mask.at[1] | mask.at[2]; }

  /// The first place that is set in masks of three each, counted through; one of them is.
  template <std::size_t Count>
  static Index<Plain> first_set(const Mask (&masks)[Count])
  {
    int place = 3 * Count - 1;
    Index<Plain> first = index<Plain>(place);
    while (place-- > 0)
    {
      first = select(masks[place / 3].at[place % 3], index<Plain>(place), first);
    }
    return first;
  }

  /// A bit for each of four.
  static std::uint32_t bits(const typename Four::Mask& mask)
  {
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i)
    {
      bits |= static_cast<std::uint32_t>(mask.at[i]) << i;
    }
    return bits;
  }
};

/// The number type of a row.
template <class Row>
using RowNumber = typename RowTraits<Row>::Number;

/// The row of four that belongs to a row of three.
template <class Row>
using FourOf = typename RowTraits<Row>::Four;

/// A row of the three numbers of a vector.
template <class Row, class Vector>
Row row_of(const Vector& v)
{
  return RowTraits<Row>::three(v[0], v[1], v[2]);
}
// [row]

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
