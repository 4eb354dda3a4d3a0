#pragma once

/// \file
/// \brief The figure of the direct solver: a ton on a kilogram.

#include "05_resolution/plain_direct/plain_direct.hpp"
#include "05_resolution/plain_positions/trial/plain_scenes.hpp"
#include "05_resolution/small_world/trial/small_world_figures.hpp"

namespace cookbook::small_world
{

/// 1,000 kg on 1 kg under step 7 and under the direct solver.
inline plot::Grid ton_figure()
{
  const plot::Frame part{{0, 1, 0}, 4};
  return beside(
      "1,000 kg on 1 kg after 10 s: the light cube is pressed into the ground under step 7, and "
      "carries the load under the direct solver.",
      picture("step 7", heavy_on_light<step_7::World>(1000), 10, part),
      picture("direct", heavy_on_light<plain_direct::World>(1000), 10, part));
}

} // namespace cookbook::small_world
