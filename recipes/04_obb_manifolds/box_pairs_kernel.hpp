#pragma once

/// \file
/// \brief The inner loop of box_pairs: whole registers of pairs, compiled once for each instruction
/// set.

#include "04_obb_manifolds/box_pairs.hpp"

namespace cookbook
{

/// Answers `count` times sixteen pairs; false if some have sizes outside the safe range: their
/// answers are still to be written.
using BoxPairsKernel = bool(
    const SixteenBoxes* a, const SixteenBoxes* b, SixteenManifolds* manifolds, std::size_t count);

BoxPairsKernel box_pairs_portable; ///< for every processor
BoxPairsKernel box_pairs_avx2;     ///< for processors with AVX2
BoxPairsKernel box_pairs_avx512;   ///< for processors with AVX-512

/// Sets bit i of a block's word where pair i of its sixteen touches; false as above.
using BoxTouchKernel = bool(
    const SixteenBoxes* a, const SixteenBoxes* b, std::uint32_t* touching, std::size_t count);

BoxTouchKernel box_pairs_touch_portable; ///< for every processor
BoxTouchKernel box_pairs_touch_avx2;     ///< for processors with AVX2
BoxTouchKernel box_pairs_touch_avx512;   ///< for processors with AVX-512

} // namespace cookbook
