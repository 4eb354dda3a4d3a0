/// \file
/// \brief Times ways to turn by an angular velocity, and draws their cost against their drift.

#include "01_math/turning_chart/trial/turning_chart.hpp"
#include "tools/measure/cost_chart.hpp"
#include "tools/program/program.hpp"

namespace
{

using namespace cookbook;

/// A way by its name: timed, and its drift after a million steps.
template <class State, class Step>
measure::ChartedMethod turning_way(const std::string& name, const State& start, Step one)
{
  static const std::vector<Vector3<float>> spins = changing_spin();
  static const Quaternion<double> right = true_end(spins, 15625);
  const auto run = [start, one] { measure::keep(after_rounds(start, spins, 20, one)); };
  const double off = drift(spin_end(after_rounds(start, spins, 15625, one)), right);
  return {{name, run, 20.0 * 64}, {off, off}};
}

std::vector<measure::ChartedMethod> turning_ways()
{
  using Q = Quaternion<float>;
  using V = Vector3<float>;
  const Q none = Q::Identity();
  const Matrix3<float> axes = Matrix3<float>::Identity();
  const auto by = [](auto step)
  { return [step](const auto& state, const V& spin, float h) { return step(state, spin, h); }; };
  std::vector<measure::ChartedMethod> ways{
      turning_way("quaternion added", none, by(quaternion_added<float>)),
      turning_way("added, length one", none, by(quaternion_added_and_normalised<float>)),
      turning_way("half-angle fraction", none, by(turned_by_fraction<float>)),
      turning_way("matrix added, orthonormal", axes, by(matrix_added<float>)),
      turning_way("matrix by axis and angle", axes, by(matrix_turned)),
      turning_way("Eigen", none, by(eigen_turned)),
      turning_way(
          "turned_by", none,
          [](const Q& q, const V& spin, float h) { return turned_by<float>(q, spin, h); })};
#ifdef COOKBOOK_HAS_GLM
  ways.push_back(turning_way("GLM", glm::quat(1, 0, 0, 0), by(glm_turned)));
#endif
  return ways;
}

plot::Chart chart(const measure::Effort& effort)
{
  plot::Chart chart(
      "turning_chart", "A million frames of a changing spin, float",
      {"time of a step [ns]", plot::Scale::log},
      {"drift [rad, or of the length]", plot::Scale::log});
  // Half a turn is the most that an angle can be off.
  measure::add_methods(chart, turning_ways(), effort, 4);
  chart.size(400, 420).name_failures("length lost").note(measure::machine_line());
  chart.describe("Cost of a step against drift after a million; " + measure::machine_line());
  return chart;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "turning_chart",
      .summary = "Times ways to turn by an angular velocity, and draws cost against drift.",
      .options = {effort_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const measure::Effort effort = measure::effort_named(given.value("effort"));
        save_figure(given, "turning_chart.svg", chart(effort).svg());
      });
}
