#pragma once

/// \file
/// \brief Groups: three or four numbers that belong to one pair, computed with at once.

#include "common/simd/number.hpp"

#include <cmath>
#include <utility>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

// [group]
/// `Size` numbers of a pair side by side, computed with as if they were one; of packs, with a pair
/// in every lane, as many packs.
template <class Number, int Size>
struct Group
{
  Number at[Size]; ///< the numbers

  /// What a comparison gives.
  struct Mask
  {
    MaskOf<Number> at[Size]; ///< of each number

    friend Mask operator&(const Mask& a, const Mask& b)
    {
      Mask both;
      for (int i = 0; i < Size; ++i)
      {
        both.at[i] = a.at[i] & b.at[i];
      }
      return both;
    }
    friend Mask operator|(const Mask& a, const Mask& b)
    {
      Mask either;
      for (int i = 0; i < Size; ++i)
      {
        either.at[i] = a.at[i] | b.at[i];
      }
      return either;
    }
  };

  Group() = default;
  explicit Group(const Number& same) ///< the same number everywhere
  {
    for (Number& number : at)
    {
      number = same;
    }
  }
  const Number& operator[](int i) const { return at[i]; } ///< the i-th number, i < Size

  /// What a function gives of each number of a and of b.
  template <class Function>
  static Group of(const Group& a, const Group& b, const Function& function)
  {
    Group result;
    for (int i = 0; i < Size; ++i)
    {
      result.at[i] = function(a.at[i], b.at[i]);
    }
    return result;
  }

  /// What a comparison gives of each number of a and of b.
  template <class Function>
  static Mask mask_of(const Group& a, const Group& b, const Function& function)
  {
    Mask result;
    for (int i = 0; i < Size; ++i)
    {
      result.at[i] = function(a.at[i], b.at[i]);
    }
    return result;
  }

  friend Group operator+(const Group& a, const Group& b)
  {
    return of(a, b, [](const Number& x, const Number& y) { return x + y; });
  }
  friend Group operator-(const Group& a, const Group& b)
  {
    return of(a, b, [](const Number& x, const Number& y) { return x - y; });
  }
  friend Group operator*(const Group& a, const Group& b)
  {
    return of(a, b, [](const Number& x, const Number& y) { return x * y; });
  }
  friend Group operator/(const Group& a, const Group& b)
  {
    return of(a, b, [](const Number& x, const Number& y) { return x / y; });
  }
  friend Group max(const Group& a, const Group& b)
  {
    return of(a, b, [](const Number& x, const Number& y) { return larger(x, y); });
  }
  friend Group min(const Group& a, const Group& b)
  {
    return of(a, b, [](const Number& x, const Number& y) { return smaller(x, y); });
  }
  friend Group abs(const Group& a)
  {
    using std::abs;
    return of(a, a, [](const Number& x, const Number&) { return abs(x); });
  }
  friend Mask operator<(const Group& a, const Group& b)
  {
    return mask_of(a, b, [](const Number& x, const Number& y) { return x < y; });
  }
  friend Mask operator<=(const Group& a, const Group& b)
  {
    return mask_of(a, b, [](const Number& x, const Number& y) { return x <= y; });
  }
};
// [group]

/// The numbers of `yes` where the mask is set, those of `no` elsewhere.
template <class Number, int Size>
Group<Number, Size> select(
    const typename Group<Number, Size>::Mask& mask, const Group<Number, Size>& yes,
    const Group<Number, Size>& no)
{
  Group<Number, Size> result;
  for (int i = 0; i < Size; ++i)
  {
    result.at[i] = select(mask.at[i], yes.at[i], no.at[i]);
  }
  return result;
}

/// Of every pair all of `yes` where the mask is set, all of `no` elsewhere.
template <class Number, int Size>
Group<Number, Size>
select(const MaskOf<Number>& mask, const Group<Number, Size>& yes, const Group<Number, Size>& no)
{
  Group<Number, Size> result;
  for (int i = 0; i < Size; ++i)
  {
    result.at[i] = select(mask, yes.at[i], no.at[i]);
  }
  return result;
}

/// Three given numbers.
template <class Number>
Group<Number, 3> group(const Number& x, const Number& y, const Number& z)
{
  Group<Number, 3> result;
  result.at[0] = x;
  result.at[1] = y;
  result.at[2] = z;
  return result;
}

/// The three numbers moved one on: y, z, x.
template <class Number>
Group<Number, 3> turned_once(const Group<Number, 3>& v)
{
  return group(v[1], v[2], v[0]);
}

/// The three numbers moved two on: z, x, y.
template <class Number>
Group<Number, 3> turned_twice(const Group<Number, 3>& v)
{
  return group(v[2], v[0], v[1]);
}

/// Rows made columns.
template <class Number, int Size>
void transpose(Group<Number, Size> (&rows)[Size])
{
  using std::swap;
  for (int i = 0; i < Size; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      swap(rows[i].at[j], rows[j].at[i]);
    }
  }
}

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
