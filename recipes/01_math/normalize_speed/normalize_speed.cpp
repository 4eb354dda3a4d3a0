/// \file
/// \brief Times eight ways to normalise, and draws their cost against their error.

#include "01_math/normalize_speed/trial/normalize_speed.hpp"
#include "01_math/normalize/trial/normalize_libraries.hpp"
#include "tools/measure/cost_chart.hpp"
#include "tools/program/program.hpp"

#ifdef COOKBOOK_HAS_GLM
#include <glm/glm.hpp>
#endif

namespace
{

using namespace cookbook;

using Vectors = std::vector<Vector3<float>>;

#ifdef COOKBOOK_HAS_GLM
Vector3<float> normalized_glm(const Vector3<float>& v)
{
  const glm::vec3 unit = glm::normalize(glm::vec3(v.x(), v.y(), v.z()));
  return {unit.x, unit.y, unit.z};
}
#endif

/// Each way is called directly, so that the compiler may build it into the loop. Eigen and GLM do
/// not say the length; their directions are compared.
std::vector<measure::ChartedMethod> contenders(const Vectors& vectors)
{
  const auto ours = normalize_methods<float>();
  const auto libraries = normalize_libraries<float>();
  const auto measured =
      [&vectors](const measure::Timed& timed, const NormalizeMethod<float>& method) {
        return measure::ChartedMethod{timed, normalize_errors(method, vectors)};
      };
  std::vector<measure::ChartedMethod> all{
      measured(
          measure::timed_over(
              "naive", vectors, [](const auto& v) { return normalize_naive<float>(v); }),
          ours[0]),
      measured(
          measure::timed_over(
              "threshold", vectors, [](const auto& v) { return normalize_threshold<float>(v); }),
          ours[1]),
      measured(
          measure::timed_over(
              "wider", vectors, [](const auto& v) { return normalize_wide<float>(v); }),
          ours[2]),
      measured(
          measure::timed_over("scaled", vectors, [](const auto& v) { return normalize<float>(v); }),
          ours[3]),
      measured(
          measure::timed_over(
              "Eigen", vectors, [](const auto& v) { return Vector3<float>(v.normalized()); }),
          libraries[0]),
      measured(
          measure::timed_over(
              "stable", vectors,
              [](const auto& v) { return Vector3<float>(v.stableNormalized()); }),
          libraries[1]),
      measured(
          measure::timed_over(
              "hypot", vectors, [](const auto& v) { return normalize_hypot<float>(v); }),
          libraries[2])};
#ifdef COOKBOOK_HAS_GLM
  all.push_back(measured(
      measure::timed_over("GLM", vectors, normalized_glm),
      {"GLM", [](const Vector3<float>& v) {
         return Direction<float>{normalized_glm(v), normalize_naive<float>(v).length};
       }}));
#endif
  return all;
}

plot::Chart chart(
    const std::string& name, const std::string& title, const Vectors& vectors,
    const measure::Effort& effort)
{
  plot::Chart chart(
      name, title, {"time of a call [ns]", plot::Scale::log},
      {"error [ulp]", plot::Scale::log, 0.3, 3});
  measure::add_methods(chart, contenders(vectors), effort, 1000);
  chart.size(400, 330).name_failures("lost");
  return chart;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "normalize_speed",
      .summary = "Times eight ways to normalise, and draws their cost against their error.",
      .options = {effort_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const measure::Effort effort = measure::effort_named(given.value("effort"));
        plot::Grid grid("normalize_speed", "", 1);
        grid.describe("Cost against error of eight ways to normalise; " + measure::machine_line())
            .add(chart("room", "A room: a millimetre to a kilometre", room_vectors(), effort))
            .add(chart("all", "Every size that a float can have", all_vectors(), effort)
                     .note(measure::machine_line())
                     .size(400, 380));
        save_figure(given, "normalize_speed.svg", grid.svg());
      });
}
