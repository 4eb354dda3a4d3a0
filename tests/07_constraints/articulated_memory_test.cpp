/// \file
/// That a tree of links asks for memory when it is made, and then no more.

#include "06_world/game_world/trial/counted_allocations.hpp"
#include "07_constraints/articulated/trial/articulated_scenes.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

TEST_CASE("neither the accelerations of a tree nor its steps ask for memory")
{
  NumberDraw<double> draw(10);
  std::vector<Link> links = drawn_links(draw, 20);
  ArticulatedBody tree(links);
  TreeState state = drawn_state(draw, links);
  const long before = counted_allocations();
  tree.accelerations(state);
  semi_implicit_step(tree, state, 0.001);
  rk4_step(tree, state, 0.001);
  CHECK(counted_allocations() == before);
}
