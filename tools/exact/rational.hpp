#pragma once

/// \file
/// \brief Exact numbers: the truth that formulas without a square root are measured against.

#include "common/math/vector.hpp"

#include <gmp.h>

#include <compare>
#include <concepts>
#include <iosfwd>

namespace cookbook
{

/// A fraction of whole numbers of any size: +, -, * and / are exact, there is no square root.
///
/// What is not finite is no fraction, nor is what is divided by zero: std::domain_error.
class Rational
{
public:
  Rational(); ///< zero

  /// A whole number.
  template <std::signed_integral Number>
  Rational(Number whole) : Rational(static_cast<long>(whole), 1)
  {
  }

  Rational(double number);                    ///< the exact value of a float or double
  Rational(long numerator, long denominator); ///< a fraction, in any terms

  Rational(const Rational& other);
  Rational(Rational&& other) noexcept;
  Rational& operator=(const Rational& other);
  Rational& operator=(Rational&& other) noexcept;
  ~Rational();

  /// The nearest float, double or long double.
  explicit operator float() const;
  explicit operator double() const;
  explicit operator long double() const;

  Rational& operator+=(const Rational& other) { return *this = *this + other; }
  Rational& operator-=(const Rational& other) { return *this = *this - other; }
  Rational& operator*=(const Rational& other) { return *this = *this * other; }
  Rational& operator/=(const Rational& other) { return *this = *this / other; }

  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(const Rational& a, const Rational& b);
  friend Rational operator-(Rational a)
  {
    mpq_neg(a.value_, a.value_);
    return a;
  }
  friend Rational abs(Rational a)
  {
    mpq_abs(a.value_, a.value_);
    return a;
  }
  /// -1, 0 or 1.
  int sign() const { return mpq_sgn(value_); }

  friend bool operator==(const Rational& a, const Rational& b)
  {
    return mpq_equal(a.value_, b.value_) != 0;
  }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b)
  {
    return mpq_cmp(a.value_, b.value_) <=> 0;
  }

  /// Written as 3/4, or 3.
  friend std::ostream& operator<<(std::ostream& out, const Rational& a);

  /// The fraction itself, in lowest terms.
  mpq_srcptr value() const { return value_; }

private:
  template <class Function>
  static Rational of(Function function, const Rational& a, const Rational& b);

  mpq_t value_;
};

/// What Eigen asks of a number with a sign that takes long to compute with.
template <class Number>
struct SlowNumTraits : Eigen::GenericNumTraits<Number>
{
  enum
  {
    IsSigned = 1,
    ReadCost = 10,
    AddCost = 100,
    MulCost = 100
  };
};

} // namespace cookbook

/// Fractions in Eigen's matrices; they have no digits to count.
template <>
struct Eigen::NumTraits<cookbook::Rational> : cookbook::SlowNumTraits<cookbook::Rational>
{
  static int digits10() { return 0; }
};
