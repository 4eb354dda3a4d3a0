/// \file
/// \brief Times ways to ask whether two turned boxes overlap, near and far, and whether two
/// triangles meet; cost against wrong answers.

#include "02_primitives/overlap_chart/trial/overlap_chart.hpp"
#include "02_primitives/overlap_chart/trial/triangles_chart.hpp"
#include "02_primitives/triangle_triangle/trial/triangle_triangle_cases.hpp"
#include "common/measure/cost_chart.hpp"
#include "common/program/program.hpp"

namespace
{

using namespace cookbook;

template <class Shape>
using Pairs = std::vector<KnownPair<Shape>>;

/// A way by its name: timed, and asked for its wrong answers.
template <class Shape, class Way>
measure::ChartedMethod timed_way(const std::string& name, const Pairs<Shape>& pairs, Way way)
{
  const auto call = [way](const KnownPair<Shape>& pair) { return way(pair.a, pair.b); };
  const double wrong = wrong_share(way, pairs);
  return {measure::timed_over(name, pairs, call), {wrong, wrong}};
}

plot::Chart chart_of(
    const std::string& name, const std::string& title,
    const std::vector<measure::ChartedMethod>& ways, const measure::Effort& effort)
{
  plot::Chart chart(name, title, {"time of a pair [ns]", plot::Scale::log}, {"wrong answers [%]"});
  measure::add_methods(chart, ways, effort);
  chart.size(400, 310);
  return chart;
}

std::vector<measure::ChartedMethod> ways_of_boxes(const Pairs<Obb<float>>& pairs)
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
  return ways;
}

std::vector<measure::ChartedMethod> ways_of_triangles(const Pairs<Triangle<double>>& pairs)
{
  std::vector<measure::ChartedMethod> ways;
  for (const TrianglesMethod& method : triangle_triangle_methods())
  {
    ways.push_back(timed_way(method.name, pairs, method.meet));
  }
#ifdef COOKBOOK_HAS_FCL
  ways.push_back(timed_way("FCL", pairs, fcl_meet));
#endif
#ifdef COOKBOOK_HAS_BULLET
  ways.push_back(timed_way("Bullet", pairs, bullet_meet));
#endif
  return ways;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "overlap_chart",
      .summary =
          "Times ways to ask whether two boxes or triangles overlap; cost against wrong answers.",
      .options = {effort_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const measure::Effort effort = measure::effort_named(given.value("effort"));
        const auto near = ways_of_boxes(known_boxes_in_pairs(1000, 2));
        const auto far = ways_of_boxes(known_boxes_in_pairs(1000, 10));
        plot::Grid boxes("overlap_chart", "", 1);
        boxes.describe("Cost against wrong answers of box overlaps; " + measure::machine_line())
            .add(chart_of("near", "Boxes of which many overlap", near, effort))
            .add(chart_of("far", "Boxes of which few overlap", far, effort)
                     .note(measure::machine_line())
                     .size(400, 370));
        save_figure(given, "overlap_chart.svg", boxes.svg());
        const auto any = ways_of_triangles(known_triangles_in_pairs(1000, false));
        const auto neighbours = ways_of_triangles(known_triangles_in_pairs(1000, true));
        plot::Grid triangles("triangles_chart", "", 1);
        triangles
            .describe("Cost against wrong answers of two triangles; " + measure::machine_line())
            .add(chart_of("any", "Triangles anywhere", any, effort))
            .add(chart_of(
                     "neighbours", "Triangles that share a plane or a corner", neighbours, effort)
                     .note(measure::machine_line())
                     .size(400, 370));
        save_figure(given, "triangles_chart.svg", triangles.svg());
      });
}
