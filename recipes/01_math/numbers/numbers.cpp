/// \file
/// \brief Prints what rounding does near 1 and far from the origin, to products and to angles, and
/// draws the numbers of a small float.

#include "01_math/numbers/numbers.hpp"
#include "01_math/numbers/trial/compare_cases.hpp"
#include "01_math/numbers/trial/numbers_figures.hpp"
#include "01_math/numbers/trial/product_cases.hpp"
#include "01_math/numbers/trial/wrap_cases.hpp"
#include "common/math/norm.hpp"
#include "common/math/ulp.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

/// A float as a whole number over a power of two.
std::string fraction(float x)
{
  const int exponent = std::ilogb(x) - 23;
  return std::to_string(static_cast<long>(std::ldexp(x, -exponent))) + " / 2^" +
         std::to_string(-exponent);
}

/// Two spheres of radius 1 overlap by 0.01; both centres are rounded to float, far from the origin.
void print_far()
{
  Table table({"metres away", "gap", "depth, float", "depth, relative"});
  const Vector3<double> a_to_b = Vector3<double>(2, 3, 6) / 7 * 1.99;
  for (const double away : {0.0, 1e3, 1e4, 1e5, 1e6, 1e7})
  {
    const Vector3<double> a(away, away, away), b = a + a_to_b;
    const Vector3<float> rounded = b.cast<float>() - a.cast<float>();
    const Vector3<float> relative = (b - a).cast<float>();
    const auto depth = [](const Vector3<float>& d)
    { return number(std::round(1e5 * (2 - static_cast<double>(normalize(d).length))) / 1e5); };
    const double gap = away > 0 ? static_cast<double>(ulp(static_cast<float>(away))) : 0;
    table.row({number(away), number(gap), depth(rounded), depth(relative)});
  }
  std::cout << table.text();
}

void print_products()
{
  Table table({"ad − bc", "naive", "wider", "fused", "difference_of_products"});
  const auto add = [&]<class Real>(Real)
  {
    for (const ProductCase<Real>& one : product_cases(Real()))
    {
      std::vector<std::string> cells{one.what};
      for (const ProductMethod<Real>& method : product_methods<Real>())
      {
        const Real answer = method.difference(one.a, one.d, one.b, one.c);
        cells.push_back(std::isfinite(answer) ? number(static_cast<double>(answer)) : "none");
      }
      table.row(cells);
    }
  };
  add(0.0f);
  add(0.0);
  std::cout << table.text();
}

/// How far the remainder by the float next to 2π and `wrap_radians` are from the same in double.
void print_radians()
{
  Table table({"angle [rad]", "half the gap", "remainder off by", "wrap_radians off by"});
  for (const float angle : {4.0f, 100.0f, 1e4f, 1e6f, 1e8f, 1e10f})
  {
    const double truth = wrap_radians(static_cast<double>(angle));
    const auto off = [truth](float wrapped)
    {
      const double apart = std::abs(static_cast<double>(wrapped) - truth);
      return rounded(std::min(apart, std::abs(apart - 2 * M_PI)));
    };
    const float turn = static_cast<float>(2 * M_PI);
    table.row(
        {number(static_cast<double>(angle)), rounded(static_cast<double>(ulp(angle)) / 2),
         off(std::remainder(angle, turn)), off(wrap_radians(angle))});
  }
  std::cout << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "numbers",
      .summary = "What rounding does near 1 and far from the origin, to products and to angles."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        std::cout << "0.1 as a float is " << fraction(0.1f) << "\n\n";
        print_far();
        std::cout << "\n";
        print_products();
        std::cout << "\n";
        print_radians();
        plot::Grid grid("numbers", "", 1);
        grid.describe("The numbers of a float of three binary digits, and where 0.1 goes.")
            .add(gaps_figure())
            .add(tenth_figure());
        save_figure(given, "numbers.svg", grid.svg());
        std::vector<VerdictRow> products = product_verdicts(product_cases(0.0f));
        const std::vector<VerdictRow> doubles = product_verdicts(product_cases(0.0));
        products.insert(products.end(), doubles.begin(), doubles.end());
        save_figure(
            given, "numbers_wrap_cases.html",
            verdict_table(
                "Ways to wrap an angle: right means the same direction, exactly.",
                names_of(wrap_methods()), wrap_verdicts()));
        save_figure(
            given, "numbers_compare_cases.html",
            verdict_table(
                "Ways to compare two floats, in metres.", compare_names(), compare_verdicts()));
        save_figure(
            given, "numbers_product_cases.html",
            verdict_table(
                "Ways to subtract products: right means within an ulp.",
                names_of(product_methods<float>()), products));
      });
}
