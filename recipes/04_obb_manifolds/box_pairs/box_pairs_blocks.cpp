/// \file
/// \brief Filling the blocks of box_pairs, and reading them.

#include "04_obb_manifolds/box_pairs/box_pairs.hpp"

namespace cookbook
{
namespace
{

/// The i-th of vectors side by side.
Vector3<float> vector_at(const float (&rows)[3][16], std::size_t i)
{
  return {rows[0][i], rows[1][i], rows[2][i]};
}

} // namespace

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

std::vector<std::optional<Manifold<float>>>
box_pairs_in_order(std::span<const std::pair<Obb<float>, Obb<float>>> pairs, InstructionSet set)
{
  const BoxBlocks blocks = blocks_of(pairs);
  BoxManifolds manifolds;
  box_pairs(blocks.a, blocks.b, manifolds, set);
  return in_order(manifolds, pairs.size());
}

} // namespace cookbook
