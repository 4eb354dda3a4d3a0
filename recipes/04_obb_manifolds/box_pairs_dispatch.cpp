/// \file
/// \brief box_pairs: chooses the instruction set, hands out the blocks, fills and reads them.

#include "04_obb_manifolds/box_box.hpp"
#include "04_obb_manifolds/box_pairs.hpp"
#include "04_obb_manifolds/box_pairs_kernel.hpp"
#include "common/math/stream.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>

namespace cookbook
{
namespace
{

constexpr std::size_t at_once = 16; // blocks: what a kernel is handed
constexpr std::size_t near_by = 4;  // blocks: their manifolds fit the first-level cache
constexpr std::size_t large =
    1 << 12; // blocks: their manifolds would drive all else from the cache

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

/// Writes what `box_box` says of pair i; the low three bits of a point's feature are its slot.
void set_manifold(
    SixteenManifolds& block, std::size_t i, const std::optional<Manifold<float>>& manifold)
{
  block.depth[i] = manifold ? manifold->depth : -1.0f;
  block.kept[i] = 0;
  block.feature[i] = manifold ? manifold->points[0].feature & ~7u : 0;
  for (int x = 0; x < 3; ++x)
  {
    block.normal[x][i] = manifold ? manifold->normal[x] : 0.0f;
  }
  for (std::size_t point = 0; manifold && point < manifold->points.size(); ++point)
  {
    const ContactPoint<float>& contact = manifold->points[point];
    const std::uint32_t slot = contact.feature & 7u;
    block.kept[i] |= 1u << slot;
    block.point_depth[slot][i] = contact.depth;
    for (int x = 0; x < 3; ++x)
    {
      block.position[slot][x][i] = contact.position[x];
    }
  }
}

// [answer_each]
/// Answers the pairs of a block one by one, whatever their size.
void answer_each(const SixteenBoxes& a, const SixteenBoxes& b, SixteenManifolds& manifolds)
{
  for (std::size_t i = 0; i < 16; ++i)
  {
    set_manifold(manifolds, i, box_box(box_at({&a, 1}, i), box_at({&b, 1}, i)));
  }
}

/// The same where only a yes or no is asked for.
void answer_each(const SixteenBoxes& a, const SixteenBoxes& b, std::uint32_t& touching)
{
  touching = 0;
  for (std::size_t i = 0; i < 16; ++i)
  {
    touching |= box_box(box_at({&a, 1}, i), box_at({&b, 1}, i)) ? 1u << i : 0u;
  }
}

/// Answers blocks by the kernel, and those that it must not answer pair by pair.
template <class Kernel, class Answer>
void answer(
    Kernel* kernel, std::span<const SixteenBoxes> a, std::span<const SixteenBoxes> b,
    std::span<Answer> answers)
{
  for (std::size_t first = 0; first < a.size(); first += at_once)
  {
    const std::size_t count = std::min(at_once, a.size() - first);
    if (kernel(&a[first], &b[first], &answers[first], count))
    {
      continue;
    }
    for (std::size_t i = first; i < first + count; ++i)
    {
      if (!kernel(&a[i], &b[i], &answers[i], 1))
      {
        answer_each(a[i], b[i], answers[i]);
      }
    }
  }
}
// [answer_each]

// [stream]
/// Copies manifolds past the cache, without the slots in which no pair has a point.
void stream_manifolds(const SixteenManifolds& from, SixteenManifolds& to)
{
  const std::uint32_t kept =
      std::accumulate(from.kept, from.kept + 16, std::uint32_t(0), std::bit_or());
  stream(&from, &to, offsetof(SixteenManifolds, position));
  for (std::size_t slot = 0; slot < 8; ++slot)
  {
    if ((kept >> slot & 1) != 0)
    {
      stream(from.position[slot], to.position[slot], sizeof to.position[slot]);
      stream(from.point_depth[slot], to.point_depth[slot], sizeof to.point_depth[slot]);
    }
  }
}

/// Answers a few blocks at a time beside the list, and streams the answers there.
void answer_streamed(
    BoxPairsKernel* kernel, std::span<const SixteenBoxes> a, std::span<const SixteenBoxes> b,
    std::span<SixteenManifolds> manifolds)
{
  std::array<SixteenManifolds, near_by> near;
  for (std::size_t first = 0; first < a.size(); first += near_by)
  {
    const std::size_t count = std::min(near_by, a.size() - first);
    answer(kernel, a.subspan(first, count), b.subspan(first, count), std::span(near).first(count));
    for (std::size_t i = 0; i < count; ++i)
    {
      stream_manifolds(near[i], manifolds[first + i]);
    }
  }
  end_of_stream();
}
// [stream]

void check_lengths(const std::string& function, std::size_t a, std::size_t b, std::size_t answers)
{
  if (b != a || answers != a)
  {
    throw std::invalid_argument(
        function + ": the lists must have one length, got " + std::to_string(a) +
        " blocks of boxes A, " + std::to_string(b) + " of boxes B and " + std::to_string(answers) +
        " for the answers");
  }
}

} // namespace

void box_pairs(
    std::span<const SixteenBoxes> a, std::span<const SixteenBoxes> b,
    std::span<SixteenManifolds> manifolds, InstructionSet set)
{
  check_lengths("box_pairs", a.size(), b.size(), manifolds.size());
  const auto answer_all =
      a.size() >= large ? answer_streamed : answer<BoxPairsKernel, SixteenManifolds>;
  answer_all(manifolds_kernel(set), a, b, manifolds);
}

void box_pairs_touch(
    std::span<const SixteenBoxes> a, std::span<const SixteenBoxes> b,
    std::span<std::uint32_t> touching, InstructionSet set)
{
  check_lengths("box_pairs_touch", a.size(), b.size(), touching.size());
  answer(touch_kernel(set), a, b, touching);
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

std::optional<Manifold<float>>
manifold_at(std::span<const SixteenManifolds> manifolds, std::size_t i)
{
  const SixteenManifolds& block = manifolds[i / 16];
  const std::size_t lane = i % 16;
  if (block.kept[lane] == 0)
  {
    return std::nullopt;
  }
  const auto vector = [lane](const float(&rows)[3][16])
  { return Vector3<float>(rows[0][lane], rows[1][lane], rows[2][lane]); };
  Manifold<float> manifold{vector(block.normal), block.depth[lane], {}};
  for (std::uint32_t slot = 0; slot < 8; ++slot)
  {
    if ((block.kept[lane] >> slot & 1) != 0)
    {
      manifold.points.push_back(
          {vector(block.position[slot]), block.point_depth[slot][lane],
           block.feature[lane] + slot});
    }
  }
  return manifold;
}

} // namespace cookbook
