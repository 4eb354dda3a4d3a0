/// \file
/// \brief A crane: a trolley on a rail, and a crate on a rope of ten links below it.

// [example]
#include "07_constraints/articulated/articulated.hpp"
#include "07_constraints/articulated/hanging_chain.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  Link trolley{.joint = JointType::slider, .axis = {1, 0, 0}};
  trolley.solid = solid_box<double>(50, {0.3, 0.1, 0.3});
  ArticulatedBody crane(with_chain({trolley}, 0, {.links = 10, .load = 200}));
  TreeState state = zero_state(crane.links());
  crane.drive[0] = 500; // N, of the trolley's motor
  for (int step = 0; step < 2 * 240; ++step)
    semi_implicit_step(crane, state, 1 / 240.0);
  const Motion<double> crate = link_bodies(crane, state).back().motion;
  std::printf("trolley at %.2f m, crate at %.2f m\n", state.positions[0], crate.center.x());
}
// [example]
