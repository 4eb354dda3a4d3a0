/// \file
/// \brief Times ways to cast a ray at a ball, a box and a triangle, and draws cost against error.

#include "02_primitives/cast_chart/trial/cast_chart.hpp"
#include "02_primitives/cast_chart/trial/cast_peers.hpp"
#include "tools/measure/cost_chart.hpp"
#include "tools/program/program.hpp"

namespace
{

using namespace cookbook;

template <class Shape>
using Casts = std::vector<KnownCast<Shape>>;

/// A way by its name: timed, and asked for its errors.
template <class Shape, class Method>
measure::ChartedMethod
timed_method(const std::string& name, const Casts<Shape>& casts, Method method)
{
  const auto call = [method](const KnownCast<Shape>& one) { return method(one.ray, one.shape); };
  return {measure::timed_over(name, casts, call), cast_errors<Shape>(method, casts)};
}

/// The way that is recommended, as float and in double inside.
template <class Shape>
void add_ours(std::vector<measure::ChartedMethod>& methods, const Casts<Shape>& casts)
{
  methods.push_back(timed_method(
      "recommended, float", casts,
      [](const Ray<float>& ray, const Shape& shape) { return cast_in_float(ray, shape); }));
  methods.push_back(timed_method(
      "recommended", casts,
      [](const Ray<float>& ray, const Shape& shape)
      {
        const auto hit = cast(ray, shape);
        return hit ? std::optional(hit->t) : std::nullopt;
      }));
}

plot::Chart chart_of(
    const std::string& name, const std::string& title,
    const std::vector<measure::ChartedMethod>& methods, const measure::Effort& effort)
{
  plot::Chart chart(
      name, title, {"time of a call [ns]", plot::Scale::log},
      {"error as a part of t", plot::Scale::log});
  measure::add_methods(chart, methods, effort);
  chart.size(400, 310).name_failures("misses");
  return chart;
}

plot::Chart sphere_chart(const measure::Effort& effort)
{
  using Shape = Sphere<float>;
  const Casts<Shape> casts = known_spheres(1000);
  std::vector<measure::ChartedMethod> methods{
      timed_method("as published", casts, sphere_as_published),
      timed_method("as taught", casts, sphere_quadratic)};
  add_ours(methods, casts);
  return chart_of("sphere", "A ball of 1 m, up to 10 km away", methods, effort);
}

plot::Chart box_chart(const measure::Effort& effort)
{
  using Shape = Aabb<float>;
  const Casts<Shape> casts = known_boxes(1000);
  std::vector<measure::ChartedMethod> methods{
      timed_method("as published", casts, box_as_published),
      timed_method("by inverse", casts, box_by_inverse)};
  add_ours(methods, casts);
#ifdef COOKBOOK_HAS_BULLET
  methods.push_back(timed_method("Bullet", casts, bullet_box));
#endif
  return chart_of("box", "A box of 0.4 to 2 m, aimed at", methods, effort);
}

plot::Chart triangle_chart(const measure::Effort& effort)
{
  using Shape = Triangle<float>;
  const Casts<Shape> casts = known_triangles(1000);
  std::vector<measure::ChartedMethod> methods{
      timed_method("as published", casts, triangle_as_published),
      timed_method(
          "Möller–Trumbore", casts,
          [](const Ray<float>& ray, const Shape& shape) { return moller_trumbore(ray, shape); })};
  add_ours(methods, casts);
#ifdef COOKBOOK_HAS_BULLET
  methods.push_back(timed_method("Bullet", casts, bullet_triangle));
#endif
  const Casts<Shape> few(casts.begin(), casts.begin() + 100);
  methods.push_back(timed_method(
      "in fractions", few,
      [](const Ray<float>& ray, const Shape& shape)
      { return std::optional(static_cast<float>(*cast_in_fractions(ray, shape))); }));
  return chart_of("triangle", "A triangle of some metres, aimed at", methods, effort);
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "cast_chart",
      .summary = "Times ways to cast a ray at a ball, a box and a triangle; cost against error.",
      .options = {effort_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const measure::Effort effort = measure::effort_named(given.value("effort"));
        plot::Grid grid("cast_chart", "", 1);
        grid.describe("Cost against error of casts; " + measure::machine_line())
            .add(sphere_chart(effort))
            .add(box_chart(effort))
            .add(triangle_chart(effort).note(measure::machine_line()).size(400, 370));
        save_figure(given, "cast_chart.svg", grid.svg());
      });
}
