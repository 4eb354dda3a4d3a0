/// \file
/// \brief Follows boxes that rest or slide for many frames, with and without a memory.

#include "04_obb_manifolds/feature_memory/feature_memory.hpp"
#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"
#include "04_obb_manifolds/feature_memory/trial/feature_memory_figures.hpp"
#include "04_obb_manifolds/feature_memory/trial/feature_memory_scenes.hpp"
#include "04_obb_manifolds/feature_memory/trial/feature_memory_verdicts.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>
#include <string>

namespace
{

using namespace cookbook;

void print_flips()
{
  Table table({"tilt of the stack", "least axis", "box_box", "next_frame"});
  for (const double angle : {1e-2, 1e-3, 1e-4, 1e-6, 1e-8})
  {
    const Frames frames = jittered_stack(angle);
    const auto count = [](const std::vector<int>& axes) { return std::to_string(flips(axes)); };
    table.row(
        {number(angle), count(least_axes(frames)), count(forgetful_axes(frames)),
         count(remembered_axes(frames))});
  }
  std::cout << "How often the axis changes in 1,000 frames\n" << table.text();
}

void print_persistence(const std::string& title, const Frames& frames)
{
  using Place = std::optional<Vector3<double>>;
  Table table({"axis", "points are known by", "points", "given theirs", "given another's"});
  const auto add = [&](bool with_memory, const std::string& known_by, const auto& match)
  {
    const Persistence all = persistence(frames, with_memory, match);
    table.row(
        {with_memory ? "next_frame" : "box_box", known_by, std::to_string(all.points),
         std::to_string(all.right), std::to_string(all.wrong)});
  };
  for (const bool with_memory : {false, true})
  {
    add(with_memory, "their index", carried_by_index<double, Place>);
    add(with_memory, "their feature", carried_by_id<double, Place>);
  }
  std::cout << '\n' << title << '\n' << table.text();
}

/// The axis in each of the first frames, as a line of steps.
plot::Chart chart_of(const std::string& title, const std::vector<int>& axes)
{
  plot::Chart chart(
      "feature_memory", title, {"frame", {}, 0, 120},
      {"axis: A's faces 0–2, B's 3–5, edges 6–14", {}, 0, 14});
  std::vector<Eigen::Vector2d> steps;
  for (int frame = 0; frame < 120; ++frame)
  {
    const double axis = axes[static_cast<std::size_t>(frame)];
    steps.push_back({double(frame), axis});
    steps.push_back({double(frame + 1), axis});
  }
  const plot::Look look{plot::Ink::overlap, plot::Marker::none, plot::Stroke::solid};
  return chart.line(title, steps, look).legend(plot::Legend::none).size(400, 170);
}

void draw(const Arguments& arguments)
{
  const Frames frames = jittered_stack(1e-4);
  plot::Grid grid("feature_memory", "", 1);
  grid.describe("The axis of a jittering stack: it changes all the time, sometimes, and never.")
      .add(chart_of("the axis of least overlap", least_axes(frames)))
      .add(chart_of("box_box()", forgetful_axes(frames)))
      .add(chart_of("next_frame()", remembered_axes(frames)));
  save_figure(arguments, "feature_memory.svg", grid.svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "feature_memory",
      .summary = "How often axes change and points get lost, with and without a memory."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_flips();
        print_persistence("A cube slides for 5 s", sliding_cube());
        print_persistence("A beam lies on its edge across a cube", jittered_beam());
        draw(given);
        save_figure(given, "feature_memory_beam.svg", beam_figure().svg());
        save_figure(
            given, "feature_memory_verdicts.html",
            verdict_table("From frame to frame", names_of(frame_methods()), frame_verdicts()));
      });
}
