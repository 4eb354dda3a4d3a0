#include "common/exact/reference.hpp"

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

Reference operator+(const Reference& a, const Reference& b)
{
  Reference sum;
  mpfr_add(sum.value_, a.value_, b.value_, MPFR_RNDN);
  return sum;
}

Reference operator-(const Reference& a, const Reference& b)
{
  Reference difference;
  mpfr_sub(difference.value_, a.value_, b.value_, MPFR_RNDN);
  return difference;
}

Reference operator*(const Reference& a, const Reference& b)
{
  Reference product;
  mpfr_mul(product.value_, a.value_, b.value_, MPFR_RNDN);
  return product;
}

Reference operator/(const Reference& a, const Reference& b)
{
  Reference quotient;
  mpfr_div(quotient.value_, a.value_, b.value_, MPFR_RNDN);
  return quotient;
}

Reference operator-(Reference a)
{
  mpfr_neg(a.value_, a.value_, MPFR_RNDN);
  return a;
}

std::partial_ordering operator<=>(const Reference& a, const Reference& b)
{
  return mpfr_unordered_p(a.value_, b.value_) != 0 ? std::partial_ordering::unordered
                                                   : mpfr_cmp(a.value_, b.value_) <=> 0;
}

Reference abs(Reference a)
{
  mpfr_abs(a.value_, a.value_, MPFR_RNDN);
  return a;
}

Reference sqrt(Reference a)
{
  mpfr_sqrt(a.value_, a.value_, MPFR_RNDN);
  return a;
}

Reference sin(Reference angle)
{
  mpfr_sin(angle.value_, angle.value_, MPFR_RNDN);
  return angle;
}

Reference cos(Reference angle)
{
  mpfr_cos(angle.value_, angle.value_, MPFR_RNDN);
  return angle;
}

Reference atan2(Reference y, const Reference& x)
{
  mpfr_atan2(y.value_, y.value_, x.value_, MPFR_RNDN);
  return y;
}

Reference ldexp(Reference a, int exponent)
{
  mpfr_mul_2si(a.value_, a.value_, exponent, MPFR_RNDN);
  return a;
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
