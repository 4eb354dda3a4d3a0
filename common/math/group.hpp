#pragma once

/// \file
/// \brief Groups: three or four numbers that belong to one pair, computed with at once.

#include "common/math/pack.hpp"

#include <type_traits>
#include <utility>

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

// [group]
/// Three or four numbers of a pair side by side: for plain numbers the lanes of one register, of
/// which the fourth may be idle; for packs, with a pair in every lane, as many packs.
template <class Real, int Size>
using Group =
    std::conditional_t<std::is_floating_point_v<Real>, Pack<Real, 4>, Several<Real, Size>>;

/// A group of given numbers; an idle fourth lane holds the third again.
template <class Real>
Group<Real, 3> group(const Real& x, const Real& y, const Real& z)
{
  Group<Real, 3> result;
  if constexpr (std::is_floating_point_v<Real>)
  {
    result.lanes = typename Group<Real, 3>::Lanes{x, y, z, z};
  }
  else
  {
    result.lane[0] = x;
    result.lane[1] = y;
    result.lane[2] = z;
  }
  return result;
}

/// A group of four numbers.
template <class Real>
Group<Real, 4> group(const Real& x, const Real& y, const Real& z, const Real& w)
{
  Group<Real, 4> result;
  if constexpr (std::is_floating_point_v<Real>)
  {
    result.lanes = typename Group<Real, 4>::Lanes{x, y, z, w};
  }
  else
  {
    result.lane[0] = x;
    result.lane[1] = y;
    result.lane[2] = z;
    result.lane[3] = w;
  }
  return result;
}

/// The first three lanes moved one on: y, z, x.
template <class Real>
Pack<Real, 4> turned_once(const Pack<Real, 4>& v)
{
  return Pack<Real, 4>::of(__builtin_shufflevector(v.lanes, v.lanes, 1, 2, 0, 0));
}

/// The first three lanes moved two on: z, x, y.
template <class Real>
Pack<Real, 4> turned_twice(const Pack<Real, 4>& v)
{
  return Pack<Real, 4>::of(__builtin_shufflevector(v.lanes, v.lanes, 2, 0, 1, 1));
}

/// The three packs moved one on: y, z, x.
template <class Number>
Several<Number, 3> turned_once(const Several<Number, 3>& v)
{
  return group(v[1], v[2], v[0]);
}

/// The three packs moved two on: z, x, y.
template <class Number>
Several<Number, 3> turned_twice(const Several<Number, 3>& v)
{
  return group(v[2], v[0], v[1]);
}

/// Three rows of three made columns.
template <class Real>
void transpose(Pack<Real, 4> (&rows)[3])
{
  Pack<Real, 4> idle = rows[2];
  transpose(rows[0], rows[1], rows[2], idle);
}

/// Three rows of three made columns.
template <class Number>
void transpose(Several<Number, 3> (&rows)[3])
{
  using std::swap;
  swap(rows[0].lane[1], rows[1].lane[0]);
  swap(rows[0].lane[2], rows[2].lane[0]);
  swap(rows[1].lane[2], rows[2].lane[1]);
}
// [group]

// [which]
/// A number that counts things: a whole number, or for packs one of the pack's own kind.
template <class Real>
using Index = std::conditional_t<std::is_floating_point_v<Real>, int, Real>;

/// A whole number as an index.
template <class Real>
Index<Real> index(int i)
{
  return static_cast<std::conditional_t<std::is_floating_point_v<Real>, int, float>>(i);
}

/// Which of three lanes is meant, where that differs from pair to pair.
template <class Number>
struct Which
{
  typename Number::Mask is[3]; ///< set where the lane is meant

  /// Lane 0, 1 or 2.
  explicit Which(const Number& index)
      : is{index < Number(0.5f), (Number(0.5f) < index) & (index < Number(1.5f)), Number(1.5f) < index}
  {
  }
  /// The mask of each lane.
  Which(
      const typename Number::Mask& x, const typename Number::Mask& y,
      const typename Number::Mask& z)
      : is{x, y, z}
  {
  }
};

/// The lane after the one that is meant; lane 0 after lane 2.
template <class Number>
Which<Number> next(const Which<Number>& which)
{
  return {which.is[2], which.is[0], which.is[1]};
}

/// The lane after lane i.
inline int next(int i)
{
  return i == 2 ? 0 : i + 1;
}

/// Which lane an index 0, 1 or 2 means.
template <class Number>
Which<Number> which(const Number& index)
{
  return Which<Number>(index);
}

/// Which lane an index 0, 1 or 2 means: itself.
inline int which(int index)
{
  return index;
}

/// One of three things of each pair.
template <class Things, class Number>
auto chosen(const Things& things, const Which<Number>& which)
{
  return select(which.is[0], things[0], select(which.is[1], things[1], things[2]));
}

/// The i-th of three things: itself, not a copy.
template <class Things>
const auto& chosen(const Things& things, int i)
{
  return things[i];
}

/// The i-th of three numbers in one register.
template <class Real>
Real chosen(const Pack<Real, 4>& numbers, int i)
{
  return numbers[i];
}
// [which]

/// Whether a test holds, where it is of one pair only: itself.
inline bool any(bool mask)
{
  return mask;
}

/// Whether any number of the pair has the mask set.
template <class Real>
  requires std::is_floating_point_v<Real>
bool any_lane(const typename Group<Real, 3>::Mask& mask)
{
  return any(mask);
}

/// Whether any number of a pair has the mask set, for every pair.
template <class Number>
  requires(!std::is_floating_point_v<Number>)
typename Number::Mask any_lane(const typename Several<Number, 3>::Mask& mask)
{
  return mask.lane[0] | mask.lane[1] | mask.lane[2];
}

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
