#pragma once

/// \file
/// \brief Pairs of boxes, whether exactly they overlap, and ways to find out.

#include "02_primitives/boxes_overlap/boxes_overlap.hpp"
#include "02_primitives/overlap_chart/trial/known_pair.hpp"
#include "02_primitives/overlaps/overlaps.hpp"
#include "02_primitives/shape_bounds/shape_bounds.hpp"
#include "02_primitives/shapes/trial/in_fractions.hpp"
#include "02_primitives/shapes/trial/number_draw.hpp"

#ifdef COOKBOOK_HAS_FCL
#include <fcl/math/bv/OBB.h>
#endif

#include <vector>

namespace cookbook
{

// [box_pairs]
/// Two boxes, and whether they overlap.
using KnownBoxes = KnownPair<Obb<float>>;

/// Boxes of half extents from 0.2 to 1.4 m, with centres up to `most` m apart along each axis.
/// Every eighth pair is turned alike but for a millionth.
inline std::vector<KnownBoxes> known_boxes_in_pairs(int count, float most)
{
  FloatDraw draw(20261122);
  const auto turn = [&](float most_turn)
  {
    const Vector3<float> half = draw.in_box(-most_turn, most_turn);
    return Quaternion<float>(1, half.x(), half.y(), half.z()).normalized().toRotationMatrix();
  };
  std::vector<KnownBoxes> pairs;
  for (int i = 0; i < count; ++i)
  {
    Obb<float> a{draw.in_box(-1, 1), turn(2), draw.in_box(0.2f, 1.4f)};
    Obb<float> b{a.center + draw.in_box(-most, most), turn(2), draw.in_box(0.2f, 1.4f)};
    if (i % 8 == 0)
    {
      b.axes = turn(1e-6f) * a.axes;
    }
    pairs.push_back({a, b, boxes_overlap(in_fractions(a), in_fractions(b))});
  }
  return pairs;
}
// [box_pairs]

/// Spheres first, which is soon done for boxes that are far apart.
inline bool overlap_spheres_first(const Obb<float>& a, const Obb<float>& b)
{
  return spheres_around_overlap(a, b) && boxes_overlap(a, b);
}

/// The boxes along the world's axes around both.
inline bool bounds_overlap(const Obb<float>& a, const Obb<float>& b)
{
  return bounds_of(a).intersects(bounds_of(b));
}

#ifdef COOKBOOK_HAS_FCL
/// FCL's boxes, made for each question as ours are given.
inline bool fcl_overlap(const Obb<float>& a, const Obb<float>& b)
{
  const fcl::OBB<float> one(a.axes, a.center, a.half_extents);
  return one.overlap(fcl::OBB<float>(b.axes, b.center, b.half_extents));
}
#endif

} // namespace cookbook
