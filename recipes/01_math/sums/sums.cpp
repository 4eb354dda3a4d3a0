/// \file
/// \brief Adds many numbers in six ways, and draws the order in which two of them add.

#include "01_math/sums/sums.hpp"
#include "01_math/sums/trial/sums_cases.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

/// A hundred million ones, one after the other.
void print_ones()
{
  float naive = 0;
  RunningSum<float> running;
  for (int i = 0; i < 100000000; ++i)
  {
    naive += 1;
    running.add(1);
  }
  std::cout << "100000000 ones: naive " << static_cast<long>(naive) << ", RunningSum "
            << static_cast<long>(running.sum) << "\n\n";
}

template <class Real>
void add_digits(Table& table)
{
  const double most = std::numeric_limits<Real>::digits10 + 1;
  for (const SumCase<Real>& one : sum_cases(Real()))
  {
    std::vector<std::string> cells{one.what};
    for (const SumMethod<Real>& method : sum_methods<Real>())
    {
      const double off = std::abs(static_cast<double>(method.sum(one.numbers)) / one.right - 1);
      const double digits = std::clamp(-std::log10(off), 0.0, most);
      cells.push_back(std::isfinite(off) ? number(std::floor(digits)) : "0");
    }
    table.row(cells);
  }
}

void print_digits()
{
  std::vector<std::string> header{"right digits"};
  for (const SumMethod<float>& method : sum_methods<float>())
  {
    header.push_back(method.name);
  }
  Table table(header);
  add_digits<float>(table);
  add_digits<double>(table);
  std::cout << table.text();
}

/// An addition: a dot, and lines to what is added; the way of the first number is orange.
void draw_sum(
    plot::Figure2d& figure, const Eigen::Vector2d& at, const Eigen::Vector2d& first,
    const Eigen::Vector2d& other, bool on_way)
{
  figure
      .segment(
          first, at, on_way ? plot::Ink::b : plot::Ink::a, plot::Stroke::solid, on_way ? 3 : 1.6)
      .segment(other, at, plot::Ink::a);
}

/// Eight numbers on the ground.
plot::Figure2d eight_numbers(const std::string& name, double height)
{
  plot::Figure2d figure(name, "", {{-0.6, -0.75}, {8.4, height}, 400});
  for (int i = 0; i < 8; ++i)
  {
    figure.dot(
        {i, 0}, i == 0 ? plot::Ink::b : plot::Ink::a, "x_{" + std::to_string(i + 1) + "}",
        plot::Side::below);
  }
  return figure;
}

plot::Figure2d chain_figure()
{
  plot::Figure2d figure = eight_numbers("sums_chain", 3.4);
  figure.describe("Eight numbers added one after the other.");
  Eigen::Vector2d last(0, 0);
  for (int i = 1; i < 8; ++i)
  {
    const Eigen::Vector2d next(i, 0.4 * i);
    draw_sum(figure, next, last, {i, 0}, true);
    figure.dot(next, plot::Ink::ink);
    last = next;
  }
  figure.label({0.2, 2.6}, "naive: 7 roundings", plot::Side::right, plot::Ink::b);
  return figure;
}

plot::Figure2d tree_figure()
{
  plot::Figure2d figure = eight_numbers("sums_tree", 3.1);
  figure.describe("Eight numbers added in pairs.");
  for (int level = 0; level < 3; ++level)
  {
    const int step = 1 << level;
    const auto place = [](int of_level, int k)
    { return Eigen::Vector2d((1 << of_level) * (k + 0.5) - 0.5, 0.8 * of_level); };
    for (int k = 0; k < 4 / step; ++k)
    {
      const Eigen::Vector2d at = place(level + 1, k);
      draw_sum(figure, at, place(level, 2 * k), place(level, 2 * k + 1), k == 0);
      figure.dot(at, plot::Ink::ink);
    }
  }
  figure.label({4.2, 2.5}, "pairwise: 3 roundings", plot::Side::right, plot::Ink::b);
  return figure;
}

std::string verdicts()
{
  std::vector<VerdictRow> rows = sum_verdicts<float>();
  const std::vector<VerdictRow> doubles = sum_verdicts<double>();
  rows.insert(rows.end(), doubles.begin(), doubles.end());
  return verdict_table(
      "Ways to add. The first five cases are floats, the others doubles; right means within four "
      "ulps.",
      names_of(sum_methods<float>()), rows);
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "sums", .summary = "Adds many numbers in six ways, and says how far off they are."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_ones();
        print_digits();
        plot::Grid grid("sums", "", 1);
        grid.describe(
                "The order in which eight numbers are added, one after the other and in pairs.")
            .add(chain_figure())
            .add(tree_figure());
        save_figure(given, "sums.svg", grid.svg());
        save_figure(given, "sums_cases.html", verdicts());
      });
}
