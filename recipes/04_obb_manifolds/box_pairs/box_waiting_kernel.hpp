#pragma once

/// \file
/// \brief Pairs of boxes that wait until a register is full of them, for the kernel of box_pairs.

#include "04_obb_manifolds/box_pairs/box_lanes_kernel.hpp"
#include "04_obb_manifolds/box_pairs/box_pairs.hpp"
#include "common/simd/compress.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// So many blocks are looked at before the pairs that wait are answered.
inline constexpr std::size_t blocks_at_once = 4;

/// A register of pairs, and the blocks that they lie in.
struct PairsInBlocks
{
  const SixteenBoxes &a, &b;
  std::size_t at;      ///< the place in the blocks of its first pair
  std::uint32_t first; ///< that pair, counted through all blocks

  /// The numbers of its pairs.
  Words numbers() const
  {
    Words words;
    for (std::size_t i = 0; i < width; ++i)
    {
      words[i] = static_cast<std::int32_t>(first + i);
    }
    return words;
  }
};

// [waiting]
/// Pairs of one kind, side by side.
struct Waiting
{
  /// Places for a register more than what is looked at.
  static constexpr std::size_t room = 16 * blocks_at_once + width;

  /// Boxes as SixteenBoxes has them.
  struct Rows
  {
    float center[3][room], axes[3][3][room], half_extents[3][room];
  };

  Rows box = {};                 ///< the box whose face is taken; A where edges are
  Rows other = {};               ///< the other box
  float depth[room] = {};        ///< [m], of the face; [m²], squared, of the edges
  float index[room] = {};        ///< of the face, or of the pair of edges
  std::uint32_t pair[room] = {}; ///< which pair it is
  std::size_t count = 0;         ///< how many wait
};
// [waiting]

/// A box with axis k as its first, k+1 as its second.
inline Obb<Lanes> turned(const Obb<Lanes>& box, const Which<Lanes>& k)
{
  Obb<Lanes> result = box;
  Which<Lanes> from = k;
  for (int axis = 0; axis < 3; ++axis, from = next(from))
  {
    result.half_extents[axis] = chosen(box.half_extents, from);
    for (int x = 0; x < 3; ++x)
    {
      result.axes(x, axis) = chosen(box.axes.row(x), from);
    }
  }
  return result;
}

/// Adds the lanes whose bits are set, each row of them by one instruction.
inline void wait_at_once(
    Waiting& waiting, std::uint32_t bits, const Obb<Lanes>& box, const Obb<Lanes>& other,
    const Lanes& depth, const Lanes& index, const Words& pair)
{
  const Compress compress(bits);
  const auto add = [&](const Lanes& lanes, float* row)
  { store_pack(compress(lanes), row + waiting.count); };
  const auto add_box = [&](const Obb<Lanes>& from, Waiting::Rows& rows)
  {
    for (int x = 0; x < 3; ++x)
    {
      add(from.center[x], rows.center[x]);
      add(from.half_extents[x], rows.half_extents[x]);
      for (int axis = 0; axis < 3; ++axis)
      {
        add(from.axes(x, axis), rows.axes[axis][x]);
      }
    }
  };
  add_box(box, waiting.box);
  add_box(other, waiting.other);
  add(depth, waiting.depth);
  add(index, waiting.index);
  const Lanes pair_bits = Lanes::of(std::bit_cast<Lanes::Lanes>(pair));
  store(std::bit_cast<Words>(compress(pair_bits).lanes), waiting.pair + waiting.count);
  waiting.count += static_cast<std::size_t>(std::popcount(bits));
}

/// Adds a single pair, number by number; axis k of the box comes first.
inline void wait_alone(
    Waiting& waiting, const SixteenBoxes& box, int k, const SixteenBoxes& other, std::size_t at,
    float depth, float index, std::uint32_t pair)
{
  const std::size_t place = waiting.count++;
  for (int axis = 0, from = k; axis < 3; ++axis, from = next(from))
  {
    waiting.box.center[axis][place] = box.center[axis][at];
    waiting.other.center[axis][place] = other.center[axis][at];
    waiting.box.half_extents[axis][place] = box.half_extents[from][at];
    waiting.other.half_extents[axis][place] = other.half_extents[axis][at];
    for (int x = 0; x < 3; ++x)
    {
      waiting.box.axes[axis][x][place] = box.axes[from][x][at];
      waiting.other.axes[axis][x][place] = other.axes[axis][x][at];
    }
  }
  waiting.depth[place] = depth;
  waiting.index[place] = index;
  waiting.pair[place] = pair;
}

/// Lets pairs wait whose least overlap is an edge's.
inline void
wait(Waiting& waiting, std::uint32_t bits, const PairsInBlocks& pairs, const LeastEdge<Lanes>& edge)
{
  if constexpr (compresses_at_once)
  {
    const Obb<Lanes> a = boxes_at(pairs.a, pairs.at), b = boxes_at(pairs.b, pairs.at);
    wait_at_once(waiting, bits, a, b, edge.squared_depth, edge.index, pairs.numbers());
    return;
  }
  for (; bits != 0; bits &= bits - 1)
  {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(bits));
    wait_alone(
        waiting, pairs.a, 0, pairs.b, pairs.at + i, edge.squared_depth[i], edge.index[i],
        pairs.first + i);
  }
}

/// Lets pairs wait whose least overlap is a face's: the box with that face, and the axis of the
/// face, come first.
inline void
wait(Waiting& waiting, std::uint32_t bits, const PairsInBlocks& pairs, const LeastFace<Lanes>& face)
{
  if constexpr (compresses_at_once)
  {
    const Obb<Lanes> a = boxes_at(pairs.a, pairs.at), b = boxes_at(pairs.b, pairs.at);
    const FaceOf of(face.index);
    wait_at_once(
        waiting, bits, turned(select(of.a, a, b), of.axis), select(of.a, b, a), face.depth,
        face.index, pairs.numbers());
    return;
  }
  for (; bits != 0; bits &= bits - 1)
  {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(bits));
    const int index = static_cast<int>(face.index[i]);
    const bool of_a = index < 3;
    wait_alone(
        waiting, of_a ? pairs.a : pairs.b, of_a ? index : index - 3, of_a ? pairs.b : pairs.a,
        pairs.at + i, face.depth[i], face.index[i], pairs.first + i);
  }
}

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
