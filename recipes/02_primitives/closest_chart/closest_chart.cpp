/// \file
/// \brief Times closest points of a triangle and of two segments, and draws cost against error.

#include "02_primitives/closest_chart/trial/closest_chart.hpp"
#include "02_primitives/closest_chart/trial/closest_peers.hpp"
#include "tools/measure/cost_chart.hpp"
#include "tools/program/program.hpp"

namespace
{

using namespace cookbook;

/// A way by its name: timed, and asked for its errors.
template <class Known, class Method>
measure::ChartedMethod
timed_method(const std::string& name, const std::vector<Known>& all, Method method)
{
  const auto call = [method](const Known& one) { return method(one.a, one.b); };
  return {measure::timed_over(name, all, call), distance_errors(method, all)};
}

plot::Chart chart_of(
    const std::string& name, const std::string& title,
    const std::vector<measure::ChartedMethod>& methods, const measure::Effort& effort)
{
  plot::Chart chart(
      name, title, {"time of a call [ns]", plot::Scale::log},
      {"error of the distance [m]", plot::Scale::log});
  measure::add_methods(chart, methods, effort);
  chart.size(400, 330);
  return chart;
}

plot::Chart triangle_chart(const measure::Effort& effort)
{
  using P = Vector3<float>;
  using T = Triangle<float>;
  const auto all = known_triangles_and_points(1000);
  std::vector<measure::ChartedMethod> methods{
      timed_method("regions, float", all, distance_in_float),
      timed_method(
          "regions", all,
          [](const P& p, const T& t)
          { return static_cast<float>(vector_to_triangle<float>(t, widen(p)).norm()); }),
      timed_method(
          "any shapes", all, [](const P& p, const T& t) { return closest_points(p, t).distance; })};
#ifdef COOKBOOK_HAS_BULLET
  methods.push_back(timed_method("Bullet", all, bullet_distance));
#endif
  return chart_of("triangle", "A point and a triangle", methods, effort);
}

plot::Chart segment_chart(const measure::Effort& effort)
{
  using S = Segment<float>;
  using W = Segment<double>;
  const auto all = known_segments(1000);
  const auto wide = in_double(all);
  std::vector<measure::ChartedMethod> methods{
      timed_method("five dot products", all, distance_by_dot_products),
      timed_method(
          "clamped in turn, float", all,
          [](const S& a, const S& b) { return closest_fractions(a, b).difference.norm(); }),
      timed_method(
          "clamped in turn", wide,
          [](const W& a, const W& b) { return closest_fractions(a, b).difference.norm(); }),
      timed_method(
          "any shapes", all, [](const S& a, const S& b) { return closest_points(a, b).distance; })};
#ifdef COOKBOOK_HAS_ODE
  methods.push_back(timed_method("ODE", wide, ode_distance));
#endif
  return chart_of("segments", "Two segments", methods, effort);
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "closest_chart",
      .summary = "Times closest points of a triangle and of two segments; cost against error.",
      .options = {effort_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const measure::Effort effort = measure::effort_named(given.value("effort"));
        plot::Grid grid("closest_chart", "", 1);
        grid.describe("Cost against error of closest points; " + measure::machine_line())
            .add(triangle_chart(effort))
            .add(segment_chart(effort).note(measure::machine_line()).size(400, 390));
        save_figure(given, "closest_chart.svg", grid.svg());
      });
}
