/// \file
/// What holds for the overlap of any two shapes.

#include "02_primitives/overlaps/overlaps.hpp"

#include "tests/02_primitives/shape_pairs.hpp"
#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

using namespace cookbook;

// [overlaps_in_float]
TEST_CASE("45 pairs of shapes in float: as good as float can write the answer", "[overlaps]")
{
  for (const Kinds<float>& kinds : all_kinds<float>())
  {
    for (const Draws draws : all_draws)
    {
      const Wrongs wrongs = check_pairs(kinds, draws, inputs(14'285, 70));
      INFO(kinds.names << ", draws " << int(draws) << ", overlapping " << wrongs.overlapping);
      CHECK(wrongs.fault < 2e-6L);
      CHECK(wrongs.contradictions == 0);
    }
  }
}
// [overlaps_in_float]
