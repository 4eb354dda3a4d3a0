#pragma once

/// \file
/// \brief Rows: the three or four numbers of a pair that belong together, computed with at once.

#include "common/simd/row_mask.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

// [row]
/// Three or four numbers of a pair, computed with as if they were one: each by itself, or several
/// in one `Part`, a register. Numbers that are packs have a pair in every lane.
///
/// In registers a row of three leaves the fourth lane idle; it holds the third number again, so
/// that it never decides.
template <class Real, int Size, class Part = Real>
struct RowOf // NOLINT(bugprone-reserved-identifier): of the loop by which clang copies `part`
{
  using Number = Real;                                           ///< what it is a row of
  using Four = RowOf<Real, 4, Part>;                             ///< the same with four
  static constexpr int per_part = sizeof(Part) / sizeof(Real);   ///< 1, 2 or 4 numbers
  static constexpr int parts = (Size + per_part - 1) / per_part; ///< as many as are needed
  using Mask = RowMask<Real, Part, parts, per_part>;             ///< what a comparison gives

  Part part[parts]; ///< the numbers

  RowOf() = default;
  explicit RowOf(const Real& same) { std::fill(part, part + parts, Part(same)); } ///< everywhere
  RowOf(const Real& x, const Real& y, const Real& z) { set(x, y, z, z); }         ///< three numbers
  /// Four numbers.
  RowOf(const Real& x, const Real& y, const Real& z, const Real& w) { set(x, y, z, w); }

  /// The i-th number, i < Size.
  decltype(auto) operator[](int i) const
  {
    if constexpr (per_part == 1)
    {
      return part[i];
    }
    else
    {
      return part[i / per_part][i % per_part];
    }
  }

  friend RowOf operator+(const RowOf& a, const RowOf& b) { return each<RowOf>(a, b, std::plus()); }
  friend RowOf operator-(const RowOf& a, const RowOf& b) { return each<RowOf>(a, b, std::minus()); }
  friend RowOf operator*(const RowOf& a, const RowOf& b)
  {
    return each<RowOf>(a, b, std::multiplies());
  }
  friend RowOf operator/(const RowOf& a, const RowOf& b)
  {
    return each<RowOf>(a, b, std::divides());
  }
  friend RowOf max(const RowOf& a, const RowOf& b)
  {
    return each<RowOf>(a, b, [](const Part& x, const Part& y) { return larger(x, y); });
  }
  friend RowOf min(const RowOf& a, const RowOf& b)
  {
    return each<RowOf>(a, b, [](const Part& x, const Part& y) { return smaller(x, y); });
  }
  friend RowOf abs(const RowOf& a)
  {
    using std::abs;
    return each<RowOf>(a, a, [](const Part& x, const Part&) { return abs(x); });
  }
  friend Mask operator<(const RowOf& a, const RowOf& b) { return each<Mask>(a, b, std::less()); }
  friend Mask operator<=(const RowOf& a, const RowOf& b)
  {
    return each<Mask>(a, b, std::less_equal());
  }

  /// The numbers of `yes` where the mask is set, those of `no` elsewhere.
  friend RowOf select(const Mask& mask, const RowOf& yes, const RowOf& no)
  {
    RowOf result;
    for (int i = 0; i < parts; ++i)
    {
      result.part[i] = select(mask.part[i], yes.part[i], no.part[i]);
    }
    return result;
  }

  friend RowOf turned_once(const RowOf& v) { return {v[1], v[2], v[0]}; }  ///< y, z, x
  friend RowOf turned_twice(const RowOf& v) { return {v[2], v[0], v[1]}; } ///< z, x, y

private:
  void set(const Real& x, const Real& y, const Real& z, const Real& w)
  {
    if constexpr (per_part == 4)
    {
      part[0] = Part::of(typename Part::Lanes{x, y, z, w});
    }
    else if constexpr (per_part == 2)
    {
      part[0] = Part::of(typename Part::Lanes{x, y});
      part[1] = Part::of(typename Part::Lanes{z, w});
    }
    else
    {
      part[0] = x;
      part[1] = y;
      part[2] = z;
      part[Size - 1] = w;
    }
  }
};
// [row]

/// Of every pair all of `yes` where the mask is set, all of `no` elsewhere.
template <class Real, int Size>
RowOf<Real, Size>
select(const MaskOf<Real>& mask, const RowOf<Real, Size>& yes, const RowOf<Real, Size>& no)
{
  return each<RowOf<Real, Size>>(
      yes, no, [&](const Real& x, const Real& y) { return select(mask, x, y); });
}

/// Rows made columns.
template <class Real, int Size, class Part>
void transpose(RowOf<Real, Size, Part> (&rows)[Size])
{
  using Row = RowOf<Real, Size, Part>;
  Row last = rows[Size - 1];
  if constexpr (Row::per_part == 4)
  {
    transpose_fours(rows[0].part[0], rows[1].part[0], rows[2].part[0], last.part[0]);
    rows[Size - 1] = Size == 4 ? last : rows[2];
  }
  else if constexpr (Row::per_part == 2)
  {
    const Row first = rows[0], second = rows[1], third = rows[2];
    for (int i = 0; i < Size; ++i)
    {
      rows[i] = {first[i], second[i], third[i], last[i]};
    }
  }
  else
  {
    using std::swap;
    for (int i = 0; i < Size; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        swap(rows[i].part[j], rows[j].part[i]);
      }
    }
  }
}

/// A row of the three numbers of a vector.
template <class Row, class Vector>
Row row_of(const Vector& v)
{
  return Row(v[0], v[1], v[2]);
}

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
