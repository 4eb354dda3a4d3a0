#include "tools/exact/rational.hpp"
#include "tools/exact/reference.hpp"

#include <cmath>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <utility>

namespace cookbook
{

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
  return static_cast<float>(Reference(*this));
}

Rational::operator double() const
{
  return static_cast<double>(Reference(*this));
}

Rational::operator long double() const
{
  return static_cast<long double>(Reference(*this));
}

/// What one of GMP's functions makes of two fractions.
template <class Function>
Rational Rational::of(Function function, const Rational& a, const Rational& b)
{
  Rational result;
  function(result.value_, a.value_, b.value_);
  return result;
}

Rational operator+(const Rational& a, const Rational& b)
{
  return Rational::of(mpq_add, a, b);
}

Rational operator-(const Rational& a, const Rational& b)
{
  return Rational::of(mpq_sub, a, b);
}

Rational operator*(const Rational& a, const Rational& b)
{
  return Rational::of(mpq_mul, a, b);
}

Rational operator/(const Rational& a, const Rational& b)
{
  if (b.sign() == 0)
  {
    throw std::domain_error("a fraction divided by zero");
  }
  return Rational::of(mpq_div, a, b);
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
