/// \file
/// \brief Times ways to ask whether two turned boxes overlap, near and far; cost against wrong
/// answers.

#include "02_primitives/overlap_chart/trial/overlap_chart.hpp"
#include "common/measure/cost_chart.hpp"
#include "common/program/program.hpp"

namespace
{

using namespace cookbook;

using Pairs = std::vector<KnownBoxes>;

/// A way by its name: timed, and asked for its wrong answers.
template <class Way>
measure::ChartedMethod timed_way(const std::string& name, const Pairs& pairs, Way way)
{
  const auto call = [way](const KnownBoxes& pair) { return way(pair.a, pair.b); };
  const double wrong = wrong_share(way, pairs);
  return {measure::timed_over(name, pairs, call), {wrong, wrong}};
}

plot::Chart chart_of(
    const std::string& name, const std::string& title, const Pairs& pairs,
    const measure::Effort& effort)
{
  using Box = Obb<float>;
  std::vector<measure::ChartedMethod> ways{
      timed_way("around, along axes", pairs, bounds_overlap),
      timed_way("6 axes", pairs, [](const Box& a, const Box& b) { return faces_overlap(a, b); }),
      timed_way("15 axes", pairs, [](const Box& a, const Box& b) { return boxes_overlap(a, b); }),
      timed_way("spheres first", pairs, overlap_spheres_first),
      timed_way("any shapes", pairs, [](const Box& a, const Box& b) { return overlaps(a, b); })};
#ifdef COOKBOOK_HAS_FCL
  ways.push_back(timed_way("FCL", pairs, fcl_overlap));
#endif
  plot::Chart chart(name, title, {"time of a pair [ns]", plot::Scale::log}, {"wrong answers [%]"});
  measure::add_methods(chart, ways, effort);
  chart.size(400, 310);
  return chart;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "overlap_chart",
      .summary = "Times ways to ask whether two turned boxes overlap; cost against wrong answers.",
      .options = {effort_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const measure::Effort effort = measure::effort_named(given.value("effort"));
        const Pairs near = known_boxes_in_pairs(1000, 2), far = known_boxes_in_pairs(1000, 10);
        plot::Grid grid("overlap_chart", "", 1);
        grid.describe("Cost against wrong answers of box overlaps; " + measure::machine_line())
            .add(chart_of("near", "Boxes of which many overlap", near, effort))
            .add(chart_of("far", "Boxes of which few overlap", far, effort)
                     .note(measure::machine_line())
                     .size(400, 370));
        save_figure(given, "overlap_chart.svg", grid.svg());
      });
}
