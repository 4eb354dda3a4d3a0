/// \file
/// \brief box_pairs: chooses the instruction set, and answers what its kernel leaves out.

#include "03_sphere_manifolds/sphere_pairs/one_of_kernels.hpp"
#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_pairs/box_pairs.hpp"
#include "04_obb_manifolds/box_pairs/box_pairs_kernel.hpp"
#include "04_obb_manifolds/feature_memory/contact_memory.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace cookbook
{
namespace
{

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

/// Room for the manifolds of so many blocks, whether all are on faces or all on edges.
void make_room(BoxManifolds& manifolds, std::size_t blocks)
{
  if (manifolds.room < blocks)
  {
    auto faces = std::make_unique_for_overwrite<SixteenFaceManifolds[]>(blocks);
    auto edges = std::make_unique_for_overwrite<SixteenEdgeManifolds[]>(blocks);
    manifolds = {std::move(faces), std::move(edges), 0, 0, blocks};
  }
}

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
    const std::optional<Manifold<float>> manifold = box_box(box, other);
    if (manifold && axis_of(manifold) < 6)
    {
      const std::size_t i = manifolds.face_count++;
      set_face(manifolds.faces[i / 16], i % 16, pair, *manifold);
    }
    else if (manifold)
    {
      const std::size_t i = manifolds.edge_count++;
      set_edge(manifolds.edges[i / 16], i % 16, pair, *manifold);
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
  constexpr std::size_t at_once = 16; // blocks: so many are asked again where the kernel left some
  BoxTouchKernel* const kernel = touch_kernel(set);
  for (std::size_t first = 0; first < a.size(); first += at_once)
  {
    const std::size_t count = std::min(at_once, a.size() - first);
    if (kernel(&a[first], &b[first], &touching[first], count))
    {
      continue;
    }
    for (std::size_t block = first; block < first + count; ++block)
    {
      if (!kernel(&a[block], &b[block], &touching[block], 1))
      {
        touch_each(a[block], b[block], touching[block]);
      }
    }
  }
}

} // namespace cookbook
