/// \file
/// \brief box_pairs: chooses the instruction set, hands out the blocks, fills and reads them.

#include "04_obb_manifolds/box_box.hpp"
#include "04_obb_manifolds/box_pairs.hpp"
#include "04_obb_manifolds/box_pairs_kernel.hpp"
#include "04_obb_manifolds/feature_memory.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace cookbook
{
namespace
{

/// The kernel for an instruction set.
template <class Kernel>
Kernel* one_of(InstructionSet set, Kernel* portable, Kernel* avx2, Kernel* avx512)
{
  switch (set)
  {
  case InstructionSet::avx2:
    return avx2;
  case InstructionSet::avx512:
    return avx512;
  case InstructionSet::portable:
    return portable;
  }
  return portable;
}

#if defined(COOKBOOK_KERNELS_X86)
BoxPairsKernel* manifolds_kernel(InstructionSet set)
{
  return one_of(set, box_pairs_portable, box_pairs_avx2, box_pairs_avx512);
}

BoxTouchKernel* touch_kernel(InstructionSet set)
{
  return one_of(set, box_pairs_touch_portable, box_pairs_touch_avx2, box_pairs_touch_avx512);
}
#else
BoxPairsKernel* manifolds_kernel(InstructionSet)
{
  return box_pairs_portable;
}

BoxTouchKernel* touch_kernel(InstructionSet)
{
  return box_pairs_touch_portable;
}
#endif

// [make_room]
/// Room for the manifolds of so many blocks, whether all are on faces or all on edges.
void make_room(BoxManifolds& manifolds, std::size_t blocks)
{
  if (manifolds.room < blocks)
  {
    manifolds.faces = std::make_unique_for_overwrite<SixteenFaceManifolds[]>(blocks);
    manifolds.edges = std::make_unique_for_overwrite<SixteenEdgeManifolds[]>(blocks);
    manifolds.room = blocks;
  }
}
// [make_room]

/// Writes what all kinds of manifolds have, at place i.
template <class Block>
void set_common(Block& block, std::size_t i, std::size_t pair, const Manifold<float>& manifold)
{
  block.pair[i] = static_cast<std::uint32_t>(pair);
  block.depth[i] = manifold.depth;
  for (int x = 0; x < 3; ++x)
  {
    block.normal[x][i] = manifold.normal[x];
  }
}

/// Writes a face's manifold; the low three bits of a point's feature are its slot.
void set_face(
    SixteenFaceManifolds& block, std::size_t i, std::size_t pair, const Manifold<float>& manifold)
{
  set_common(block, i, pair, manifold);
  block.kept[i] = 0;
  block.feature[i] = manifold.points[0].feature & ~7u;
  for (const ContactPoint<float>& point : manifold.points)
  {
    const std::uint32_t slot = point.feature & 7u;
    block.kept[i] |= 1u << slot;
    block.point_depth[slot][i] = point.depth;
    for (int x = 0; x < 3; ++x)
    {
      block.position[slot][x][i] = point.position[x];
    }
  }
}

/// Writes the manifold of two edges.
void set_edge(
    SixteenEdgeManifolds& block, std::size_t i, std::size_t pair, const Manifold<float>& manifold)
{
  set_common(block, i, pair, manifold);
  block.feature[i] = manifold.points[0].feature;
  for (int x = 0; x < 3; ++x)
  {
    block.position[x][i] = manifold.points[0].position[x];
  }
}

// [answer_rest]
/// Adds by `box_box` what the kernel has left out: pairs of sizes whose squares do not fit.
void add_left_out(
    std::span<const SixteenBoxes> a, std::span<const SixteenBoxes> b, BoxManifolds& manifolds)
{
  for (std::size_t pair = 0; pair < 16 * a.size(); ++pair)
  {
    const Obb<float> box = box_at(a, pair), other = box_at(b, pair);
    if (has_moderate_size(tolerances_of(box, other).size))
    {
      continue;
    }
    if (const std::optional<Manifold<float>> manifold = box_box(box, other))
    {
      const bool on_face = axis_of_feature(manifold->points[0].feature) < 6;
      std::size_t& count = on_face ? manifolds.face_count : manifolds.edge_count;
      const std::size_t block = count / 16, at = count % 16;
      on_face ? set_face(manifolds.faces[block], at, pair, *manifold)
              : set_edge(manifolds.edges[block], at, pair, *manifold);
      ++count;
    }
  }
}

/// Writes again by `box_box` those manifolds on faces in which rounding has left no point.
void mend_pointless(
    std::span<const SixteenBoxes> a, std::span<const SixteenBoxes> b, BoxManifolds& manifolds)
{
  for (std::size_t i = 0; i < manifolds.face_count; ++i)
  {
    SixteenFaceManifolds& block = manifolds.faces[i / 16];
    if (block.kept[i % 16] == 0)
    {
      const std::size_t pair = block.pair[i % 16];
      set_face(block, i % 16, pair, *box_box(box_at(a, pair), box_at(b, pair)));
    }
  }
}
// [answer_rest]

/// The i-th of vectors side by side.
Vector3<float> vector_at(const float (&rows)[3][16], std::size_t i)
{
  return {rows[0][i], rows[1][i], rows[2][i]};
}

/// Answers the pairs of a block one by one, only with a yes or no.
void touch_each(const SixteenBoxes& a, const SixteenBoxes& b, std::uint32_t& touching)
{
  touching = 0;
  for (std::size_t i = 0; i < 16; ++i)
  {
    touching |= box_box(box_at({&a, 1}, i), box_at({&b, 1}, i)) ? 1u << i : 0u;
  }
}

void check_lengths(const std::string& function, std::size_t a, std::size_t b)
{
  if (b != a)
  {
    throw std::invalid_argument(
        function + ": the lists must have one length, got " + std::to_string(a) +
        " blocks of boxes A and " + std::to_string(b) + " of boxes B");
  }
}

} // namespace

void box_pairs(
    std::span<const SixteenBoxes> a, std::span<const SixteenBoxes> b, BoxManifolds& manifolds,
    InstructionSet set)
{
  check_lengths("box_pairs", a.size(), b.size());
  make_room(manifolds, a.size());
  BoxPairsRoom room{manifolds.faces.get(), manifolds.edges.get()};
  manifolds_kernel(set)(a.data(), b.data(), a.size(), room);
  manifolds.face_count = room.face_count;
  manifolds.edge_count = room.edge_count;
  if (room.pointless)
  {
    mend_pointless(a, b, manifolds);
  }
  if (room.left_out)
  {
    add_left_out(a, b, manifolds);
  }
}

void box_pairs_touch(
    std::span<const SixteenBoxes> a, std::span<const SixteenBoxes> b,
    std::span<std::uint32_t> touching, InstructionSet set)
{
  check_lengths("box_pairs_touch", a.size(), b.size());
  if (touching.size() != a.size())
  {
    throw std::invalid_argument(
        "box_pairs_touch: there are " + std::to_string(a.size()) + " blocks of boxes, and " +
        std::to_string(touching.size()) + " words for their answers");
  }
  BoxTouchKernel* const kernel = touch_kernel(set);
  if (!kernel(a.data(), b.data(), touching.data(), a.size()))
  {
    for (std::size_t block = 0; block < a.size(); ++block)
    {
      if (!kernel(&a[block], &b[block], &touching[block], 1))
      {
        touch_each(a[block], b[block], touching[block]);
      }
    }
  }
}

BoxBlocks blocks_of(std::span<const std::pair<Obb<float>, Obb<float>>> pairs)
{
  const std::size_t count = (pairs.size() + 15) / 16;
  BoxBlocks blocks{std::vector<SixteenBoxes>(count), std::vector<SixteenBoxes>(count)};
  const Matrix3<float> upright = Matrix3<float>::Identity();
  const Obb<float> cube{{0, 0, 0}, upright, {1, 1, 1}}, other{{4, 0, 0}, upright, {1, 1, 1}};
  for (std::size_t i = 0; i < 16 * count; ++i)
  {
    set_box(blocks.a, i, i < pairs.size() ? pairs[i].first : cube);
    set_box(blocks.b, i, i < pairs.size() ? pairs[i].second : other);
  }
  return blocks;
}

void set_box(std::span<SixteenBoxes> boxes, std::size_t i, const Obb<float>& box)
{
  SixteenBoxes& block = boxes[i / 16];
  for (int x = 0; x < 3; ++x)
  {
    block.center[x][i % 16] = box.center[x];
    block.half_extents[x][i % 16] = box.half_extents[x];
    for (int axis = 0; axis < 3; ++axis)
    {
      block.axes[axis][x][i % 16] = box.axes(x, axis);
    }
  }
}

Obb<float> box_at(std::span<const SixteenBoxes> boxes, std::size_t i)
{
  const SixteenBoxes& block = boxes[i / 16];
  Obb<float> box;
  for (int x = 0; x < 3; ++x)
  {
    box.center[x] = block.center[x][i % 16];
    box.half_extents[x] = block.half_extents[x][i % 16];
    for (int axis = 0; axis < 3; ++axis)
    {
      box.axes(x, axis) = block.axes[axis][x][i % 16];
    }
  }
  return box;
}

PairManifold face_manifold_at(const BoxManifolds& manifolds, std::size_t i)
{
  const SixteenFaceManifolds& block = manifolds.faces[i / 16];
  const std::size_t at = i % 16;
  PairManifold result{block.pair[at], {vector_at(block.normal, at), block.depth[at], {}}};
  for (std::uint32_t slot = 0; slot < 8; ++slot)
  {
    if ((block.kept[at] >> slot & 1) != 0)
    {
      result.manifold.points.push_back(
          {vector_at(block.position[slot], at), block.point_depth[slot][at],
           block.feature[at] + slot});
    }
  }
  return result;
}

PairManifold edge_manifold_at(const BoxManifolds& manifolds, std::size_t i)
{
  const SixteenEdgeManifolds& block = manifolds.edges[i / 16];
  const std::size_t at = i % 16;
  PairManifold result{block.pair[at], {vector_at(block.normal, at), block.depth[at], {}}};
  result.manifold.points.push_back(
      {vector_at(block.position, at), block.depth[at], block.feature[at]});
  return result;
}

std::vector<std::optional<Manifold<float>>>
in_order(const BoxManifolds& manifolds, std::size_t pairs)
{
  std::vector<std::optional<Manifold<float>>> all(pairs);
  const auto put = [&](const PairManifold& found)
  {
    if (found.pair < pairs)
    {
      all[found.pair] = found.manifold;
    }
  };
  for (std::size_t i = 0; i < manifolds.face_count; ++i)
  {
    put(face_manifold_at(manifolds, i));
  }
  for (std::size_t i = 0; i < manifolds.edge_count; ++i)
  {
    put(edge_manifold_at(manifolds, i));
  }
  return all;
}

} // namespace cookbook
