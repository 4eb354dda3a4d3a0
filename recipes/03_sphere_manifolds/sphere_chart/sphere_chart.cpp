/// \file
/// \brief Measures every method for two spheres, and draws cost against error.

#include "03_sphere_manifolds/sphere_chart/trial/sphere_chart.hpp"
#include "03_sphere_manifolds/sphere_chart/trial/sphere_chart_peers.hpp"
#include "03_sphere_manifolds/sphere_methods/trial/sphere_methods_truth.hpp"
#include "03_sphere_manifolds/sphere_pairs/sphere_pairs.hpp"
#include "tools/measure/cost_chart.hpp"
#include "tools/program/program.hpp"

#include <cstring>
#include <iostream>

namespace
{

using namespace cookbook;

/// How much is measured.
struct Extent
{
  std::size_t in_cache = 2048;
  std::size_t in_memory = 1'000'000;
  std::size_t for_errors = 2000;
  measure::Effort effort{};
};

FloatPairs float_pairs(const Recipe& recipe, std::size_t count)
{
  FloatPairs pairs;
  for (const auto& [a, b] : sphere_workload(recipe, count).pairs)
  {
    pairs.push_back(
        {{a.center.cast<float>(), static_cast<float>(a.radius)},
         {b.center.cast<float>(), static_cast<float>(b.radius)}});
  }
  return pairs;
}

/// A method, how to run it on pairs, and the depths it finds.
struct Contender
{
  std::string name;
  bool peer;
  std::function<std::function<void()>(const FloatPairs&)> prepare;
  std::function<std::vector<std::optional<double>>(const FloatPairs&)> depths;
};

/// A method that answers one pair of spheres of type Real.
template <class Real, class Method>
Contender one_by_one(const std::string& name, Method method)
{
  using Pairs = std::vector<std::pair<Sphere<Real>, Sphere<Real>>>;
  const auto converted = [](const FloatPairs& pairs)
  {
    const auto sphere = [](const Sphere<float>& s) {
      return Sphere<Real>{s.center.template cast<Real>(), Real(s.radius)};
    };
    Pairs result;
    for (const auto& [a, b] : pairs)
    {
      result.push_back({sphere(a), sphere(b)});
    }
    return result;
  };
  const auto prepare = [=](const FloatPairs& pairs) -> std::function<void()>
  {
    return [=, own = converted(pairs)]
    {
      for (const auto& [a, b] : own)
      {
        const std::optional<Manifold<Real>> manifold = method(a, b);
        measure::keep(manifold);
      }
    };
  };
  const auto depths = [=](const FloatPairs& pairs)
  {
    std::vector<std::optional<double>> result;
    for (const auto& [a, b] : converted(pairs))
    {
      const std::optional<Manifold<Real>> manifold = method(a, b);
      result.push_back(manifold ? std::optional<double>(manifold->depth) : std::nullopt);
    }
    return result;
  };
  return {name, false, prepare, depths};
}

/// Lists of pairs and of their overlaps, and the batch on them.
std::function<void()> batch_on(const FloatPairs& pairs, InstructionSet set)
{
  const auto in = std::make_shared<Lists>(lists_of_pairs(pairs));
  const auto out = std::make_shared<Lists>(lists_of_overlaps(pairs.size()));
  return [=] { sphere_pairs(pairs_of(*in), overlaps_of(*out), set); };
}

Contender batch(const std::string& name, InstructionSet set)
{
  const auto depths = [=](const FloatPairs& pairs)
  {
    const Lists in = lists_of_pairs(pairs);
    Lists out = lists_of_overlaps(pairs.size());
    sphere_pairs(pairs_of(in), overlaps_of(out), set);
    std::vector<std::optional<double>> result;
    for (const float depth : out[3])
    {
      result.push_back(depth >= 0 ? std::optional<double>(depth) : std::nullopt);
    }
    return result;
  };
  return {name, false, [=](const FloatPairs& pairs) { return batch_on(pairs, set); }, depths};
}

/// Another library, prepared by the constructor of `Pairs`.
template <class Pairs>
[[maybe_unused]] Contender peer(const std::string& name)
{
  const auto prepare = [](const FloatPairs& pairs) -> std::function<void()>
  { return [own = std::make_shared<Pairs>(pairs)] { own->run(); }; };
  const auto depths = [](const FloatPairs& pairs)
  {
    Pairs own(pairs);
    std::vector<std::optional<double>> result;
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      result.push_back(own.depth(i));
    }
    return result;
  };
  return {name, true, prepare, depths};
}

std::vector<Contender> contenders()
{
  // Lambdas rather than function pointers: every method may be inlined into its loop.
  using Float = const Sphere<float>&;
  std::vector<Contender> all{
      one_by_one<float>(
          "as published", [](Float a, Float b) { return sphere_sphere_as_published(a, b); }),
      one_by_one<float>(
          "plain_sphere_sphere, float", [](Float a, Float b) { return plain_sphere_sphere(a, b); }),
      one_by_one<float>(
          "reciprocal in 0 steps",
          [](Float a, Float b) { return sphere_sphere_reciprocal<0>(a, b); }),
      one_by_one<float>(
          "reciprocal in 1 step",
          [](Float a, Float b) { return sphere_sphere_reciprocal<1>(a, b); }),
      one_by_one<float>(
          "reciprocal in 2 steps",
          [](Float a, Float b) { return sphere_sphere_reciprocal<2>(a, b); }),
      one_by_one<float>(
          "reciprocal in 3 steps",
          [](Float a, Float b) { return sphere_sphere_reciprocal<3>(a, b); }),
      one_by_one<float>(
          "sphere_sphere, float", [](Float a, Float b) { return sphere_sphere<float>(a, b); }),
      one_by_one<double>(
          "sphere_sphere, double", [](const Sphere<double>& a, const Sphere<double>& b)
          { return sphere_sphere<double>(a, b); })};
  for (const InstructionSet set : instruction_sets())
  {
    all.push_back(batch("sphere_pairs, " + name_of(set), set));
  }
#if defined(COOKBOOK_HAS_ODE)
  all.push_back(peer<OdePairs>("ODE"));
#endif
#if defined(COOKBOOK_HAS_BULLET)
  all.push_back(peer<BulletPairs>("Bullet"));
#endif
  return all;
}

/// Errors of the depth on mixed pairs, infinite where the verdict is wrong.
std::vector<measure::ErrorStatistics>
errors_of(const std::vector<Contender>& all, std::size_t count)
{
  const Recipe mixed = sphere_workload_recipes()[0];
  std::vector<double> truth, unit;
  for (const WorldPair& pair : sphere_workload(mixed, count).pairs)
  {
    const auto manifold = exact_sphere_sphere(pair);
    truth.push_back(manifold ? static_cast<double>(manifold->depth) : -1);
    unit.push_back(ulp(static_cast<float>(std::max(pair.first.radius, pair.second.radius))));
  }
  std::vector<measure::ErrorStatistics> statistics;
  for (const Contender& contender : all)
  {
    const auto depths = contender.depths(float_pairs(mixed, count));
    std::vector<double> errors;
    for (std::size_t i = 0; i < count; ++i)
    {
      const bool right = depths[i].has_value() == (truth[i] >= 0);
      errors.push_back(
          !right      ? std::numeric_limits<double>::infinity()
          : depths[i] ? std::abs(*depths[i] - truth[i]) / unit[i]
                      : 0);
    }
    statistics.push_back(measure::error_statistics(errors));
  }
  return statistics;
}

std::vector<MeasuredMethod> measured_methods(const Extent& extent)
{
  const std::vector<Contender> all = contenders();
  std::vector<MeasuredMethod> methods;
  for (const measure::ErrorStatistics& errors : errors_of(all, extent.for_errors))
  {
    methods.push_back({{}, errors});
  }
  for (std::size_t w = 0; w < 3; ++w)
  {
    const FloatPairs pairs = float_pairs(sphere_workload_recipes()[w], extent.in_cache);
    const double count = static_cast<double>(pairs.size());
    std::vector<measure::Timed> timed;
    for (const Contender& contender : all)
    {
      timed.push_back({contender.name, contender.prepare(pairs), count, contender.peer});
    }
    const auto timings = measure::time_interleaved(timed, extent.effort);
    for (std::size_t m = 0; m < all.size(); ++m)
    {
      methods[m].times.push_back(timings[m]);
    }
  }
  return methods;
}

constexpr double bytes_of_pair = 15 * sizeof(float);

std::vector<measure::Timing> measured_streams(const Extent& extent)
{
  const FloatPairs pairs = float_pairs(sphere_workload_recipes()[0], extent.in_memory);
  const double count = static_cast<double>(pairs.size());
  std::vector<measure::Timed> timed;
  std::vector<measure::AtLeast> limits;
  for (const InstructionSet set : instruction_sets())
  {
    timed.push_back({"sphere_pairs, " + name_of(set), batch_on(pairs, set), count});
    limits.push_back({timed.back().name, "plain copy of as many bytes"});
  }
  // A copy reads as much as it writes: half of what the batch moves in all.
  std::vector<char> from(pairs.size() * 30, 1), to(pairs.size() * 30);
  const auto copy = [&]
  {
    std::memcpy(to.data(), from.data(), from.size());
    measure::keep(to[0]);
  };
  timed.push_back({"plain copy of as many bytes", copy, count});
  return measure::time_interleaved(timed, extent.effort, limits);
}

/// The look of a method: circles one by one in float, squares in double, triangles many at once,
/// diamonds other libraries.
plot::Look look_of(const measure::Timing& timing)
{
  const auto is = [&timing](const char* word)
  { return timing.name.find(word) != std::string::npos; };
  const plot::Marker marker = timing.peer          ? plot::Marker::diamond
                              : is("sphere_pairs") ? plot::Marker::triangle
                              : is("double")       ? plot::Marker::square
                                                   : plot::Marker::circle;
  const plot::Ink ink = timing.peer        ? plot::Ink::muted
                        : is("reciprocal") ? plot::Ink::series4
                        : is("plain")      ? plot::Ink::series2
                                           : plot::Ink::series1;
  return {ink, marker, {}};
}

/// The methods on mixed pairs; the batch answers as sphere_sphere does.
std::vector<measure::ChartedPoint> charted_points(const std::vector<MeasuredMethod>& methods)
{
  std::vector<measure::ChartedPoint> points;
  for (const MeasuredMethod& method : methods)
  {
    const measure::Timing& timing = method.times[0];
    const bool batch = measure::method_of(timing.name) == "sphere_pairs";
    points.push_back({timing, method.errors, look_of(timing), batch ? "sphere_sphere" : ""});
  }
  return points;
}

std::string chart_svg(const std::vector<MeasuredMethod>& methods)
{
  plot::Chart chart(
      "sphere_chart", "Two spheres: cost against error, mixed pairs in cache",
      {"time [ns a pair]", plot::Scale::log},
      {"error of the depth [ulp of the larger radius]", plot::Scale::log});
  chart.describe("Time of each method against its largest error and its 99th percentile.")
      .note(measure::machine_line())
      .size(800, 520);
  measure::draw_methods(chart, charted_points(methods), useless_error);
  return chart.svg();
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "sphere_chart",
      .summary = "Speed against accuracy of every method for two spheres.",
      .options = {effort_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        Extent extent;
        if (given.value("effort") == "quick")
        {
          extent = {2048, 200'000, 300, measure::effort_named("quick")};
        }
        const std::vector<MeasuredMethod> methods = measured_methods(extent);
        const std::string html =
            html_table(methods_table(methods)) +
            html_table(streams_table(measured_streams(extent), bytes_of_pair)) + "<p>" +
            measure::knee_sentence(
                charted_points(methods), "no depth more than", " ulp of the larger radius off",
                1e-3, useless_error) +
            "</p>\n<p>" + measure::machine_line() + ".</p>\n";
        save_figure(given, "sphere_chart.svg", chart_svg(methods));
        save_figure(given, "sphere_chart.html", html);
        std::cout << html;
      });
}
