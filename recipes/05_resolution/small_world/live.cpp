/// \file
/// \brief The seven steps of the small world, run before the reader's eyes.

#include "05_resolution/small_world/step_1.hpp"
#include "05_resolution/small_world/step_2.hpp"
#include "05_resolution/small_world/step_3.hpp"
#include "05_resolution/small_world/step_4.hpp"
#include "05_resolution/small_world/step_5.hpp"
#include "05_resolution/small_world/step_6.hpp"
#include "05_resolution/small_world/step_7.hpp"
#include "05_resolution/small_world/trial/live_world.hpp"

namespace cookbook::live
{

void figure(Page& page)
{
  using namespace small_world;
  static LiveWorlds<
      StepScenes, step_1::World, step_2::World, step_3::World, step_4::World, step_5::World,
      step_6::World, step_7::World>
      worlds;
  const int method = page.choice(
      "step", {"1: impulses, friction", "2: warm starting", "3: soft steps", "4: broad phase",
               "5: restitution", "6: sleeping", "7: swept spheres"});
  worlds.show(page, method);
}

} // namespace cookbook::live
