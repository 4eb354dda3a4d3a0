/// \file
/// \brief Times ways to find an angle and to multiply vectors, and draws cost against error.

#include "01_math/angle_chart/trial/angle_chart.hpp"
#include "01_math/vectors/trial/vectors_cases.hpp"
#include "01_math/vectors/vectors.hpp"
#include "tools/measure/cost_chart.hpp"
#include "tools/program/program.hpp"

#ifdef COOKBOOK_HAS_GLM
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtx/projection.hpp>
#include <glm/gtx/vector_angle.hpp>
#endif

namespace
{

using namespace cookbook;

template <class Real>
using Pairs = std::vector<VectorPair<Real>>;

template <class Real, class Formula>
measure::Timed timed(const std::string& name, const Pairs<Real>& pairs, Formula formula)
{
  return measure::timed_over(
      name, pairs,
      [formula](const VectorPair<Real>& pair) { return formula(pair.first, pair.second); });
}

#ifdef COOKBOOK_HAS_GLM
template <class Real>
glm::vec<3, Real> of_glm(const Vector3<Real>& v)
{
  return {v.x(), v.y(), v.z()};
}

/// Of unit vectors, as it asks for.
template <class Real>
Real angle_glm(const Vector3<Real>& a, const Vector3<Real>& b)
{
  return glm::angle(of_glm<Real>(a), of_glm<Real>(b));
}
#endif

/// The pairs with unit vectors, which GLM asks for.
template <class Real>
Pairs<Real> units(const Pairs<Real>& pairs)
{
  Pairs<Real> all;
  for (const VectorPair<Real>& pair : pairs)
  {
    all.push_back({pair.first.normalized(), pair.second.normalized()});
  }
  return all;
}

template <class Real>
plot::Chart
angles_chart(const std::string& name, const std::string& title, const measure::Effort& effort)
{
  using Three = Vector3<Real>;
  const Pairs<Real> pairs = angle_workload<Real>(1000), unit_pairs = units(pairs);
  std::vector<measure::Timed> all{
      timed<Real>(
          "as published", pairs, [](const Three& a, const Three& b) { return angle_acos(a, b); }),
      timed<Real>(
          "clamped", pairs, [](const Three& a, const Three& b) { return angle_clamped(a, b); }),
      timed<Real>(
          "atan2", pairs, [](const Three& a, const Three& b) { return plain::angle(a, b); }),
      timed<Real>("Kahan", pairs, [](const Three& a, const Three& b) { return angle_kahan(a, b); }),
      timed<Real>(
          "recommended", pairs, [](const Three& a, const Three& b) { return angle(a, b); })};
  std::vector<AngleMethod<Real>> methods;
  for (const AngleMethod<Real>& method : angle_methods<Real>())
  {
    methods.push_back(method);
  }
#ifdef COOKBOOK_HAS_GLM
  all.push_back(timed<Real>("GLM", unit_pairs, angle_glm<Real>));
  methods.push_back({"GLM", [](const Three& a, const Three& b) {
                       return angle_glm<Real>(a.normalized(), b.normalized());
                     }});
#endif
  plot::Chart chart(
      name, title, {"time of a call [ns]", plot::Scale::log},
      {"error as a part of the angle", plot::Scale::log});
  std::vector<measure::ChartedMethod> charted;
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    charted.push_back({all[i], angle_errors(methods[i], pairs)});
  }
  measure::add_methods(chart, charted, effort, 0.1);
  chart.size(400, 310).name_failures("no digit");
  return chart;
}

/// The time of the recommended functions beside those of Eigen and GLM.
plot::BarChart cost_chart(const measure::Effort& effort)
{
  using F = Vector3<float>;
  using D = Vector3<double>;
  const Pairs<float> floats = angle_workload<float>(1000);
  const Pairs<double> doubles = angle_workload<double>(1000);
  std::vector<measure::Timed> all{
      timed<float>("cross, Eigen", floats, [](const F& a, const F& b) { return F(a.cross(b)); }),
      timed<float>(
          "accurate_cross", floats, [](const F& a, const F& b) { return accurate_cross(a, b); }),
      timed<double>(
          "cross, Eigen, double", doubles, [](const D& a, const D& b) { return D(a.cross(b)); }),
      timed<double>(
          "accurate_cross, double", doubles,
          [](const D& a, const D& b) { return accurate_cross(a, b); }),
      timed<float>(
          "project, textbook", floats,
          [](const F& a, const F& b) { return project_textbook(a, b); }),
      timed<float>("project", floats, [](const F& a, const F& b) { return project(a, b); }),
      timed<float>(
          "reflect_unit", floats, [](const F& a, const F& b) { return reflect_unit(a, b); }),
      timed<float>("reflect", floats, [](const F& a, const F& b) { return reflect(a, b); }),
      timed<float>(
          "lerp, mixture", floats,
          [](const F& a, const F& b) { return lerp_by_mixture(a, b, 0.3f); }),
      timed<float>("lerp", floats, [](const F& a, const F& b) { return lerp(a, b, 0.3f); })};
#ifdef COOKBOOK_HAS_GLM
  all.push_back(timed<float>(
      "project, GLM", floats,
      [](const F& a, const F& b) { return glm::proj(of_glm<float>(a), of_glm<float>(b)); }));
  all.push_back(timed<float>(
      "reflect, GLM", floats,
      [](const F& a, const F& b) { return glm::reflect(of_glm<float>(a), of_glm<float>(b)); }));
#endif
  plot::BarChart chart("vectors_cost", "", {"time of a call [ns]"});
  for (const measure::Timing& one : measure::time_interleaved(all, effort))
  {
    const bool ours = one.name.find(", ") == std::string::npos || one.name.find("accurate") == 0;
    measure::add_bar(chart, one, ours ? plot::Ink::a : plot::Ink::muted);
  }
  chart.describe("The time of the recommended functions beside others'.").width(400);
  return chart;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "angle_chart",
      .summary = "Times ways to find an angle and to multiply vectors; draws cost against error.",
      .options = {effort_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const measure::Effort effort = measure::effort_named(given.value("effort"));
        plot::Grid grid("angle_chart", "", 1);
        grid.describe("Cost against error of ways to find an angle; " + measure::machine_line())
            .add(angles_chart<float>("float", "Angles of every size, float", effort))
            .add(angles_chart<double>("double", "Angles of every size, double", effort)
                     .note(measure::machine_line())
                     .size(400, 350));
        save_figure(given, "angle_chart.svg", grid.svg());
        save_figure(given, "vectors_cost.svg", cost_chart(effort).svg());
      });
}
