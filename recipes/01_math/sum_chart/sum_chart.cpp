/// \file
/// \brief Times ways to add a million floats, to subtract products and to wrap angles, and draws
/// their cost against their error.

#include "01_math/sum_chart/trial/sum_chart.hpp"
#include "01_math/numbers/trial/wrap_cases.hpp"
#include "01_math/sum_chart/trial/product_chart.hpp"
#include "tools/measure/cost_chart.hpp"
#include "tools/program/program.hpp"

#include <limits>

namespace
{

using namespace cookbook;

plot::Chart new_chart(const std::string& name, const std::string& title, const std::string& unit)
{
  plot::Chart chart(
      name, title, {"time of " + unit + " [ns]", plot::Scale::log},
      {"error [ulp]", plot::Scale::log});
  chart.size(400, 320);
  return chart;
}

/// All ways to add, on the first of three lists; the error is that of all three.
plot::Chart
sums(const std::string& name, const std::string& title, Signs signs, const measure::Effort& effort)
{
  const std::vector<SumList> lists{sum_list(signs, 1), sum_list(signs, 2), sum_list(signs, 3)};
  const std::vector<float>& numbers = lists[0].numbers;
  std::vector<measure::ChartedMethod> ways;
  for (const SumMethod<float>& method : sum_methods<float>())
  {
    const auto run = [&numbers, method] { measure::keep(method.sum(numbers)); };
    ways.push_back(
        {{method.name, run, static_cast<double>(numbers.size())}, sum_errors(method, lists)});
  }
  plot::Chart chart = new_chart(name, title, "a number");
  measure::add_methods(chart, ways, effort);
  return chart;
}

using Difference = double (*)(double, double, double, double);

/// A way to subtract products, built into the loop over all of them.
template <class Way>
measure::Timed timed(const std::string& name, const std::vector<Products>& all, Way way)
{
  return measure::timed_over(
      name, all, [way](const Products& one) { return way(one.a, one.d, one.b, one.c); });
}

#if defined(__x86_64__) && defined(__GNUC__)
/// As `difference_fused`, where the compiler may use the processor's instruction.
__attribute__((target("fma"))) void fused_by_instruction(const std::vector<Products>& all)
{
  for (const Products& one : all)
  {
    const double first = one.a * one.d, second = one.b * one.c;
    const double lost_first = __builtin_fma(one.a, one.d, -first);
    const double lost_second = __builtin_fma(one.b, one.c, -second);
    measure::keep((first - second) + (lost_first - lost_second));
  }
}
#endif

plot::Chart products(const measure::Effort& effort)
{
  const std::vector<Products> all = unit_products(1000);
  const auto naive = [](auto... x) { return difference_naive<double>(x...); };
  const auto fused = [](auto... x) { return difference_fused<double>(x...); };
  const auto right = [](auto... x) { return difference_of_products<double>(x...); };
  const auto split = [](auto... x) { return difference_split(x...); };
  std::vector<measure::Timed> ways{
      timed("naive", all, naive), timed("fused", all, fused), timed("split", all, split),
      timed("difference_of_products", all, right)};
  std::vector<Difference> answers{naive, fused, split, right};
#if defined(__x86_64__) && defined(__GNUC__)
  if (__builtin_cpu_supports("fma"))
  {
    ways.push_back(
        {"fused, one instruction", [&all] { fused_by_instruction(all); },
         static_cast<double>(all.size())});
    answers.push_back(fused);
  }
#endif
  std::vector<measure::ChartedMethod> charted;
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    double worst = 0;
    for (const Products& one : all)
    {
      worst = std::max(worst, sum_error(answers[i](one.a, one.d, one.b, one.c), 1.0));
    }
    charted.push_back({ways[i], {worst, worst}});
  }
  plot::Chart chart = new_chart("products", "Doubles: ad − bc that is 1", "a difference");
  measure::add_methods(chart, charted, effort);
  chart.note(measure::machine_line());
  return chart;
}

/// Angles of random digits, from `least` to `most` turns.
std::vector<float> angles(double least, double most)
{
  std::mt19937 random(1);
  std::vector<float> all;
  for (int i = 0; i < 1000; ++i)
  {
    const double fraction = static_cast<double>(random()) * 0x1p-32;
    all.push_back(static_cast<float>(360 * least * std::pow(most / least, fraction)));
  }
  return all;
}

/// Ways to wrap, without the loop if it is not to be `asked`.
plot::Chart wraps(
    const std::string& name, const std::string& title, const std::vector<float>& all, bool asked,
    const measure::Effort& effort)
{
  std::vector<measure::Timed> ways{
      measure::timed_over("loop, as published", all, [](float x) { return wrap_loop(x); }),
      measure::timed_over("floor", all, [](float x) { return wrap_floor(x); }),
      measure::timed_over("remainder", all, [](float x) { return std::remainder(x, 360.0f); }),
      measure::timed_over("wrap_degrees", all, [](float x) { return wrap_degrees(x); })};
  const std::size_t first = asked ? 0 : 1;
  ways.erase(ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(first));
  std::vector<measure::ChartedMethod> charted;
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    double worst = 0;
    for (const float angle : all)
    {
      // The remainder of doubles is exact, and so is that of two angles within a turn.
      const double wrapped = static_cast<double>(wrap_methods()[first + i].wrap(angle));
      const double off = std::remainder(wrapped - std::remainder(angle, 360.0), 360.0);
      worst = std::max(worst, std::abs(off));
    }
    charted.push_back({ways[i], {worst, worst}});
  }
  plot::Chart chart(
      name, title, {"time of an angle [ns]", plot::Scale::log}, {"error [°]", plot::Scale::log});
  measure::add_methods(chart, charted, effort, std::numeric_limits<double>::max(), first);
  chart.size(400, 250);
  return chart;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "sum_chart",
      .summary = "Times ways to add a million floats, to subtract products and to wrap angles.",
      .options = {effort_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const measure::Effort effort = measure::effort_named(given.value("effort"));
        plot::Grid grid("sum_chart", "", 1);
        grid.describe("Cost against error of six ways to add; " + measure::machine_line())
            .add(sums("positive", "A million positive floats", Signs::positive, effort))
            .add(sums("random", "Random signs", Signs::random, effort))
            .add(sums("opposite", "Nearly all cancel", Signs::opposite, effort)
                     .note(measure::machine_line()));
        save_figure(given, "sum_chart.svg", grid.svg());
        plot::Grid wrap_grid("wrap_chart", "", 1);
        wrap_grid
            .describe("Cost against error of ways to wrap an angle; " + measure::machine_line())
            .add(wraps("ten", "Up to ten turns", angles(0.01, 10), true, effort))
            .add(wraps("many", "1e6 to 1e35 turns", angles(1e6, 1e35), false, effort)
                     .note(measure::machine_line()));
        save_figure(given, "wrap_chart.svg", wrap_grid.svg());
        save_figure(given, "product_chart.svg", products(effort).svg());
      });
}
