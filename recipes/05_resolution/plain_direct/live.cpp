/// \file
/// \brief A stack under each solver: impulses, soft steps, corrected positions, one system.

#include "05_resolution/plain_direct/plain_direct.hpp"
#include "05_resolution/plain_positions/plain_positions.hpp"
#include "05_resolution/plain_positions/trial/plain_scenes.hpp"
#include "05_resolution/small_world/step_2.hpp"
#include "05_resolution/small_world/step_7.hpp"
#include "05_resolution/small_world/trial/live_world.hpp"

namespace cookbook::live
{

namespace
{

using namespace small_world;

/// Loads and stacks that a dense system of equations can hold.
struct SolverScenes
{
  static constexpr int most_balls = 4; ///< that may be thrown at a scene

  /// The list of them.
  template <class World>
  static std::vector<LiveScene<World>> list()
  {
    const Vector3<double> front = from_the_front;
    return {
        {"1,000 kg on 1 kg", [] { return heavy_on_light<World>(1000); }, 7, 1.5, front},
        {"100 kg on 1 kg", [] { return heavy_on_light<World>(100); }, 7, 1.5, front},
        {"tower of 5", [] { return tower<World>(5); }, 11, 3, front},
        {"tower of 10", [] { return tower<World>(10); }, 16, 6, front},
        {"pyramid of 10", [] { return pyramid<World>(4); }, 10, 2, front}};
  }
};

} // namespace

void figure(Page& page)
{
  static LiveWorlds<
      SolverScenes, step_2::World, step_7::World, plain_positions::World, plain_direct::World>
      worlds;
  const int solver = page.choice(
      "solver",
      {"impulses (step 2)", "soft steps (small world)", "corrected positions", "direct solver"}, 1);
  worlds.show(page, solver);
}

} // namespace cookbook::live
