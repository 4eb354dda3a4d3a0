#pragma once

/// \file
/// \brief Rows in registers: the numbers of one pair side by side, added and multiplied at once.

#include "common/simd/fours.hpp"
#include "common/simd/halves.hpp"
#include "common/simd/row.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// Four plain numbers: floats in one register, doubles in two. A row of three leaves the fourth
/// idle; it holds the third again, so that it never decides.
template <class Real>
using Registers = std::conditional_t<sizeof(Real) == 4, Pack<Real, 4>, Halves<Real>>;

/// The first three lanes moved one on: y, z, x.
template <class Real>
Pack<Real, 4> turned_once(const Pack<Real, 4>& v)
{
  return Pack<Real, 4>::of(shuffled<1, 2, 0, 0>(v.lanes, v.lanes));
}

/// The first three lanes moved two on: z, x, y.
template <class Real>
Pack<Real, 4> turned_twice(const Pack<Real, 4>& v)
{
  return Pack<Real, 4>::of(shuffled<2, 0, 1, 1>(v.lanes, v.lanes));
}

/// Three rows of three made columns; Row is of registers.
template <class Row>
void transpose_three(Row (&rows)[3])
{
  Row square[] = {rows[0], rows[1], rows[2], rows[2]};
  transpose(square);
  for (int i = 0; i < 3; ++i)
  {
    rows[i] = square[i];
  }
}

/// Three rows of three made columns.
template <class Real>
void transpose(Pack<Real, 4> (&rows)[3])
{
  transpose_three(rows);
}

/// Three rows of three made columns.
template <class Real>
void transpose(Halves<Real> (&rows)[3])
{
  transpose_three(rows);
}

// [register_rows]
/// Rows of plain numbers in registers.
template <class Real>
struct RegisterRows
{
  using Number = Real;              ///< what it has three of
  using Four = Registers<Real>;     ///< the same with four
  using Mask = typename Four::Mask; ///< what a comparison gives

  /// Three numbers.
  static Four three(Real x, Real y, Real z) { return four(x, y, z, z); }

  /// Four numbers.
  static Four four(Real x, Real y, Real z, Real w)
  {
    if constexpr (std::is_same_v<Four, Halves<Real>>)
    {
      using Half = Pack<Real, 2>;
      return {Half::of(typename Half::Lanes{x, y}), Half::of(typename Half::Lanes{z, w})};
    }
    else
    {
      return Four::of(typename Four::Lanes{x, y, z, w});
    }
  }

  /// Whether all are set.
  static bool all(const Mask& mask) { return bits_of(mask) == 15; }

  /// Whether any is set.
  static bool any(const Mask& mask) { return bits_of(mask) != 0; }

  /// The first place that is set in masks of three each, counted through; one of them is.
  template <std::size_t Count>
  static int first_set(const Mask (&masks)[Count])
  {
    std::uint32_t bits = 0; // the idle fourth is set only where the third is
    for (std::size_t i = 0; i < Count; ++i)
    {
      bits |= bits_of(masks[i]) << 3 * i;
    }
    return std::countr_zero(bits);
  }

  /// A bit for each of four.
  static std::uint32_t bits(const Mask& mask) { return bits_of(mask); }
};

/// Floats in one register.
template <class Real>
struct RowTraits<Pack<Real, 4>> : RegisterRows<Real>
{
};

/// Doubles in two.
template <class Real>
struct RowTraits<Halves<Real>> : RegisterRows<Real>
{
};
// [register_rows]

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
