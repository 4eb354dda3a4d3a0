#pragma once

/// \file
/// \brief Many pairs of boxes at once: the same formulas, one pair in every lane of a register.

#include "02_primitives/shapes/shapes.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "03_sphere_manifolds/sphere_pairs/sphere_pairs.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [box_pairs]
/// Sixteen boxes side by side: number i of every row belongs to box i.
struct alignas(64) SixteenBoxes
{
  float center[3][16];       ///< [m], world: x, y, z
  float axes[3][3][16];      ///< [1]: axis 0, 1, 2, of each its x, y, z in the world
  float half_extents[3][16]; ///< [m], along each axis
};

/// Sixteen manifolds of pairs that meet with a face, side by side.
struct alignas(64) SixteenFaceManifolds
{
  std::uint32_t pair[16];    ///< which pair each is of
  float normal[3][16];       ///< [1], unit, world, from A to B
  float depth[16];           ///< [m], the whole overlap
  std::uint32_t kept[16];    ///< bit s is set where there is a point in slot s
  std::uint32_t feature[16]; ///< of slot 0; that of slot s is by s more
  float position[8][3][16];  ///< [m], world, for every slot x, y, z; meant where a point is kept
  float point_depth[8][16];  ///< [m], for every slot
};

/// Sixteen manifolds of pairs that meet with edges, in one point each.
struct alignas(64) SixteenEdgeManifolds
{
  std::uint32_t pair[16];    ///< which pair each is of
  float normal[3][16];       ///< [1], unit, world, from A to B
  float depth[16];           ///< [m], the whole overlap, and the point's
  std::uint32_t feature[16]; ///< of the point
  float position[3][16];     ///< [m], world: x, y, z
};

/// The manifolds of the pairs that touch, by what they meet with; number i of a kind is number
/// i % 16 of block i / 16. Their order within a kind is not that of the pairs.
struct BoxManifolds
{
  std::unique_ptr<SixteenFaceManifolds[]> faces;
  std::unique_ptr<SixteenEdgeManifolds[]> edges;
  std::size_t face_count = 0; ///< manifolds
  std::size_t edge_count = 0; ///< manifolds
  std::size_t room = 0;       ///< blocks of each kind
};

/// The manifolds of all pairs of boxes, equal to those of `box_box` to the last bit.
///
/// The lists have one length, std::invalid_argument otherwise, and 2³² pairs at most; room is made
/// where `manifolds` has too little, so that the next frame need make none. What `box_box` says of
/// sizes and degenerate boxes holds here; fill a last block that is not full with boxes that are
/// apart. All instruction sets give the same bits, though not in the same order.
void box_pairs(
    std::span<const SixteenBoxes> a, std::span<const SixteenBoxes> b, BoxManifolds& manifolds,
    InstructionSet set = widest_instruction_set());
// [box_pairs]

// [box_pairs_touch]
/// Only whether boxes touch: bit i of a block's word is set where `box_box` of its pair i gives a
/// manifold; bits 16 and up are not.
///
/// Lists, sizes and instruction sets as of `box_pairs`.
void box_pairs_touch(
    std::span<const SixteenBoxes> a, std::span<const SixteenBoxes> b,
    std::span<std::uint32_t> touching, InstructionSet set = widest_instruction_set());
// [box_pairs_touch]

// [blocks]
/// Pairs of boxes, sixteen to a block: pair i is number i % 16 of block i / 16.
struct BoxBlocks
{
  std::vector<SixteenBoxes> a; ///< the boxes A
  std::vector<SixteenBoxes> b; ///< as many: the boxes B
};

/// The pairs in blocks; a last block that is not full is filled with cubes that are apart.
BoxBlocks blocks_of(std::span<const std::pair<Obb<float>, Obb<float>>> pairs);

/// Writes box i into its block.
void set_box(std::span<SixteenBoxes> boxes, std::size_t i, const Obb<float>& box);

/// Box i.
Obb<float> box_at(std::span<const SixteenBoxes> boxes, std::size_t i);

/// A manifold, and which pair it is of.
struct PairManifold
{
  std::size_t pair;         ///< counted through all blocks
  Manifold<float> manifold; ///< as `box_box` gives it: the same points in the same order
};

/// Manifold i of those on faces, i < face_count.
PairManifold face_manifold_at(const BoxManifolds& manifolds, std::size_t i);

/// Manifold i of those on edges, i < edge_count.
PairManifold edge_manifold_at(const BoxManifolds& manifolds, std::size_t i);

/// What `box_box` says of each of so many pairs, in their order.
std::vector<std::optional<Manifold<float>>>
in_order(const BoxManifolds& manifolds, std::size_t pairs);

/// All of it for pairs that are not in blocks: what `box_box` says of each.
std::vector<std::optional<Manifold<float>>> box_pairs_in_order(
    std::span<const std::pair<Obb<float>, Obb<float>>> pairs,
    InstructionSet set = widest_instruction_set());

/// Whether pair i touches.
inline bool touches_at(std::span<const std::uint32_t> touching, std::size_t i)
{
  return (touching[i / 16] >> i % 16 & 1) != 0;
}
// [blocks]

} // namespace cookbook
