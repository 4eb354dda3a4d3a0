#pragma once

/// \file
/// \brief How often the published code is wrong about two boxes, for each fault alone and for all.

#include "04_obb_manifolds/box_as_published/trial/box_as_published_pairs.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace cookbook
{

/// The published code with some faults in.
struct FaultVariant
{
  std::string id;         ///< such as X08
  std::string what;       ///< the fault in a few words
  PublishedFaults faults; ///< what is in
};

/// All faults mended but one.
inline PublishedFaults only(bool PublishedFaults::*fault)
{
  PublishedFaults faults = no_faults;
  faults.*fault = true;
  return faults;
}

/// Each fault that can be counted alone, then all together, then none.
inline std::vector<FaultVariant> fault_variants()
{
  using Faults = PublishedFaults;
  return {
      {"X08", "A's axes crossed with A's", only(&Faults::crosses_a_with_a)},
      {"X09", "negative components erased", only(&Faults::erases_negatives)},
      {"X10", "A's shadow against A's", only(&Faults::casts_a_twice)},
      {"X11", "depth by union", only(&Faults::measures_union)},
      {"X12", "normal turned by shadows' begin", only(&Faults::turns_by_begin)},
      {"X13", "touching dropped", only(&Faults::drops_touching)},
      {"X14", "short axes dropped", only(&Faults::drops_short_axes)},
      {"X15", "points tested bare", only(&Faults::tests_points_bare)},
      {"X16", "points 1 cm apart merged", only(&Faults::merges_within_1_cm)},
      {"all", "as published", Faults()},
      {"none", "all mended", no_faults}};
}

// [fault_counts]
/// How often an answer was wrong, and of how many it could have been.
struct FaultCounts
{
  std::size_t apart = 0;       ///< pairs that are apart
  std::size_t hit = 0;         ///< of these: said to overlap
  std::size_t overlapping = 0; ///< pairs that overlap
  std::size_t missed = 0;      ///< of these: said to be apart
  std::size_t reversed = 0;    ///< of the others: the normal points from B to A
  std::size_t off_depth = 0;   ///< the depth is off by more than a twentieth
  std::size_t asked = 0;       ///< overlapping pairs whose points were asked for
  std::size_t lost = 0;        ///< of these: a point is missing that the mended code has
};

/// Counts what is wrong about the overlap of a pair that overlaps.
inline void
count_overlap(const CheckedPair& pair, const PublishedFaults& faults, FaultCounts& counts)
{
  const auto found = least_as_published(pair.a, pair.b, faults);
  ++counts.overlapping;
  if (!found)
  {
    ++counts.missed;
    return;
  }
  const double level = 1e-9 * pair_size(pair.a, pair.b);
  counts.reversed += found->normal.dot(pair.b.center - pair.a.center) < -level ? 1 : 0;
  counts.off_depth += std::abs(found->depth - pair.depth) > pair.depth / 20 ? 1 : 0;
  if (!pair.points.empty())
  {
    ++counts.asked;
    counts.lost += lacks_point(pair, *box_as_published(pair.a, pair.b, faults)) ? 1 : 0;
  }
}

/// Counts what a variant gets wrong; X10 is a fault of the yes-or-no test and counts there alone.
inline FaultCounts
count_faults(const std::vector<CheckedPair>& pairs, const PublishedFaults& faults)
{
  FaultCounts counts;
  const bool yes_or_no = faults.casts_a_twice && !faults.drops_touching;
  for (const CheckedPair& pair : pairs)
  {
    if (pair.depth >= 0)
    {
      count_overlap(pair, faults, counts);
      continue;
    }
    ++counts.apart;
    const bool hit = yes_or_no ? overlap_as_published(pair.a, pair.b, faults)
                               : least_as_published(pair.a, pair.b, faults).has_value();
    counts.hit += hit ? 1 : 0;
  }
  return counts;
}
// [fault_counts]

} // namespace cookbook
