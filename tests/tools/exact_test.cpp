/// \file
/// What holds for fractions and for numbers of a hundred digits.

#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

using namespace cookbook;

namespace
{

template <class Number>
std::string written(const Number& number)
{
  std::ostringstream out;
  out << number;
  return out.str();
}

} // namespace

TEST_CASE("an exact 0.1f is not a tenth", "[exact]")
{
  CHECK(exact<Rational>(0.1f) == Rational(13421773, 134217728));
  CHECK(exact<Rational>(Vector3<double>(0.5, 0.25, 3)).y() == Rational(1, 4));
}

TEST_CASE("fractions are added, multiplied and compared as at school", "[exact]")
{
  const Rational third(1, 3), half(2, 4);
  CHECK(third + half == Rational(5, 6));
  CHECK(third - half == Rational(1, -6));
  CHECK(third * half == Rational(1, 6));
  CHECK(third / half == Rational(2, 3));
  CHECK(-third < third);
  CHECK(abs(-half) == half);
  CHECK((-half).sign() == -1);
  CHECK(written(half) == "1/2");
  CHECK(written(2 * half) == "1");
}

TEST_CASE("a fraction of what is not finite, or by zero, is refused", "[exact]")
{
  CHECK_THROWS_AS(Rational(std::numeric_limits<double>::infinity()), std::domain_error);
  CHECK_THROWS_AS(Rational(std::nan("")), std::domain_error);
  CHECK_THROWS_AS(Rational(1, 0), std::domain_error);
  CHECK_THROWS_AS(Rational(1) / Rational(0), std::domain_error);
}

TEMPLATE_TEST_CASE("a fraction becomes the nearest number", "[exact]", float, double, long double)
{
  using Limits = std::numeric_limits<TestType>;
  const TestType third = TestType(1) / 3;
  CHECK(static_cast<TestType>(Rational(1, 3)) == third);
  CHECK(static_cast<TestType>(Rational(-1, 3)) == -third);
  const auto as_number = [](const Rational& x) { return static_cast<TestType>(x); };
  const double ulp = std::ldexp(1.0, 1 - std::min(Limits::digits, 53));
  const Rational one_more = Rational(1) + exact<Rational>(ulp);
  CHECK(as_number(one_more) == TestType(1) + static_cast<TestType>(ulp));
  if (Limits::digits <= 53)
  {
    const Rational tie = Rational(1) + exact<Rational>(ulp) / 2, least(1, 1L << 62);
    CHECK(as_number(tie) == 1);         // the even one
    CHECK(as_number(tie + least) > 1);  // a little more
    CHECK(as_number(tie - least) == 1); // a little less
  }
}

TEST_CASE("the least float is rounded to and from, its half to zero", "[exact]")
{
  const double least = std::numeric_limits<double>::denorm_min();
  const Rational exactly(least);
  CHECK(static_cast<double>(exactly) == least);
  CHECK(static_cast<double>(exactly * Rational(3, 2)) == 2 * least);
  CHECK(static_cast<double>(exactly / 2) == 0);
  CHECK(static_cast<double>(exactly * Rational(51, 100)) == least);
}

TEST_CASE("a hundred digits tell what doubles cannot", "[exact]")
{
  const Reference tiny = ldexp(Reference(1), -300);
  CHECK(Reference(1) + tiny > 1);
  CHECK(static_cast<double>(Reference(1) + tiny - 1) == std::ldexp(1.0, -300));
  const Reference two = sqrt(Reference(2)) * sqrt(Reference(2));
  CHECK(abs(two - 2) < Reference(1e-100));
  CHECK(abs(Reference(Rational(1, 3)) * 3 - 1) < Reference(1e-100));
  const Reference angle = 0.7;
  CHECK(abs(sin(angle) * sin(angle) + cos(angle) * cos(angle) - 1) < Reference(1e-100));
  CHECK(abs(atan2(sin(angle), cos(angle)) - angle) < Reference(1e-100));
}

TEST_CASE("a hundred digits know their own limits", "[exact]")
{
  using Limits = std::numeric_limits<Reference>;
  CHECK(Reference(1) + Limits::epsilon() > 1);
  CHECK(Reference(1) + Limits::epsilon() / 2 == 1);
  CHECK(Limits::min() > 0);
  CHECK(Limits::max() < Limits::infinity());
  CHECK(Limits::min() * Limits::max() == 1);
  CHECK_FALSE(Limits::quiet_NaN() == Limits::quiet_NaN());
  CHECK_FALSE(Limits::quiet_NaN() < 1);
  CHECK(Reference(1) / 0 == Limits::infinity());
  CHECK(ilogb(Reference(1)) == 0);
  CHECK(ilogb(Reference(0.75)) == -1);
  CHECK(ilogb(Reference(0)) == FP_ILOGB0);
}

TEST_CASE("a copied number owes nothing to its original", "[exact]")
{
  Reference a = 2, b = a;
  a += 1;
  CHECK(b == 2);
  const Reference& itself = b;
  b = itself;
  CHECK(b == 2);
  Rational c = 2, d = c;
  c += 1;
  CHECK(d == 2);
  d = std::move(c);
  CHECK(d == 3);
}
