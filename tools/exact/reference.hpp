#pragma once

/// \file
/// \brief Numbers of a hundred digits: the truth of formulas with a square root or an angle.

#include "tools/exact/rational.hpp"

#include <mpfr.h>

#include <compare>
#include <concepts>
#include <iosfwd>
#include <limits>

namespace cookbook
{

/// A float of 100 decimal digits, for the truth of formulas that need a square root.
///
/// Each operation, root and angle is rounded once. As with double, what has no answer is NaN.
class Reference
{
public:
  static constexpr int digits = 384; ///< of two; 333 make a hundred of ten

  Reference(); ///< zero

  /// A whole number.
  template <std::signed_integral Number>
  Reference(Number whole) : Reference()
  {
    mpfr_set_si(value_, static_cast<long>(whole), MPFR_RNDN);
  }

  Reference(double number); ///< the exact value of a float or double

  /// The nearest of a hundred digits.
  explicit Reference(const Rational& fraction);

  Reference(const Reference& other);
  Reference& operator=(const Reference& other);
  ~Reference() = default;

  /// The nearest float, double or long double.
  explicit operator float() const { return mpfr_get_flt(value_, MPFR_RNDN); }
  explicit operator double() const { return mpfr_get_d(value_, MPFR_RNDN); }
  explicit operator long double() const { return mpfr_get_ld(value_, MPFR_RNDN); }

  Reference& operator+=(const Reference& other) { return *this = *this + other; }
  Reference& operator-=(const Reference& other) { return *this = *this - other; }
  Reference& operator*=(const Reference& other) { return *this = *this * other; }
  Reference& operator/=(const Reference& other) { return *this = *this / other; }

  friend Reference operator+(const Reference& a, const Reference& b);
  friend Reference operator-(const Reference& a, const Reference& b);
  friend Reference operator*(const Reference& a, const Reference& b);
  friend Reference operator/(const Reference& a, const Reference& b);
  friend Reference operator-(const Reference& a);
  friend bool operator==(const Reference& a, const Reference& b)
  {
    return mpfr_equal_p(a.value_, b.value_) != 0;
  }
  friend std::partial_ordering operator<=>(const Reference& a, const Reference& b);

  friend Reference abs(const Reference& a);
  friend Reference sqrt(const Reference& a);
  friend Reference sin(const Reference& angle);
  friend Reference cos(const Reference& angle);
  friend Reference atan2(const Reference& y, const Reference& x);
  friend Reference exp(const Reference& a);
  friend Reference ldexp(const Reference& a, int exponent);
  friend int ilogb(const Reference& a);

  /// Written with 17 digits.
  friend std::ostream& operator<<(std::ostream& out, const Reference& a);

private:
  template <class Function, class... Numbers>
  static Reference of(Function function, const Numbers&... numbers);

  mp_limb_t digits_[digits / GMP_NUMB_BITS]; // in place, for there are many numbers
  mpfr_t value_;
};

} // namespace cookbook

/// What formulas ask of a number: its roundings, and the range in which they may square it.
template <>
struct std::numeric_limits<cookbook::Reference>
{
  static constexpr bool is_specialized = true;
  static constexpr bool is_signed = true;
  static constexpr bool is_integer = false;
  static constexpr bool is_exact = false;
  static constexpr bool has_infinity = true;
  static constexpr bool has_quiet_NaN = true;
  static constexpr int radix = 2;
  static constexpr int digits = cookbook::Reference::digits;
  static constexpr int digits10 = 100;
  static constexpr int min_exponent = -(1 << 29);
  static constexpr int max_exponent = 1 << 29;

  static cookbook::Reference epsilon() { return ldexp(cookbook::Reference(1), 1 - digits); }
  static cookbook::Reference min() { return ldexp(cookbook::Reference(1), min_exponent); }
  static cookbook::Reference max() { return ldexp(cookbook::Reference(1), max_exponent); }
  static cookbook::Reference lowest() { return -max(); }
  static cookbook::Reference infinity() { return std::numeric_limits<double>::infinity(); }
  static cookbook::Reference quiet_NaN() { return std::numeric_limits<double>::quiet_NaN(); }
};

/// Numbers of a hundred digits in Eigen's matrices.
template <>
struct Eigen::NumTraits<cookbook::Reference> : cookbook::SlowNumTraits<cookbook::Reference>
{
};
