/// \file
/// \brief Carries columns of bodies by impulses in turn: how many passes, cold and warm, they take.

#include "06_world/sequential_impulses/sequential_impulses.hpp"
#include "06_world/sequential_impulses/trial/sequential_impulses_figures.hpp"
#include "06_world/sequential_impulses/trial/sequential_impulses_scenes.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>
#include <numbers>

namespace
{

using namespace cookbook;

/// A number for a table, with at most four decimals.
std::string tidied(double value)
{
  return number(std::round(value * 1e4) / 1e4);
}

void print_ratios(double chosen)
{
  Table table({"heavy on light", "error a pass", "passes to 0.1 %"});
  for (const double ratio : {1.0, 10.0, 100.0, chosen})
  {
    const std::vector<double> masses{1, ratio};
    const std::string factor = "× " + tidied(error_factor(masses, 20));
    table.row({number(ratio) + " kg on 1 kg", factor, std::to_string(passes_needed(masses, 1e-3))});
  }
  std::cout << table.text();
}

void print_towers()
{
  Table table({"equal boxes", "error a pass", "passes to 1 %"});
  for (const std::size_t count : {2u, 5u, 10u, 15u, 20u})
  {
    const std::vector<double> masses(count, 1.0);
    const double cosine = std::cos(std::numbers::pi / (2.0 * static_cast<double>(count)));
    table.row(
        {std::to_string(count), "× " + tidied(cosine * cosine),
         std::to_string(passes_needed(masses, 0.01))});
  }
  std::cout << table.text();
}

void print_frames(int boxes, int passes)
{
  const auto count = static_cast<std::size_t>(boxes);
  const auto cold = sinking_by_frame(count, passes, 240, false);
  const auto warm = sinking_by_frame(count, passes, 240, true);
  Table table({"frame", "cold: sinks at [m/s]", "warm: sinks at [m/s]"});
  for (const std::size_t frame : {1u, 2u, 5u, 15u, 60u, 240u})
  {
    table.row({std::to_string(frame), tidied(cold[frame - 1].y()), tidied(warm[frame - 1].y())});
  }
  std::cout << boxes << " boxes, " << passes << " passes a frame: the top box\n" << table.text();
}

void run(const Arguments& given)
{
  const double ratio = number_option(given, "ratio", 0.001, 1000.0);
  const int boxes = number_option(given, "boxes", 1, 50);
  const int passes = number_option(given, "passes", 1, 1000);
  print_ratios(ratio);
  std::cout << "\n";
  print_towers();
  std::cout << "\n";
  print_frames(boxes, passes);
  save_figure(given, "sequential_impulses_passes.svg", stack_figure().svg());
  save_figure(given, "sequential_impulses.svg", passes_figure().svg());
  save_figure(given, "sequential_impulses_frames.svg", frames_figure().svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "sequential_impulses",
      .summary = "Carries columns of bodies by impulses in turn: how many passes they take.",
      .options = {
          {"ratio", "a mass [kg] on 1 kg, 0.001 to 1000", "1000", {}},
          {"boxes", "in a column, 1 to 50", "10", {}},
          {"passes", "in a frame, 1 to 1000", "8", {}}}};
  return run_program(argc, argv, arguments, run);
}
