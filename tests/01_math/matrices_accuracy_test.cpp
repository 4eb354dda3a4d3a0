/// \file
/// Determinants and inverses of matrices over the whole range of float and double.

#include "01_math/matrices/matrices.hpp"
#include "01_math/truth/trial/whole_range.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <cmath>
#include <limits>

using namespace cookbook;

namespace
{

// [drawn_matrix]
/// Matrices of six kinds: entries of any size each; of one size; of ordinary size; rounded from a
/// singular one, of a thousandth to a thousand; the same, one entry an ulp farther; diagonal.
template <class Real, int Size>
SquareMatrix<Real, Size> drawn_matrix(WholeRange<Real>& random, int kind)
{
  SquareMatrix<Real, Size> m;
  const bool near_singular = kind == 3 || kind == 4;
  const Real size = kind == 1       ? random.number() / 4
                    : near_singular ? std::ldexp(Real(1), random.drawn(-10, 10))
                                    : Real(1);
  for (int i = 0; i < Size * Size; ++i)
  {
    const bool off_diagonal = i % (Size + 1) != 0;
    m.data()[i] = kind == 0 ? random.number() : random.fraction() * size;
    m.data()[i] = kind == 5 ? (off_diagonal ? Real(0) : random.number()) : m.data()[i];
  }
  if (near_singular)
  {
    // The last column is a sum of two others, exactly, and then rounded once.
    for (int i = 0; i < Size; ++i)
    {
      const double sum = 2.0 * static_cast<double>(m(i, 0)) + static_cast<double>(m(i, 1));
      m(i, Size - 1) = static_cast<Real>(sum);
    }
    m(0, 0) = kind == 4 ? std::nextafter(m(0, 0), 2 * size) : m(0, 0);
  }
  return m;
}
// [drawn_matrix]

/// What is known of a matrix, in a hundred digits.
template <int Size>
struct Known
{
  SquareMatrix<Reference, Size> c;     ///< cofactors
  SquareMatrix<Reference, Size> sizes; ///< the same products without their signs
  Reference determinant;
  Reference permanent;
  Reference moves; ///< by how much the determinant moves, for relative changes of one
};

/// The permanent of what is left of a matrix without a row and a column; its determinant too.
inline std::pair<Reference, Reference>
left_of(const SquareMatrix<Reference, 4>& m, int row, int column)
{
  Matrix3<Reference> left;
  for (int i = 0; i < 9; ++i)
  {
    left(i / 3, i % 3) = m(i / 3 + (i / 3 >= row), i % 3 + (i % 3 >= column));
  }
  const auto product = [&](int j, int k, int l) -> Reference
  { return left(0, j) * left(1, k) * left(2, l); };
  const Reference plus[] = {product(0, 1, 2), product(1, 2, 0), product(2, 0, 1)};
  const Reference minus[] = {product(0, 2, 1), product(2, 1, 0), product(1, 0, 2)};
  Reference determinant = 0, permanent = 0;
  for (int i = 0; i < 3; ++i)
  {
    determinant += plus[i] - minus[i];
    permanent += abs(plus[i]) + abs(minus[i]);
  }
  return {determinant, permanent};
}

inline std::pair<Reference, Reference>
left_of(const SquareMatrix<Reference, 3>& m, int row, int column)
{
  const int i = row == 0, j = row == 2 ? 1 : 2, k = column == 0, l = column == 2 ? 1 : 2;
  const Reference plus = m(i, k) * m(j, l), minus = m(i, l) * m(j, k);
  return {plus - minus, abs(plus) + abs(minus)};
}

template <class Real, int Size>
Known<Size> known(const SquareMatrix<Real, Size>& of)
{
  SquareMatrix<Reference, Size> m;
  for (int i = 0; i < Size * Size; ++i)
  {
    m.data()[i] = Reference(of.data()[i]);
  }
  Known<Size> all{{}, {}, 0, 0, 0};
  for (int i = 0; i < Size; ++i)
  {
    for (int j = 0; j < Size; ++j)
    {
      const auto [determinant, permanent] = left_of(m, i, j);
      all.c(i, j) = (i + j) % 2 == 0 ? determinant : Reference(-determinant);
      all.sizes(i, j) = permanent;
      all.moves += abs(Reference(m(i, j) * all.c(i, j)));
      if (j == 0)
      {
        all.determinant += m(i, 0) * all.c(i, 0);
        all.permanent += abs(m(i, 0)) * permanent;
      }
    }
  }
  return all;
}

/// The largest fraction of what the page allows that an inverse or a determinant is off by.
template <class Real, int Size>
double worst_of()
{
  using Limits = std::numeric_limits<Real>;
  WholeRange<Real> random;
  const Reference u = Reference(Limits::epsilon()) / 2,
                  few = Reference(std::ldexp(1.0, Limits::digits / 4));
  const Reference least = Limits::denorm_min(), most = Limits::max();
  Reference worst = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const SquareMatrix<Real, Size> m = drawn_matrix<Real, Size>(random, i % 6);
    const Known<Size> truth = known<Real, Size>(m);
    const Reference size = abs(truth.determinant);
    const Real answered = determinant<Real, Size>(m);
    const Reference det_bound = u * (9 * few) * size + least + truth.permanent * Reference(0x1p-98);
    if (size <= most)
    {
      REQUIRE(std::isfinite(answered));
      worst = std::max<Reference>(worst, abs(Reference(answered) - truth.determinant) / det_bound);
    }
    const auto x = inverse<Real, Size>(m);
    const Reference first = u * truth.moves, second = u * u * truth.permanent;
    if (!x)
    {
      REQUIRE(size <= (first + 65 * second));
      continue;
    }
    REQUIRE(size >= (first + 63 * second));
    for (int k = 0; k < Size * Size; ++k)
    {
      const int row = k / Size, column = k % Size;
      const Reference exact = truth.c(column, row) / truth.determinant;
      const Reference rounding = truth.sizes(column, row) / size + 2 * few * abs(exact);
      const Reference bound = u * 9 * rounding + 4 * least * (1 + 1 / size);
      if (abs(exact) <= most)
      {
        REQUIRE(std::isfinite((*x)(row, column)));
        worst = std::max<Reference>(worst, abs(Reference((*x)(row, column)) - exact) / bound);
      }
    }
  }
  return static_cast<double>(worst);
}

} // namespace

// [whole_range_inverse]
TEMPLATE_TEST_CASE_SIG(
    "inverse and determinant of 100,000 matrices of all sizes are right to the page's bound",
    "[M11]", ((class Real, int Size), Real, Size), (float, 3), (double, 3), (float, 4), (double, 4))
{
  CHECK(worst_of<Real, Size>() <= 1);
}
// [whole_range_inverse]
