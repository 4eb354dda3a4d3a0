#pragma once

/// \file
/// \brief Numbers side by side in plain C++, in the place of the compilers' own vector types.

#include "common/simd/number.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// Numbers side by side, each computed with by itself.
template <class Number, std::size_t Width>
struct PlainVector
{
  /// What a comparison gives: −1, all bits set, or 0.
  using Bits =
      PlainVector<std::conditional_t<sizeof(Number) == 8, std::int64_t, std::int32_t>, Width>;

  Number at[Width]; ///< the numbers

  template <std::integral Whole>
  Number& operator[](Whole i) ///< the i-th
  {
    return at[static_cast<std::size_t>(i)];
  }
  template <std::integral Whole>
  const Number& operator[](Whole i) const ///< the i-th
  {
    return at[static_cast<std::size_t>(i)];
  }

  /// What a function gives of each of two numbers.
  template <class Result = PlainVector, class Function>
  static Result of(const PlainVector& a, const PlainVector& b, const Function& function)
  {
    Result result{};
    for (std::size_t i = 0; i < Width; ++i)
    {
      result.at[i] = function(a.at[i], b.at[i]);
    }
    return result;
  }

  friend PlainVector operator+(const PlainVector& a, const PlainVector& b)
  {
    return of(a, b, [](Number x, Number y) { return x + y; });
  }
  friend PlainVector operator-(const PlainVector& a, const PlainVector& b)
  {
    return of(a, b, [](Number x, Number y) { return x - y; });
  }
  friend PlainVector operator*(const PlainVector& a, const PlainVector& b)
  {
    return of(a, b, [](Number x, Number y) { return x * y; });
  }
  friend PlainVector operator/(const PlainVector& a, const PlainVector& b)
  {
    return of(a, b, [](Number x, Number y) { return x / y; });
  }
  friend PlainVector operator-(const PlainVector& a)
  {
    return of(a, a, [](Number x, Number) { return -x; });
  }
  friend PlainVector operator&(const PlainVector& a, const PlainVector& b)
  {
    return of(a, b, [](Number x, Number y) { return x & y; });
  }
  friend PlainVector operator|(const PlainVector& a, const PlainVector& b)
  {
    return of(a, b, [](Number x, Number y) { return x | y; });
  }
  friend PlainVector operator~(const PlainVector& a)
  {
    return of(a, a, [](Number x, Number) { return ~x; });
  }
  friend Bits operator<(const PlainVector& a, const PlainVector& b)
  {
    return of<Bits>(a, b, [](Number x, Number y) { return x < y ? -1 : 0; });
  }
  friend Bits operator<=(const PlainVector& a, const PlainVector& b)
  {
    return of<Bits>(a, b, [](Number x, Number y) { return x <= y ? -1 : 0; });
  }
  friend Bits operator>(const PlainVector& a, const PlainVector& b) { return b < a; }
  friend Bits operator>=(const PlainVector& a, const PlainVector& b) { return b <= a; }
  friend Bits operator==(const PlainVector& a, const PlainVector& b)
  {
    return of<Bits>(a, b, [](Number x, Number y) { return x == y ? -1 : 0; });
  }
};

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
