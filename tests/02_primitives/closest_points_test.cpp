/// \file
/// What holds for the closest points of any two shapes, judged by what lies in the shapes and on
/// which side of a plane they lie.

#include "02_primitives/closest_points/closest_points_plane.hpp"

#include "tests/02_primitives/shape_pairs.hpp"
#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

using namespace cookbook;

// [all_pairs]
TEST_CASE("45 pairs of shapes: closest points are in them, and no others are closer", "[P1][P2]")
{
  const std::vector<Kinds<double>> all = all_kinds<double>();
  CHECK(all.size() == 45);
  for (const Kinds<double>& kinds : all)
  {
    for (const Draws draws : all_draws)
    {
      const Wrongs wrongs = judge_pairs(kinds, draws, random_inputs / 7);
      INFO(kinds.names << ", draws " << int(draws) << ", overlapping " << wrongs.overlapping);
      CHECK(wrongs.fault < 4e-12L);
      CHECK(wrongs.contradictions == 0);
      CHECK(wrongs.moved_wrongly == 0);
      CHECK(wrongs.touch < (draws == Draws::thin ? 2e-8L : 4e-12L));
    }
  }
}
// [all_pairs]
