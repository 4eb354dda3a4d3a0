/// \file
/// \brief Five masses on springs of one frequency and damping ratio, each stepped in another way.

#include "07_constraints/springs/trial/hanging_springs.hpp"
#include "tools/live/page.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace cookbook::live
{

namespace
{

/// "3, 0" as "3 Hz, ζ 0"; a word stays as it is.
std::string with_units(std::string got)
{
  const std::size_t comma = got.find(", ");
  return comma == std::string::npos ? got : got.replace(comma, 2, " Hz, ζ ");
}

/// A stretch [m] to micrometres; what is less is rounding.
double micrometres(const PhasePoint<double>& at)
{
  return std::round(1e6 * at.position) / 1e6 + 0.0;
}

} // namespace

void figure(Page& page)
{
  constexpr double seconds = 2; // that the chart shows
  static HangingSprings springs(1);
  const bool wide = page.width() > 640;
  const double width = wide ? (page.fit(760) - 16) / 2 : page.fit(400);
  const plot::View view{{-1.8, -2.2}, {5.6, 2.9}, width};
  const double frequency = page.slider("frequency", 0.5, 30, 3, "Hz");
  const double ratio = page.slider("damping ratio", 0, 2, 0);
  static constexpr std::array<int, 4> counts{1, 2, 4, 8};
  const int count = counts[std::size_t(page.choice("steps a second", {"60", "120", "240", "480"}))];
  const plot::Figure2d empty("springs_hang", "", view);
  const double level = -page.handle("let go", empty, {-1.2, -1}).y();
  const SpringAsked asked{frequency, ratio, 1.0 / (60 * count)};

  page.restarts_with("frequency").restarts_with("damping ratio").restarts_with("steps a second");
  int steps = count * page.steps();
  if (page.begins() || page.changed("let go"))
  {
    springs = HangingSprings(level);
    steps += page.changed("let go") ? 0 : 30 * count; // something to see before it moves
  }
  for (int i = 0; i < steps; ++i)
  {
    step(springs, asked, seconds);
  }
  const std::vector<SpringWay> ways = spring_ways();
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    page.text(std::to_string(i + 1) + " " + ways[i].name, with_units(got(ways[i], asked)));
  }
  page.number("4 is stretched by", micrometres(springs.at[3]), "m");
  page.number("5 is stretched by", micrometres(springs.at[4]), "m");
  page.number("time", springs.time, "s");
  if (springs.time > 20)
  {
    page.rests();
  }
  plot::Grid grid("springs_live", "", wide ? 2 : 1);
  grid.describe("Five masses on springs side by side, and their stretch over time.")
      .add(hanging_figure(springs, level, view))
      .add(hanging_chart(springs, seconds, width, (wide ? 0.85 : 0.8) * width));
  page.draw(grid.svg());
}

} // namespace cookbook::live
