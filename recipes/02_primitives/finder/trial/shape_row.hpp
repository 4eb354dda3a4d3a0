#pragma once

/// \file
/// \brief The columns of a shape in a reader's file, checked as they are read.

#include "02_primitives/shapes/shapes.hpp"
#include "tools/files/pairs_row.hpp"

#include <cmath>
#include <string>

namespace cookbook
{

/// The columns of one of the two shapes of a row, checked as they are read: CsvError at the column.
template <class Real>
struct ShapeRow
{
  const PairsRow& row; ///< the row
  std::size_t first;   ///< its first column that is of the shape

  Real number(std::size_t i) const { return row.at<Real>(first + i); }

  Vector<Real, 2> point2(std::size_t i) const { return {number(i), number(i + 1)}; }

  Vector3<Real> point(std::size_t i) const { return row.vector<Real>(first + i); }

  Real radius(std::size_t i) const
  {
    return number_if(i, number(i) >= Real(0), "the radius must be zero or more");
  }

  Real half_extent(std::size_t i) const
  {
    return number_if(i, number(i) > Real(0), "a half extent must be greater than zero");
  }

  Vector<Real, 2> half_extents2(std::size_t i) const
  {
    return {half_extent(i), half_extent(i + 1)};
  }

  Vector3<Real> half_extents(std::size_t i) const
  {
    return {half_extent(i), half_extent(i + 1), half_extent(i + 2)};
  }

  /// Refuses a direction of length zero.
  template <int Size>
  Vector<Real, Size> direction(std::size_t i, const Vector<Real, Size>& v) const
  {
    if (v.isZero(0))
    {
      row.fail(first + i, "the direction must not be zero");
    }
    return v;
  }

  /// A plane whose normal has a length within 1e-4 of one, which is taken as rounded.
  Plane<Real> plane() const
  {
    const std::vector<double>& v = row.row.values;
    const Vector3<double> n(v[first], v[first + 1], v[first + 2]);
    const double length = n.norm();
    if (!(std::abs(length - 1) <= 1e-4))
    {
      row.fail(first, "the normal must have length 1, got " + round_trip(length));
    }
    number(3);
    return {(n / length).template cast<Real>(), static_cast<Real>(v[first + 3] / length)};
  }

  /// The axes that a quaternion w, x, y, z makes; its length is within a thousandth of one.
  Matrix3<Real> axes(std::size_t i) const
  {
    const double* v = row.row.values.data() + first + i;
    const Quaternion<double> q(v[0], v[1], v[2], v[3]);
    if (!(std::abs(q.norm() - 1) <= 1e-3))
    {
      row.fail(first + i, "the quaternion must have length 1, got " + round_trip(q.norm()));
    }
    return q.normalized().toRotationMatrix().template cast<Real>();
  }

private:
  Real number_if(std::size_t i, bool good, const std::string& sentence) const
  {
    if (!good)
    {
      row.fail(first + i, sentence + ", got " + round_trip(row.row.values[first + i]));
    }
    return number(i);
  }
};

} // namespace cookbook
