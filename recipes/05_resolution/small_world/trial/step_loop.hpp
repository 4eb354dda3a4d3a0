#pragma once

/// \file
/// \brief The loop that a step of the small world runs: collide, solve, integrate.

#include "tools/plot/figures/figure2d.hpp"

#include <string>
#include <vector>

namespace cookbook::small_world
{

/// The parts of a step, and what each hands to the next.
inline plot::Figure2d loop_figure()
{
  const std::vector<std::string> parts{"collide", "solve", "integrate"};
  const std::vector<std::string> results{"contact points", "velocities"};
  plot::Figure2d figure("small_world_loop", "", {{-1.4, -2.3}, {10.6, 1.0}, 560});
  figure.describe("A step: collide makes contact points, solve velocities, integrate positions.");
  for (int i = 0; i < 3; ++i)
  {
    const Eigen::Vector2d center(4.6 * i, 0);
    figure.box(center, 0, {1.1, 0.5}, plot::Ink::a);
    figure.label(center, parts[std::size_t(i)], plot::Side::centre);
    if (i < 2)
    {
      const Eigen::Vector2d start(4.6 * i + 1.2, 0), end(4.6 * i + 3.4, 0);
      figure.arrow(start, end);
      figure.label(0.5 * (start + end), results[std::size_t(i)], plot::Side::above);
    }
  }
  figure.polyline({{9.2, -0.6}, {9.2, -1.5}, {0, -1.5}}).arrow({0, -1.5}, {0, -0.6});
  figure.label({4.6, -1.5}, "positions and orientations, one frame later", plot::Side::below);
  return figure;
}

} // namespace cookbook::small_world
