#pragma once

/// \file
/// \brief The inner loop of box_pairs: whole registers of pairs, compiled once for each instruction
/// set.

#include "04_obb_manifolds/box_pairs/box_pairs.hpp"

namespace cookbook
{

/// Where a kernel writes manifolds, and what it has written. There is room for all pairs of either
/// kind.
struct BoxPairsRoom
{
  SixteenFaceManifolds* faces;
  SixteenEdgeManifolds* edges;
  std::size_t face_count = 0; ///< manifolds
  std::size_t edge_count = 0; ///< manifolds
  bool left_out = false;      ///< whether pairs have sizes whose squares do not fit; not answered
  bool pointless = false;     ///< whether rounding has left a face's manifold without a point
};

/// Writes the manifolds of `count` times sixteen pairs.
using BoxPairsKernel =
    void(const SixteenBoxes* a, const SixteenBoxes* b, std::size_t count, BoxPairsRoom& room);

BoxPairsKernel box_pairs_portable; ///< for every processor
BoxPairsKernel box_pairs_avx2;     ///< for processors with AVX2
BoxPairsKernel box_pairs_avx512;   ///< for processors with AVX-512

/// Sets bit i of a block's word where pair i of its sixteen touches; false if some have sizes
/// outside the safe range: their answers are still to be written.
using BoxTouchKernel =
    bool(const SixteenBoxes* a, const SixteenBoxes* b, std::uint32_t* touching, std::size_t count);

BoxTouchKernel box_pairs_touch_portable; ///< for every processor
BoxTouchKernel box_pairs_touch_avx2;     ///< for processors with AVX2
BoxTouchKernel box_pairs_touch_avx512;   ///< for processors with AVX-512

} // namespace cookbook
