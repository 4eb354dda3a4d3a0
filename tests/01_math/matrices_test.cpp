/// \file
/// What holds for determinants and inverses: formula M11, and matrices that break a way to invert.

#include "01_math/matrices/matrices.hpp"
#include "01_math/matrices/trial/matrix_instances.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace cookbook;

namespace
{

/// A matrix of whole numbers from -4 to 4, another one each time.
template <int Size>
SquareMatrix<Rational, Size> whole_matrix(std::mt19937& random)
{
  SquareMatrix<Rational, Size> m;
  for (int i = 0; i < Size * Size; ++i)
  {
    m.data()[i] = static_cast<int>(random() % 9) - 4;
  }
  return m;
}

} // namespace

// [M11]
TEST_CASE("2 0 1, 1 3 2, 1 1 2 has determinant 6 and inverse 4 1 -3, 0 3 -3, -2 -2 6 by 6", "[M11]")
{
  Matrix3<double> m, six_times_inverse;
  m << 2, 0, 1, 1, 3, 2, 1, 1, 2;
  six_times_inverse << 4, 1, -3, 0, 3, -3, -2, -2, 6;
  CHECK(determinant<double, 3>(m) == 6);
  CHECK(cofactors<double>(m) == six_times_inverse.transpose());
  CHECK(adjugate_inverse<double, 3>(m) == six_times_inverse / 6);
  // Three roundings: one over six, the product with it, and six over its own.
  CHECK((6 * *inverse<double, 3>(m) - six_times_inverse).cwiseAbs().maxCoeff() <= 3 * 0x1p-51);
}
// [M11]

// [plain_inverse]
TEST_CASE(
    "the plain inverse agrees within a kilometre's scales; of Scale(1e-160) only ours is right",
    "[M11]")
{
  std::mt19937 random(57);
  for (int i = 0; i < 1000; ++i)
  {
    const Matrix3<double> bent = Matrix3<double>::NullaryExpr(
        [&] { return (static_cast<double>(random()) * 0x1p-31 - 1) / 4; });
    const Matrix3<double> m = (Matrix3<double>::Identity() + bent) * std::pow(10.0, i % 7 - 3);
    const Matrix3<double> ours = inverse<double, 3>(m).value();
    CHECK((adjugate_inverse<double, 3>(m) - ours).norm() < 1e-14 * ours.norm());
  }
  const Matrix3<double> tiny = 1e-160 * Matrix3<double>::Identity();
  CHECK_FALSE(adjugate_inverse<double, 3>(tiny).allFinite());
  CHECK(inverse<double, 3>(tiny)->isApprox(1e160 * Matrix3<double>::Identity()));
}
// [plain_inverse]

// [M11_exact]
TEMPLATE_TEST_CASE_SIG(
    "a matrix times its adjugate is its determinant times one, for 300 whole matrices", "[M11]",
    ((int Size), Size), 3, 4)
{
  using Exact = SquareMatrix<Rational, Size>;
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i)
  {
    const Exact m = whole_matrix<Size>(random), other = whole_matrix<Size>(random);
    const Exact c = cofactors<Rational>(m);
    const Rational det = m.col(0).dot(c.col(0));
    CHECK(m * c.transpose() == Exact(det * Exact::Identity()));
    CHECK(c.transpose() * m == Exact(det * Exact::Identity()));
    // The determinant of a product is the product of the determinants.
    const Exact product = m * other;
    const Rational det_other = other.col(0).dot(cofactors<Rational>(other).col(0));
    CHECK(product.col(0).dot(cofactors<Rational>(product).col(0)) == det * det_other);
    CHECK(permanent<Rational>(m) >= abs(det));
  }
}
// [M11_exact]

// [volume]
TEST_CASE(
    "a determinant is a volume: 24 for edges of 2, 3 and 4, also sheared; -24 mirrored", "[M11]")
{
  Matrix3<double> sheared;
  sheared << 2, 5, -7, 0, 3, 9, 0, 0, 4;
  CHECK(determinant<double, 3>(sheared) == 24);
  sheared.col(0).swap(sheared.col(1));
  CHECK(determinant<double, 3>(sheared) == -24);
}
// [volume]

TEST_CASE(
    "the permanent of 1 2 3, 4 5 6, 7 8 9 is 450, whatever the signs; of ones, 6 and 24", "[M11]")
{
  // 1(45 + 48) + 2(36 + 42) + 3(32 + 35)
  Matrix3<double> m;
  m << 1, -2, 3, -4, 5, 6, 7, 8, -9;
  CHECK(permanent<double>(m) == 450);
  CHECK(permanent<double>(Matrix3<double>(Matrix3<double>::Ones())) == 6);
  CHECK(permanent<double>(Matrix4<double>(Matrix4<double>::Ones())) == 24);
  // Of its rows each, and of its columns, the fourth has one entry: what is left is the first test.
  Matrix4<double> larger = Matrix4<double>::Zero();
  larger.topRightCorner<3, 3>() = m;
  larger(3, 0) = -2;
  CHECK(permanent<double>(larger) == 900);
}

TEST_CASE(
    "a diagonal matrix has the condition 1, and 1 1 0, 1 1.01 0, 0 0 1 that of 403 / 3", "[M11]")
{
  CHECK(condition<double, 3>(Vector3<double>(1e-9, 1, 1e9).asDiagonal()) == 1);
  CHECK(condition<double, 3>(Vector3<double>(1e-200, 1e-200, 1e-200).asDiagonal()) == 1);
  CHECK(condition<double, 3>(Vector3<double>(-1, 1, 1).asDiagonal()) == 1);
  CHECK(condition<float, 3>(Matrix3<float>::Ones()) == std::numeric_limits<float>::infinity());
  // The products are 1.01, 1, 1, 1.01, and 1.01 - 1 is left of them; the third row adds 0.01.
  Matrix3<double> rounded = Matrix3<double>::Zero();
  rounded(0, 0) = rounded(0, 1) = rounded(1, 0) = rounded(2, 2) = 1;
  rounded(1, 1) = 1.01;
  // The rounding of 1.01 counts 403 / 3 times.
  CHECK(condition<double, 3>(rounded) == Catch::Approx(403.0 / 3).epsilon(403 * 0x1p-53));
}

TEST_CASE(
    "entries of 1 1 0, 1 1.01 0, 0 0 1 moved by 1e-9 move its determinant by 403e-9 at most",
    "[M11]")
{
  Matrix3<Rational> m = Matrix3<Rational>::Zero();
  m(0, 0) = m(0, 1) = m(1, 0) = m(2, 2) = 1;
  m(1, 1) = Rational(101, 100);
  const Rational tiny = Rational(1, 1000000000);
  const auto det = [](const Matrix3<Rational>& of)
  { return Rational(of.col(0).dot(cofactors<Rational>(of).col(0))); };
  Matrix3<Rational> moved = m;
  moved(0, 0) *= 1 - tiny;
  moved(1, 1) *= 1 - tiny;
  moved(2, 2) *= 1 - tiny;
  moved(0, 1) *= 1 + tiny;
  moved(1, 0) *= 1 + tiny;
  const Rational change = abs(Rational(det(moved) - det(m))) / det(m);
  CHECK(change <= Rational(403) * tiny);
  CHECK(change >= Rational(402) * tiny);
}

TEST_CASE("a wide double keeps 1 + 2^-90, and sizes far beyond those of double", "[M11]")
{
  const WideDouble one = 1.0, tiny = 0x1p-90;
  CHECK(static_cast<double>(one + tiny - one) == 0x1p-90);
  CHECK(static_cast<double>(tiny + one - one) == 0x1p-90);
  const WideDouble huge = 1e300;
  CHECK(static_cast<double>(huge * huge / huge) == 1e300);
  CHECK(static_cast<double>(abs(one - WideDouble(3.0))) == 2);
  CHECK((one <= one));
  CHECK((one <= one + tiny));
  CHECK_FALSE((one + tiny <= one));
  CHECK(static_cast<double>(WideDouble(5.0) + WideDouble(0.0)) == 5);
  CHECK(static_cast<double>(WideDouble(0.0) + WideDouble(5.0)) == 5);
  const WideDouble far_below(1.0, 0, -5000);
  CHECK(static_cast<double>(one + far_below) == 1);
  CHECK(static_cast<double>(far_below - one) == -1);
  CHECK(static_cast<double>(far_below / far_below) == 1);
}

TEST_CASE("sums, products and quotients of wide doubles are right to 2^-100", "[M11]")
{
  std::mt19937_64 random(1);
  const auto drawn = [&]
  {
    const auto fraction = [&] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
    const double high = std::ldexp(fraction(), static_cast<int>(random() % 80) - 40);
    return WideDouble(high, fraction() * high * 0x1p-53);
  };
  const auto exact_of = [](const WideDouble& x)
  { return Rational(std::ldexp(x.high, x.exponent)) + Rational(std::ldexp(x.low, x.exponent)); };
  const Rational bound(0x1p-100);
  for (int i = 0; i < 2000; ++i)
  {
    const WideDouble a = drawn(), b = drawn();
    const Rational x = exact_of(a), y = exact_of(b);
    CHECK(abs(Rational(exact_of(a + b) - (x + y))) <= bound * (abs(x) + abs(y)));
    CHECK(abs(Rational(exact_of(a - b) - (x - y))) <= bound * (abs(x) + abs(y)));
    CHECK(abs(Rational(exact_of(a * b) - x * y)) <= bound * abs(Rational(x * y)));
    CHECK(abs(Rational(exact_of(a / b) - x / y)) <= bound * abs(Rational(x / y)));
  }
}

TEMPLATE_TEST_CASE(
    "Scale(s) has the inverse Scale(1/s) for every power of two whose inverse fits", "[case:A4]",
    float, double)
{
  using Limits = std::numeric_limits<TestType>;
  for (int exponent = 1 - Limits::max_exponent; exponent < Limits::max_exponent; ++exponent)
  {
    const TestType s = std::ldexp(TestType(1), exponent);
    const Matrix3<TestType> m = Matrix3<TestType>::Identity() * s;
    INFO(exponent);
    REQUIRE(inverse<TestType, 3>(m).has_value());
    CHECK(*inverse<TestType, 3>(m) == Matrix3<TestType>(Matrix3<TestType>::Identity() / s));
  }
}

TEST_CASE("Scale(0.1) and Scale(1e-4) times their inverses are one within 1e-6", "[case:A4]")
{
  for (const float s : {0.1f, 1e-4f})
  {
    const Matrix3<float> m = Matrix3<float>::Identity() * s;
    const Matrix3<float> left = m * *inverse<float, 3>(m) - Matrix3<float>::Identity();
    CHECK(left.cwiseAbs().maxCoeff() <= 1e-6f);
    const Matrix3<float> published = m * inverse_as_published<float>(m);
    CHECK(published(0, 0) == s);
  }
}

TEMPLATE_TEST_CASE(
    "1 to 9, in rows, is singular, times every power of two, and so is what is not finite", "[M11]",
    float, double)
{
  using Limits = std::numeric_limits<TestType>;
  const Matrix3<TestType> m = rows<TestType>({1, 2, 3, 4, 5, 6, 7, 8, 9});
  for (int exponent = Limits::min_exponent - Limits::digits; exponent < Limits::max_exponent - 3;
       ++exponent)
  {
    CHECK_FALSE(inverse<TestType, 3>(m * std::ldexp(TestType(1), exponent)).has_value());
  }
  CHECK(determinant<TestType, 3>(m) == 0);
  for (const TestType bad : {Limits::infinity(), Limits::quiet_NaN()})
  {
    Matrix3<TestType> broken = Matrix3<TestType>::Identity();
    broken(1, 2) = bad;
    CHECK_FALSE(inverse<TestType, 3>(broken).has_value());
    CHECK_FALSE(std::isfinite(determinant<TestType, 3>(broken)));
  }
  CHECK_FALSE(inverse<TestType, 3>(Matrix3<TestType>::Zero()).has_value());
  CHECK_FALSE(inverse<TestType, 4>(Matrix4<TestType>::Ones()).has_value());
}

TEST_CASE("a cofactor that underflows to few digits, over a small determinant, is a full number")
{
  // Rows (s t 0), (0 s t), (0 0 s) have the inverse 1/s, -t/s² and t²/s³; t² has 12 digits left.
  // What stands in place of the zeros is too small to change a digit.
  const double s = 0x1p-66, t = (1 + 0x1p-20) * 0x1p-531, z = 0x1p-1074;
  const Matrix3<double> m = rows<double>({s, t, z, z, s, t, z, z, s});
  const Matrix3<double> back = inverse<double, 3>(m).value();
  CHECK(back(0, 2) == (1 + 0x1p-19 + 0x1p-40) * 0x1p-864);
  CHECK(back(0, 1) == -t / s / s);
  CHECK(back(1, 1) == 1 / s);
}

TEMPLATE_TEST_CASE(
    "1 1 0, 1 1+d 0, 0 0 1 is singular to rounding for d of 1 or 2 ulps, and not for 3", "[M11]",
    float, double)
{
  // The determinant is d; half an ulp in each entry moves it by half an ulp times 4 + 3d.
  const TestType ulp_of_one = std::numeric_limits<TestType>::epsilon();
  Matrix3<TestType> m = rows<TestType>({1, 1, 0, 1, 1, 0, 0, 0, 1});
  for (const int ulps : {0, 1, 2, 3, 4, 100})
  {
    m(1, 1) = TestType(1) + static_cast<TestType>(ulps) * ulp_of_one;
    CHECK(inverse<TestType, 3>(m).has_value() == (ulps > 2));
  }
}

// [solve]
TEST_CASE(
    "x + 2y + z = 8, 2x - y + z = 3 and x + y - z = 0 meet in (1, 2, 3), by Eigen's LU and by "
    "inverse",
    "[M11]")
{
  Matrix3<double> m;
  m << 1, 2, 1, 2, -1, 1, 1, 1, -1;
  const Vector3<double> right(8, 3, 0), answer(1, 2, 3);
  // Each way has about ten roundings of numbers up to 8.
  CHECK((partial_lu_inverse<double, 3>(m) * right - answer).cwiseAbs().maxCoeff() <= 1e-14);
  CHECK((*inverse<double, 3>(m) * right - answer).cwiseAbs().maxCoeff() <= 1e-14);
}
// [solve]

// [cases]
TEST_CASE("each way to invert holds or fails as the table says", "[case:A4]")
{
  const auto all_but = [&](const std::vector<std::string>& fail)
  {
    std::vector<std::string> names;
    for (const std::string& name : names_of(inverse_methods<float>()))
    {
      if (!is_among(fail, name))
      {
        names.push_back(name);
      }
    }
    return names;
  };
  check_verdicts(
      inverse_verdicts<float>(), names_of(inverse_methods<float>()),
      {{"A4", all_but({"as published"})},
       {"Scale(1e-4)", all_but({"as published", "Eigen with check"})},
       {"Scale(1e-20)", {"PartialPivLU", "FullPivLU", "recommended"}},
       {"Scale(1e+20)", {"PartialPivLU", "FullPivLU", "recommended"}},
       {"diag(1e-30, 1, 1e30)", all_but({"FullPivLU"})},
       {"0.0034 and 2.6e-23 beside it", {"PartialPivLU", "FullPivLU", "recommended"}},
       {"rows in km, m, mm", all_but({})},
       {"Hilbert", all_but({"as published"})},
       {"all nearly 1", {"PartialPivLU", "FullPivLU", "recommended"}},
       {"1 2 3, 4 5 6, 7 8 9", {"Eigen with check", "FullPivLU", "recommended"}},
       {"the same / 10", {"Eigen with check", "FullPivLU", "recommended"}},
       {"the same with 9.01", all_but({})}});
  check_verdicts(
      inverse_verdicts<double>(), names_of(inverse_methods<double>()),
      {{"Scale(0.1), double", all_but({"as published"})},
       {"Scale(1e-4), double", all_but({"as published", "Eigen with check"})},
       {"Scale(1e-160), double", {"PartialPivLU", "FullPivLU", "recommended"}},
       {"Scale(1e+160), double", {"PartialPivLU", "FullPivLU", "recommended"}},
       {"diag(1e-30, 1, 1e30), double", all_but({"FullPivLU"})},
       {"1e-20 and 2.3e-308 beside it, double", {"PartialPivLU", "FullPivLU", "recommended"}},
       {"rows in km, m, mm, double", all_but({})},
       {"Hilbert, double", all_but({"as published"})},
       {"all nearly 1, double", {"PartialPivLU", "FullPivLU", "recommended"}},
       {"1 2 3, 4 5 6, 7 8 9, double", {"Eigen with check", "FullPivLU", "recommended"}},
       {"the same / 10, double", {"Eigen with check", "FullPivLU", "recommended"}},
       {"the same with 9.01, double", all_but({})}});
}
// [cases]
