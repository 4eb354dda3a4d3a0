#include "tools/exact/reference.hpp"

#include <cmath>
#include <ostream>

namespace cookbook
{

Reference::Reference()
{
  mpfr_custom_init(digits_, digits);
  mpfr_custom_init_set(value_, MPFR_ZERO_KIND, 0, digits, digits_);
}

Reference::Reference(double number) : Reference()
{
  mpfr_set_d(value_, number, MPFR_RNDN);
}

Reference::Reference(const Rational& fraction) : Reference()
{
  mpfr_set_q(value_, fraction.value(), MPFR_RNDN);
}

Reference::Reference(const Reference& other) : Reference()
{
  mpfr_set(value_, other.value_, MPFR_RNDN);
}

Reference& Reference::operator=(const Reference& other)
{
  mpfr_set(value_, other.value_, MPFR_RNDN);
  return *this;
}

/// What one of MPFR's functions makes of numbers, rounded once.
template <class Function, class... Numbers>
Reference Reference::of(Function function, const Numbers&... numbers)
{
  Reference result;
  function(result.value_, numbers.value_..., MPFR_RNDN);
  return result;
}

Reference operator+(const Reference& a, const Reference& b)
{
  return Reference::of(mpfr_add, a, b);
}

Reference operator-(const Reference& a, const Reference& b)
{
  return Reference::of(mpfr_sub, a, b);
}

Reference operator*(const Reference& a, const Reference& b)
{
  return Reference::of(mpfr_mul, a, b);
}

Reference operator/(const Reference& a, const Reference& b)
{
  return Reference::of(mpfr_div, a, b);
}

Reference operator-(const Reference& a)
{
  return Reference::of(mpfr_neg, a);
}

std::partial_ordering operator<=>(const Reference& a, const Reference& b)
{
  return mpfr_unordered_p(a.value_, b.value_) != 0 ? std::partial_ordering::unordered
                                                   : mpfr_cmp(a.value_, b.value_) <=> 0;
}

Reference abs(const Reference& a)
{
  return Reference::of(mpfr_abs, a);
}

Reference sqrt(const Reference& a)
{
  return Reference::of(mpfr_sqrt, a);
}

Reference sin(const Reference& angle)
{
  return Reference::of(mpfr_sin, angle);
}

Reference cos(const Reference& angle)
{
  return Reference::of(mpfr_cos, angle);
}

Reference atan2(const Reference& y, const Reference& x)
{
  return Reference::of(mpfr_atan2, y, x);
}

Reference exp(const Reference& a)
{
  return Reference::of(mpfr_exp, a);
}

Reference ldexp(const Reference& a, int exponent)
{
  Reference result;
  mpfr_mul_2si(result.value_, a.value_, exponent, MPFR_RNDN);
  return result;
}

int ilogb(const Reference& a)
{
  return mpfr_zero_p(a.value_) != 0 ? FP_ILOGB0 : static_cast<int>(mpfr_get_exp(a.value_)) - 1;
}

std::ostream& operator<<(std::ostream& out, const Reference& a)
{
  return out << static_cast<double>(a);
}

} // namespace cookbook
