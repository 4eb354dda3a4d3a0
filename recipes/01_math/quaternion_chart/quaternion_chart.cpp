/// \file
/// \brief Times ways from a matrix to a quaternion, and draws their cost against their error.

#include "01_math/quaternion_chart/trial/quaternion_chart.hpp"
#include "tools/measure/cost_chart.hpp"
#include "tools/program/program.hpp"

namespace
{

using namespace cookbook;

/// A way by its name: timed, and asked for its errors.
template <class Way>
measure::ChartedMethod
timed_way(const std::string& name, const std::vector<KnownRotation>& rotations, Way way)
{
  const auto call = [way](const KnownRotation& one) { return way(one.r); };
  return {measure::timed_over(name, rotations, call), quaternion_errors(way, rotations)};
}

plot::Chart chart(
    const std::string& name, const std::string& title, const std::vector<KnownRotation>& rotations,
    const measure::Effort& effort)
{
  using M = Matrix3<float>;
  std::vector<measure::ChartedMethod> ways{
      timed_way("by w alone", rotations, [](const M& r) { return quaternion_by_w(r); }),
      timed_way("four roots", rotations, [](const M& r) { return quaternion_by_roots(r); }),
      timed_way("Eigen", rotations, [](const M& r) { return Quaternion<float>(r); }),
      timed_way("quaternion_of", rotations, [](const M& r) { return quaternion_of(r); })};
#ifdef COOKBOOK_HAS_GLM
  ways.push_back(timed_way("GLM", rotations, glm_quaternion));
#endif
  plot::Chart chart(
      name, title, {"time of a call [ns]", plot::Scale::log},
      {"error [ulp of one]", plot::Scale::log});
  measure::add_methods(chart, ways, effort);
  chart.size(400, 290).name_failures("not a number");
  return chart;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "quaternion_chart",
      .summary = "Times ways from a matrix to a quaternion, and draws cost against error.",
      .options = {effort_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const measure::Effort effort = measure::effort_named(given.value("effort"));
        plot::Grid grid("quaternion_chart", "", 1);
        grid.describe("Cost against error, matrix to quaternion; " + measure::machine_line())
            .add(chart("any", "Any rotation", known_rotations(60), effort))
            .add(chart("half", "Near half a turn: w below 1/20", known_rotations(1), effort)
                     .note(measure::machine_line())
                     .size(400, 360));
        save_figure(given, "quaternion_chart.svg", grid.svg());
      });
}
