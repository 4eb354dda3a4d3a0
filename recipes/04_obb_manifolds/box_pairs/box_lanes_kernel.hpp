#pragma once

/// \file
/// \brief Pairs of boxes in the lanes of a register, for the kernel of box_pairs.

#include "04_obb_manifolds/box_box/box_choice.hpp"
#include "common/simd/lanes.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

using Three = RowOf<Lanes, 3>;

/// Whole numbers, a lane each.
using Words = VectorOf<std::int32_t, width>::type;

/// Whole numbers to memory.
inline void store(const Words& words, std::uint32_t* to)
{
  std::memcpy(to, &words, sizeof words);
}

/// Whole numbers from memory.
inline Words words_at(const std::uint32_t* from)
{
  Words words;
  std::memcpy(&words, from, sizeof words);
  return words;
}

/// The bits of all pairs of a register.
inline constexpr std::uint32_t all_pairs = (1u << width) - 1;

/// A register of boxes, from rows whose number i belongs to box i: those from box i on.
template <class Rows>
Obb<Lanes> boxes_at(const Rows& rows, std::size_t i)
{
  Obb<Lanes> box;
  for (int x = 0; x < 3; ++x)
  {
    box.center[x] = load_pack<Lanes>(rows.center[x] + i);
    box.half_extents[x] = load_pack<Lanes>(rows.half_extents[x] + i);
    for (int axis = 0; axis < 3; ++axis)
    {
      box.axes(x, axis) = load_pack<Lanes>(rows.axes[axis][x] + i);
    }
  }
  return box;
}

/// The boxes of `yes` where the mask is set, those of `no` elsewhere.
inline Obb<Lanes> select(const Lanes::Mask& mask, const Obb<Lanes>& yes, const Obb<Lanes>& no)
{
  Obb<Lanes> box;
  for (int x = 0; x < 3; ++x)
  {
    box.center[x] = select(mask, yes.center[x], no.center[x]);
    box.half_extents[x] = select(mask, yes.half_extents[x], no.half_extents[x]);
    for (int axis = 0; axis < 3; ++axis)
    {
      box.axes(x, axis) = select(mask, yes.axes(x, axis), no.axes(x, axis));
    }
  }
  return box;
}

/// Whose face a manifold is built on, and which of its axes that is.
struct FaceOf
{
  Lanes::Mask a;     ///< set where it is A's
  Which<Lanes> axis; ///< the first, second or third

  /// By the face's index, 0 to 5.
  explicit FaceOf(const Lanes& index)
      : a(index < Lanes(2.5f)), axis(select(a, index, index - Lanes(3.0f)))
  {
  }
};

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
