/// \file
/// \brief Determinants, conditions and inverses of a few matrices, and of a reader's own.

#include "01_math/matrices/matrices.hpp"
#include "01_math/matrices/trial/matrices_figures.hpp"
#include "01_math/matrices/trial/matrix_instances.hpp"
#include "tools/program/asking.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

void print_inverses()
{
  Table table({"matrix", "determinant", "condition", "inverse, first row"});
  for (const MatrixCase<double>& one : matrix_cases<double>())
  {
    const std::optional<Matrix3<double>> answer = inverse<double, 3>(one.m);
    const auto entry = [&](int j) { return number((*answer)(0, j)); };
    table.row(
        {one.what.substr(0, one.what.find(", double")), number(determinant<double, 3>(one.m)),
         rounded(condition<double, 3>(one.m)),
         answer ? entry(0) + ", " + entry(1) + ", " + entry(2) : "singular"});
  }
  std::cout << table.text();
}

std::string verdicts()
{
  std::vector<VerdictRow> all = inverse_verdicts<float>();
  const std::vector<VerdictRow> doubles = inverse_verdicts<double>();
  all.insert(all.end(), doubles.begin(), doubles.end());
  return folded_verdict_table(
      "Ways to invert a matrix: right means off by at most 16 roundings of its entries, or "
      "saying so where it is singular.",
      names_of(inverse_methods<float>()), all);
}

/// Nine numbers of a row, from left to right and from top to bottom.
template <class Real>
Matrix3<Real> matrix_of(const PairsRow& row)
{
  Matrix3<Real> m;
  m << row.vector<Real>(0).transpose(), row.vector<Real>(3).transpose(),
      row.vector<Real>(6).transpose();
  return m;
}

/// What may be asked of each row.
template <class Real>
std::vector<Question<Real>> questions(Real)
{
  const std::string columns = "m00,m01,m02,m10,m11,m12,m20,m21,m22";
  const auto inverted = [](const PairsRow& row)
  {
    std::vector<Real> numbers;
    if (const std::optional<Matrix3<Real>> x = inverse<Real, 3>(matrix_of<Real>(row)))
    {
      for (int i = 0; i < 9; ++i)
      {
        numbers.push_back((*x)(i / 3, i % 3) + Real(0)); // no negative zero
      }
    }
    return numbers;
  };
  return {
      {"determinant", columns, "determinant",
       [](const PairsRow& row)
       { return std::vector<Real>{determinant<Real, 3>(matrix_of<Real>(row)) + Real(0)}; }},
      {"inverse", columns, "i00,i01,i02,i10,i11,i12,i20,i21,i22", inverted}};
}

} // namespace

int main(int argc, char** argv)
{
  return run_asking_program(
      argc, argv,
      {.name = "matrices", .summary = "Determinants, conditions and inverses of 3 by 3 matrices."},
      [](auto zero) { return questions(zero); },
      [](const Arguments& given)
      {
        print_inverses();
        save_figure(given, "matrices_cases.html", verdicts());
        save_figure(given, "matrices.svg", columns_figure().svg());
        save_figure(given, "matrices_near.svg", near_figure().svg());
      });
}
