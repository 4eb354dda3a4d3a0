#pragma once

/// \file
/// \brief The inner loop of sphere_pairs: whole registers of pairs, compiled once for each
/// instruction set.

#include <cstddef>

namespace cookbook
{

/// Where eight lists of pairs begin: ax, ay, az, ar, bx, by, bz, br.
struct PairsBegin
{
  const float* list[8];
};

/// Where seven lists of overlaps begin: nx, ny, nz, depth, px, py, pz.
struct OverlapsBegin
{
  float* list[7];
};

/// Answers `count` pairs, a multiple of 16; false if some have squares outside the safe range:
/// their answers are still to be written.
using SpherePairsKernel =
    bool(const PairsBegin& pairs, const OverlapsBegin& overlaps, std::size_t count);

SpherePairsKernel sphere_pairs_portable; ///< for every processor
SpherePairsKernel sphere_pairs_avx2;     ///< for processors with AVX2
SpherePairsKernel sphere_pairs_avx512;   ///< for processors with AVX-512

} // namespace cookbook
