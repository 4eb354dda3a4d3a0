#pragma once

/// \file
/// \brief The manifold of two oriented boxes, the same text with its rows in registers.

#include "04_obb_manifolds/box_box/box_box.hpp"
#include "common/simd/pack.hpp"

#include <optional>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

// [box_box_in_registers]
/// Three numbers in a register, or of doubles in two.
template <class Real>
using RowInRegisters = RowOf<Real, 3, Pack<Real, 16 / sizeof(Real)>>;

/// box_box() bit for bit, in float or double, with three or four numbers at a time in registers.
template <class Real>
std::optional<Manifold<Real>> box_box_in_registers(const Obb<Real>& a, const Obb<Real>& b)
{
  return box_box_in<RowInRegisters<Real>>(a, b);
}
// [box_box_in_registers]

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
