#include "common/exact/rational.hpp"

#include <mpfr.h>

#include <cmath>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <utility>

namespace cookbook
{
namespace
{

/// A fraction to 200 digits of two, which then are rounded to those of a float or double.
struct Rounded
{
  explicit Rounded(mpq_srcptr fraction)
  {
    mpfr_init2(value, 200);
    mpfr_set_q(value, fraction, MPFR_RNDN);
  }
  Rounded(const Rounded&) = delete;
  Rounded& operator=(const Rounded&) = delete;
  ~Rounded() { mpfr_clear(value); }

  mpfr_t value;
};

} // namespace

Rational::Rational()
{
  mpq_init(value_);
}

Rational::Rational(double number)
{
  if (!std::isfinite(number))
  {
    throw std::domain_error("what is not finite is no fraction");
  }
  mpq_init(value_);
  mpq_set_d(value_, number);
}

Rational::Rational(long numerator, long denominator)
{
  if (denominator == 0)
  {
    throw std::domain_error("a fraction with the denominator zero");
  }
  mpq_init(value_);
  mpz_set_si(mpq_numref(value_), numerator);
  mpz_set_si(mpq_denref(value_), denominator);
  mpq_canonicalize(value_);
}

Rational::Rational(const Rational& other)
{
  mpq_init(value_);
  mpq_set(value_, other.value_);
}

Rational::Rational(Rational&& other) noexcept
{
  mpq_init(value_);
  mpq_swap(value_, other.value_);
}

Rational& Rational::operator=(const Rational& other)
{
  mpq_set(value_, other.value_);
  return *this;
}

Rational& Rational::operator=(Rational&& other) noexcept
{
  mpq_swap(value_, other.value_);
  return *this;
}

Rational::~Rational()
{
  mpq_clear(value_);
}

Rational::operator float() const
{
  return mpfr_get_flt(Rounded(value_).value, MPFR_RNDN);
}

Rational::operator double() const
{
  return mpfr_get_d(Rounded(value_).value, MPFR_RNDN);
}

Rational::operator long double() const
{
  return mpfr_get_ld(Rounded(value_).value, MPFR_RNDN);
}

Rational operator+(const Rational& a, const Rational& b)
{
  Rational sum;
  mpq_add(sum.value_, a.value_, b.value_);
  return sum;
}

Rational operator-(const Rational& a, const Rational& b)
{
  Rational difference;
  mpq_sub(difference.value_, a.value_, b.value_);
  return difference;
}

Rational operator*(const Rational& a, const Rational& b)
{
  Rational product;
  mpq_mul(product.value_, a.value_, b.value_);
  return product;
}

Rational operator/(const Rational& a, const Rational& b)
{
  if (mpq_sgn(b.value_) == 0)
  {
    throw std::domain_error("a fraction divided by zero");
  }
  Rational quotient;
  mpq_div(quotient.value_, a.value_, b.value_);
  return quotient;
}

std::ostream& operator<<(std::ostream& out, const Rational& a)
{
  const auto release = [](char* text)
  {
    void (*free)(void*, std::size_t) = nullptr;
    mp_get_memory_functions(nullptr, nullptr, &free);
    free(text, std::char_traits<char>::length(text) + 1);
  };
  const std::unique_ptr<char, decltype(release)> text(mpq_get_str(nullptr, 10, a.value_), release);
  return out << text.get();
}

} // namespace cookbook
