/// \file
/// \brief Times ways to ask whether two oriented boxes overlap, near and far, and whether two
/// triangles meet; cost against wrong answers.

#include "02_primitives/overlap_chart/trial/overlap_chart.hpp"
#include "02_primitives/overlap_chart/trial/triangles_chart.hpp"
#include "02_primitives/triangle_triangle/trial/triangle_triangle_cases.hpp"
#include "tools/measure/cost_chart.hpp"
#include "tools/program/program.hpp"

namespace
{

using namespace cookbook;

template <class Shape>
using Pairs = std::vector<KnownPair<Shape>>;

/// A way by its name: timed, and asked for its wrong answers.
template <class Shape, class Method>
measure::ChartedMethod
timed_method(const std::string& name, const Pairs<Shape>& pairs, Method method)
{
  const auto call = [method](const KnownPair<Shape>& pair) { return method(pair.a, pair.b); };
  const double wrong = wrong_fraction(method, pairs);
  return {measure::timed_over(name, pairs, call), {wrong, wrong}};
}

std::vector<measure::ChartedMethod> methods_of_boxes(const Pairs<Obb<float>>& pairs)
{
  using Box = Obb<float>;
  std::vector<measure::ChartedMethod> methods{
      timed_method("around, along axes", pairs, bounds_overlap),
      timed_method("6 axes", pairs, [](const Box& a, const Box& b) { return faces_overlap(a, b); }),
      timed_method(
          "15 axes", pairs, [](const Box& a, const Box& b) { return boxes_overlap(a, b); }),
      timed_method("spheres first", pairs, overlap_spheres_first),
      timed_method("any shapes", pairs, [](const Box& a, const Box& b) { return overlaps(a, b); })};
#ifdef COOKBOOK_HAS_FCL
  methods.push_back(timed_method("FCL", pairs, fcl_overlap));
#endif
  return methods;
}

std::vector<measure::ChartedMethod> methods_of_triangles(const Pairs<Triangle<double>>& pairs)
{
  std::vector<measure::ChartedMethod> methods;
  for (const TrianglesMethod& method : triangle_triangle_methods())
  {
    methods.push_back(timed_method(method.name, pairs, method.meet));
  }
#ifdef COOKBOOK_HAS_FCL
  methods.push_back(timed_method("FCL", pairs, fcl_meet));
#endif
#ifdef COOKBOOK_HAS_BULLET
  methods.push_back(timed_method("Bullet", pairs, bullet_meet));
#endif
  return methods;
}

/// One workload's chart.
struct Workload
{
  std::string name, title;
  std::vector<measure::ChartedMethod> methods;
};

void draw(
    const Arguments& given, const std::string& name, const Workload& above, const Workload& below)
{
  const measure::Effort effort = measure::effort_named(given.value("effort"));
  const auto chart_of = [&](const Workload& work)
  {
    plot::Chart chart(
        work.name, work.title, {"time of a pair [ns]", plot::Scale::log}, {"wrong answers [%]"});
    measure::add_methods(chart, work.methods, effort);
    return chart.size(400, 310);
  };
  plot::Grid grid(name, "", 1);
  grid.describe("Cost against wrong answers; " + measure::machine_line())
      .add(chart_of(above))
      .add(chart_of(below).note(measure::machine_line()).size(400, 370));
  save_figure(given, name + ".svg", grid.svg());
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
        draw(
            given, "overlap_chart",
            {"near", "Boxes of which many overlap",
             methods_of_boxes(known_boxes_in_pairs(1000, 2))},
            {"far", "Boxes of which few overlap",
             methods_of_boxes(known_boxes_in_pairs(1000, 10))});
        draw(
            given, "triangles_chart",
            {"any", "Triangles anywhere",
             methods_of_triangles(known_triangles_in_pairs(1000, false))},
            {"neighbours", "Triangles that share a plane or a corner",
             methods_of_triangles(known_triangles_in_pairs(1000, true))});
      });
}
