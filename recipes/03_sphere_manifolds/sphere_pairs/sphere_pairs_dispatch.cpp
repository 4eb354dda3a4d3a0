/// \file
/// \brief sphere_pairs: chooses the instruction set, and hands out the pairs in blocks.

#include "03_sphere_manifolds/sphere_pairs/one_of_kernels.hpp"
#include "03_sphere_manifolds/sphere_pairs/sphere_pairs.hpp"
#include "03_sphere_manifolds/sphere_pairs/sphere_pairs_kernel.hpp"
#include "common/simd/stream.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace cookbook
{
namespace
{

constexpr std::size_t least_block = 16; // pairs: what a kernel takes at least
constexpr std::size_t block = 256;      // pairs: with its answers it fits the first-level cache
constexpr std::size_t large = 1 << 16;  // pairs: their answers would drive all else from the cache

SpherePairsKernel* kernel_of(InstructionSet set)
{
#if defined(COOKBOOK_KERNELS_X86)
  return one_of(set, sphere_pairs_portable, sphere_pairs_avx2, sphere_pairs_avx512);
#else
  static_cast<void>(set);
  return sphere_pairs_portable;
#endif
}

PairsBegin begin_at(const SpherePairs& p, std::size_t i)
{
  return {
      {p.ax.data() + i, p.ay.data() + i, p.az.data() + i, p.ar.data() + i, p.bx.data() + i,
       p.by.data() + i, p.bz.data() + i, p.br.data() + i}};
}

OverlapsBegin begin_at(const SphereOverlaps& o, std::size_t i)
{
  return {
      {o.nx.data() + i, o.ny.data() + i, o.nz.data() + i, o.depth.data() + i, o.px.data() + i,
       o.py.data() + i, o.pz.data() + i}};
}

template <class Begin>
Begin advanced(Begin begin, std::size_t by)
{
  for (auto& list : begin.list)
  {
    list += by;
  }
  return begin;
}

// [answer_each]
/// Answers pairs one by one, whatever their size.
void answer_each(const PairsBegin& pairs, const OverlapsBegin& overlaps, std::size_t count)
{
  const auto [ax, ay, az, ar, bx, by, bz, br] = pairs.list;
  const auto [nx, ny, nz, depth, px, py, pz] = overlaps.list;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Sphere<float> a{{ax[i], ay[i], az[i]}, ar[i]};
    const Sphere<float> b{{bx[i], by[i], bz[i]}, br[i]};
    const SphereOverlap<float> overlap = world_overlap(a, b);
    nx[i] = overlap.normal.x();
    ny[i] = overlap.normal.y();
    nz[i] = overlap.normal.z();
    depth[i] = overlap.depth;
    px[i] = overlap.position.x();
    py[i] = overlap.position.y();
    pz[i] = overlap.position.z();
  }
}

/// Answers a block: whole registers by the kernel, pairs that it must not answer one by one.
void answer_block(
    SpherePairsKernel* kernel, const PairsBegin& pairs, const OverlapsBegin& overlaps,
    std::size_t count)
{
  const std::size_t whole = count - count % least_block;
  if (!kernel(pairs, overlaps, whole))
  {
    for (std::size_t i = 0; i < whole; i += least_block)
    {
      if (!kernel(advanced(pairs, i), advanced(overlaps, i), least_block))
      {
        answer_each(advanced(pairs, i), advanced(overlaps, i), least_block);
      }
    }
  }
  answer_each(advanced(pairs, whole), advanced(overlaps, whole), count - whole);
}
// [answer_each]

/// Answers a block beside the lists, and streams the answers there.
void answer_streamed(
    SpherePairsKernel* kernel, const PairsBegin& pairs, const OverlapsBegin& overlaps,
    std::size_t count)
{
  alignas(64) std::array<std::array<float, block>, 7> answers;
  OverlapsBegin kept;
  for (std::size_t k = 0; k < 7; ++k)
  {
    kept.list[k] = answers[k].data();
  }
  answer_block(kernel, pairs, kept, count);
  for (std::size_t k = 0; k < 7; ++k)
  {
    stream(answers[k].data(), overlaps.list[k], count * sizeof(float));
  }
}

void check_lengths(const SpherePairs& p, const SphereOverlaps& o)
{
  for (const std::size_t length :
       {p.ay.size(), p.az.size(), p.ar.size(), p.bx.size(), p.by.size(), p.bz.size(), p.br.size(),
        o.nx.size(), o.ny.size(), o.nz.size(), o.depth.size(), o.px.size(), o.py.size(),
        o.pz.size()})
  {
    if (length != p.ax.size())
    {
      throw std::invalid_argument(
          "sphere_pairs: a list has " + std::to_string(length) + " numbers, ax has " +
          std::to_string(p.ax.size()));
    }
  }
}

} // namespace

// [instruction_sets]
std::vector<InstructionSet> instruction_sets()
{
  std::vector<InstructionSet> sets{InstructionSet::portable};
#if defined(COOKBOOK_KERNELS_X86)
  if (__builtin_cpu_supports("avx2"))
  {
    sets.push_back(InstructionSet::avx2);
  }
  if (__builtin_cpu_supports("avx512f"))
  {
    sets.push_back(InstructionSet::avx512);
  }
#endif
  return sets;
}
// [instruction_sets]

InstructionSet widest_instruction_set()
{
  static const InstructionSet widest = instruction_sets().back();
  return widest;
}

void sphere_pairs(const SpherePairs& pairs, const SphereOverlaps& overlaps, InstructionSet set)
{
  check_lengths(pairs, overlaps);
  SpherePairsKernel* const kernel = kernel_of(set);
  const auto answer = pairs.ax.size() >= large ? answer_streamed : answer_block;
  for (std::size_t i = 0; i < pairs.ax.size(); i += block)
  {
    const std::size_t count = std::min(block, pairs.ax.size() - i);
    answer(kernel, begin_at(pairs, i), begin_at(overlaps, i), count);
  }
  end_of_stream();
}

Lists::Lists(std::size_t count, std::size_t length)
    : length_(length), stride_((length + 1023) / 1024 * 1024 + 80), numbers_(count * stride_ + 16)
{
}

std::size_t Lists::begin(std::size_t k) const
{
  constexpr std::size_t line = 64; // bytes
  const std::size_t past_line = reinterpret_cast<std::uintptr_t>(numbers_.data()) % line;
  return (line - past_line) % line / sizeof(float) + k * stride_;
}

std::span<float> Lists::operator[](std::size_t k)
{
  return {numbers_.data() + begin(k), length_};
}

std::span<const float> Lists::operator[](std::size_t k) const
{
  return {numbers_.data() + begin(k), length_};
}

Lists lists_of_pairs(const std::vector<std::pair<Sphere<float>, Sphere<float>>>& pairs)
{
  Lists lists(8, pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const auto& [a, b] = pairs[i];
    const float numbers[] = {a.center.x(), a.center.y(), a.center.z(), a.radius,
                             b.center.x(), b.center.y(), b.center.z(), b.radius};
    for (std::size_t k = 0; k < 8; ++k)
    {
      lists[k][i] = numbers[k];
    }
  }
  return lists;
}

SpherePairs pairs_of(const Lists& l)
{
  return {l[0], l[1], l[2], l[3], l[4], l[5], l[6], l[7]};
}

Lists lists_of_overlaps(std::size_t length)
{
  return Lists(7, length);
}

SphereOverlaps overlaps_of(Lists& l)
{
  return {l[0], l[1], l[2], l[3], l[4], l[5], l[6]};
}

} // namespace cookbook
