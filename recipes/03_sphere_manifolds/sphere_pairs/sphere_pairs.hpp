#pragma once

/// \file
/// \brief Many pairs of spheres at once: the same formula, one pair in every lane of a register.

#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

// [sphere_pairs]
/// Pairs of spheres A and B as eight lists of one length; list `ax` holds the x of all A's.
struct SpherePairs
{
  std::span<const float> ax, ay, az; ///< [m], world, centres of the A's
  std::span<const float> ar;         ///< [m], radii of the A's
  std::span<const float> bx, by, bz; ///< [m], world, centres of the B's
  std::span<const float> br;         ///< [m], radii of the B's
};

/// What is found of the pairs, as seven lists of the pairs' length, which overlap no other list.
struct SphereOverlaps
{
  std::span<float> nx, ny, nz; ///< [1], unit, world, from A to B, also where they are apart
  std::span<float> depth;      ///< [m], the whole overlap; negative: apart, by that gap
  std::span<float> px, py, pz; ///< [m], world, midway between the two surfaces
};

/// Registers of this width are used where the processor has them.
enum class InstructionSet
{
  portable, ///< 4 pairs at once
  avx2,     ///< 8 pairs at once
  avx512    ///< 16 pairs at once
};

/// An instruction set in words.
inline std::string name_of(InstructionSet set)
{
  return set == InstructionSet::avx512 ? "AVX-512"
         : set == InstructionSet::avx2 ? "AVX2"
                                       : "portable";
}

/// The instruction sets that this processor and this build have; the last is the widest.
std::vector<InstructionSet> instruction_sets();

/// The last of them.
InstructionSet widest_instruction_set();

/// The overlaps of all pairs; each equals `sphere_sphere` of the pair to the last bit.
///
/// Any finite centres and radii; concentric spheres separate along +y. Lists need no alignment. All
/// instruction sets give the same bits.
void sphere_pairs(
    const SpherePairs& pairs, const SphereOverlaps& overlaps,
    InstructionSet set = widest_instruction_set());
// [sphere_pairs]

/// Lists of one length that own their memory, for pairs and overlaps.
///
/// Each begins a few cache lines later within its page than the one before: lists that begin alike
/// compete for the same few places of the cache, and the pairs then take up to twice the time.
class Lists
{
public:
  /// So many lists, so long, all zero.
  Lists(std::size_t count, std::size_t length);

  std::span<float> operator[](std::size_t k);             ///< the k-th list, to write to
  std::span<const float> operator[](std::size_t k) const; ///< the k-th list
  std::size_t length() const { return length_; }          ///< of every list

private:
  std::size_t begin(std::size_t k) const;

  std::size_t length_;
  std::size_t stride_;
  std::vector<float> numbers_;
};

/// Eight lists that hold these pairs, each a sphere A and a sphere B.
Lists lists_of_pairs(const std::vector<std::pair<Sphere<float>, Sphere<float>>>& pairs);

/// The eight lists as pairs.
SpherePairs pairs_of(const Lists& lists);

/// Seven lists to hold the overlaps of so many pairs.
Lists lists_of_overlaps(std::size_t length);

/// The seven lists as overlaps.
SphereOverlaps overlaps_of(Lists& lists);

} // namespace cookbook
