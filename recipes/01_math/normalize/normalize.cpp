/// \file
/// \brief Normalises vectors from the smallest to the largest float in four ways.

#include "01_math/normalize/normalize.hpp"
#include "01_math/normalize/trial/normalize_cases.hpp"
#include "01_math/normalize/trial/normalize_libraries.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>

namespace
{

using namespace cookbook;

template <class Real>
void add_lengths(Table& table)
{
  for (const NormalizeCase<Real>& one : normalize_cases(Real()))
  {
    std::vector<std::string> cells{one.what};
    for (const NormalizeMethod<Real>& method : normalize_methods<Real>())
    {
      cells.push_back(number(static_cast<double>(method.normalize(one.v).length)));
    }
    table.row(cells);
  }
}

void print_lengths()
{
  Table table({"length of", "naive", "threshold", "wider", "scaled"});
  add_lengths<float>(table);
  add_lengths<double>(table);
  std::cout << table.text();
}

std::string verdicts()
{
  std::vector<VerdictRow> rows = normalize_verdicts(normalize_cases(0.0f));
  const std::vector<VerdictRow> doubles = normalize_verdicts(normalize_cases(0.0));
  rows.insert(rows.end(), doubles.begin(), doubles.end());
  return folded_verdict_table(
      "Ways to normalise: right means within four ulps, in length and direction.",
      {"naive", "threshold", "wider", "scaled"}, rows);
}

std::string libraries()
{
  std::vector<VerdictRow> rows = library_verdicts(normalize_cases(0.0f));
  const std::vector<VerdictRow> doubles = library_verdicts(normalize_cases(0.0));
  rows.insert(rows.end(), doubles.begin(), doubles.end());
  return folded_verdict_table(
      "What libraries make of the same vectors.", names_of(normalize_libraries<float>()), rows,
      "library");
}

/// The largest error among vectors of one size, infinite where a direction or a length is lost.
double worst_error(const NormalizeMethod<float>& method, int exponent)
{
  const float size = static_cast<float>(std::pow(10.0, exponent));
  double worst = 0;
  for (const Vector3<float>& v : vectors_of_size(size, 100))
  {
    const Direction<float> answer = method.normalize(v);
    worst = std::max(worst, answer.length == 0 ? HUGE_VAL : direction_error(answer, v));
  }
  return worst;
}

/// Draws a way's errors, and stands it in the row of failures where it begins to fail, above and
/// below 1.
void add_method(plot::Chart& chart, const NormalizeMethod<float>& method, plot::Look look)
{
  const auto size = [](int exponent) { return std::pow(10.0, exponent); };
  const auto fails = [&](int exponent) { return std::isinf(worst_error(method, exponent)); };
  int low = 0;
  int high = 0;
  for (; low > -44 && !fails(low - 1); --low)
  {
  }
  for (; high < 38 && !fails(high + 1); ++high)
  {
  }
  std::vector<Eigen::Vector2d> line;
  for (int exponent = low; exponent <= high; ++exponent)
  {
    line.push_back({size(exponent), worst_error(method, exponent)});
  }
  chart.line(method.name, line, look);
  look.marker = plot::Marker::cross;
  if (low > -44)
  {
    chart.fails(method.name + ", below", size(low - 1), look);
  }
  if (high < 38)
  {
    chart.fails(method.name + ", above", size(high + 1), look);
  }
}

plot::Chart chart()
{
  plot::Chart chart(
      "normalize", "", {"size of the vector", plot::Scale::log},
      {"worst error [ulp]", plot::Scale::log});
  chart.describe("Errors of four ways to normalise, from the smallest to the largest float.")
      .legend(plot::Legend::below)
      .name_failures("no length")
      .reference_y(allowed_ulps, "allowed")
      .size(400, 360);
  std::size_t index = 0;
  for (const NormalizeMethod<float>& method : normalize_methods<float>())
  {
    add_method(chart, method, plot::series_look(index++));
  }
  return chart;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "normalize",
      .summary = "Normalises vectors from the smallest to the largest float in four ways."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_lengths();
        save_figure(given, "normalize_cases.html", verdicts());
        save_figure(given, "normalize_libraries.html", libraries());
        save_figure(given, "normalize.svg", chart().svg());
      });
}
