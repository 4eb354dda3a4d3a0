#pragma once

/// \file
/// \brief Several packs computed with as if they were one number.

#include "common/simd/pack.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi" // as in pack.hpp
#endif

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

// [several]
/// `Size` packs side by side, computed with as if they were one number.
template <class Number, int Size>
struct Several
{
  Number lane[Size]; ///< the packs

  /// What a comparison gives: a mask of each pack.
  struct Mask
  {
    typename Number::Mask lane[Size]; ///< the masks

    friend Mask operator&(const Mask& a, const Mask& b)
    {
      Mask both;
      for (int i = 0; i < Size; ++i)
      {
        both.lane[i] = a.lane[i] & b.lane[i];
      }
      return both;
    }
    friend Mask operator|(const Mask& a, const Mask& b)
    {
      Mask either;
      for (int i = 0; i < Size; ++i)
      {
        either.lane[i] = a.lane[i] | b.lane[i];
      }
      return either;
    }
  };

  Several() = default;
  Several(const Number& same)
  {
    for (Number& number : lane)
    {
      number = same;
    }
  }
  const Number& operator[](int i) const { return lane[i]; } ///< the i-th pack, i < Size

  /// What a function gives of every lane of a and b.
  template <class Function>
  static Several of(const Several& a, const Several& b, const Function& function)
  {
    Several result;
    for (int i = 0; i < Size; ++i)
    {
      result.lane[i] = function(a.lane[i], b.lane[i]);
    }
    return result;
  }

  /// What a comparison gives of every lane of a and b.
  template <class Function>
  static Mask mask_of(const Several& a, const Several& b, const Function& function)
  {
    Mask result;
    for (int i = 0; i < Size; ++i)
    {
      result.lane[i] = function(a.lane[i], b.lane[i]);
    }
    return result;
  }

  friend Several operator+(const Several& a, const Several& b)
  {
    return of(a, b, [](const Number& x, const Number& y) { return x + y; });
  }
  friend Several operator-(const Several& a, const Several& b)
  {
    return of(a, b, [](const Number& x, const Number& y) { return x - y; });
  }
  friend Several operator*(const Several& a, const Several& b)
  {
    return of(a, b, [](const Number& x, const Number& y) { return x * y; });
  }
  friend Several operator/(const Several& a, const Several& b)
  {
    return of(a, b, [](const Number& x, const Number& y) { return x / y; });
  }
  friend Several operator-(const Several& a) { return Several(Number(0)) - a; }
  friend Several max(const Several& a, const Several& b)
  {
    return of(a, b, [](const Number& x, const Number& y) { return max(x, y); });
  }
  friend Several min(const Several& a, const Several& b)
  {
    return of(a, b, [](const Number& x, const Number& y) { return min(x, y); });
  }
  friend Several abs(const Several& a)
  {
    return of(a, a, [](const Number& x, const Number&) { return abs(x); });
  }
  friend Mask operator<(const Several& a, const Several& b)
  {
    return mask_of(a, b, [](const Number& x, const Number& y) { return x < y; });
  }
  friend Mask operator<=(const Several& a, const Several& b)
  {
    return mask_of(a, b, [](const Number& x, const Number& y) { return x <= y; });
  }
};
// [several]

/// The lanes of `yes` where the mask is set, those of `no` elsewhere.
template <class Number, int Size>
Several<Number, Size> select(
    const typename Several<Number, Size>::Mask& mask, const Several<Number, Size>& yes,
    const Several<Number, Size>& no)
{
  Several<Number, Size> result;
  for (int i = 0; i < Size; ++i)
  {
    result.lane[i] = select(mask.lane[i], yes.lane[i], no.lane[i]);
  }
  return result;
}

/// Of every pair all of `yes` where the mask is set, all of `no` elsewhere.
template <class Number, int Size>
Several<Number, Size> select(
    const typename Number::Mask& mask, const Several<Number, Size>& yes,
    const Several<Number, Size>& no)
{
  Several<Number, Size> result;
  for (int i = 0; i < Size; ++i)
  {
    result.lane[i] = select(mask, yes.lane[i], no.lane[i]);
  }
  return result;
}

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
