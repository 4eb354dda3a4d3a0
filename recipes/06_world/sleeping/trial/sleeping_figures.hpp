#pragma once

/// \file
/// \brief What the program of sleeping draws: a ball that is put to sleep on its way, and islands.

#include "06_world/sleeping/trial/sleeping_scenes.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/panel.hpp"

#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

/// Where a ball is that rolls up 1°, and where each rule has it.
inline plot::Chart slope_chart()
{
  plot::Chart chart(
      "sleeping", "", {"time [s]", plot::Scale::linear, 0, 5},
      {"up the slope [m]", plot::Scale::linear, 0, 0.45});
  chart.describe("A ball that rolls up a slope: one rule puts it to sleep where it turns.");
  const WatchedMotion motion = rolling_up("", "", 1, 0.3);
  for (const std::size_t rule : {2u, 1u})
  {
    const SleepRule chosen = sleep_rules()[rule];
    const double asleep = falls_asleep(motion, chosen).value_or(motion.duration);
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i <= 49; ++i)
    {
      const double time = i / 10.0, moving = std::min(time, asleep);
      points.push_back({time, 0.3 * moving - rolling_deceleration(1) / 2 * moving * moving});
    }
    chart.line(chosen.name, points);
  }
  return chart;
}

/// A body of the figure: a cube of 1 m, or a ball of 1 m across.
struct Sleeper
{
  Eigen::Vector2d center; ///< [m]
  bool is_sphere;         ///< whether it is round
};

/// A tower of three, a pyramid of three, and a ball by itself; body 0 is the ground.
inline std::vector<Sleeper> sleepers()
{
  return {{{0, -0.5}, false},  {{0.5, 0.5}, false}, {{0.6, 1.5}, false}, {{0.4, 2.5}, false},
          {{2.4, 0.5}, false}, {{3.5, 0.5}, false}, {{3, 1.5}, false},   {{5.2, 0.5}, true}};
}

/// Which of them touch.
inline std::vector<std::pair<int, int>> sleepers_touch()
{
  return {{0, 1}, {1, 2}, {2, 3}, {0, 4}, {0, 5}, {4, 6}, {5, 6}, {0, 7}};
}

/// The sleepers with the numbers of their islands; those that are awake are orange.
inline plot::Figure2d sleepers_panel(const std::string& title, int removed)
{
  const std::vector<Sleeper> all = sleepers();
  std::vector<bool> movable(all.size(), true);
  movable[0] = false;
  const std::vector<int> island = islands(movable, sleepers_touch());
  SleepState<double> asleep;
  asleep.asleep = true;
  std::vector<SleepState<double>> states(all.size(), asleep);
  plot::Figure2d figure("islands", title, {{-0.5, -0.4}, {6.2, 3.2}, 330});
  figure.half_plane({0, 1}, 0);
  if (removed > 0)
  {
    wake(states, island, removed);
  }
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    const bool gone = static_cast<int>(i) == removed;
    const plot::Ink ink = gone ? plot::Ink::faint : states[i].asleep ? plot::Ink::a : plot::Ink::b;
    const plot::Fill fill = gone ? plot::Fill::none : plot::Fill::wash;
    const plot::Stroke stroke = gone ? plot::Stroke::dotted : plot::Stroke::solid;
    all[i].is_sphere ? figure.circle(all[i].center, 0.5, ink, fill, stroke)
                     : figure.box(all[i].center, 0, {0.5, 0.5}, ink, fill, stroke);
    figure.label(all[i].center, gone ? "" : std::to_string(island[i]), plot::Side::centre, ink);
  }
  return figure;
}

/// All asleep; then the lowest cube of the tower is removed.
inline plot::Grid islands_figure()
{
  plot::Grid grid("sleeping_islands", "", 2);
  grid.describe("Three islands asleep; one of them wakes as its lowest cube is removed.")
      .add(sleepers_panel("asleep", 0))
      .add(sleepers_panel("cube 1 removed", 1));
  return grid;
}

} // namespace cookbook
