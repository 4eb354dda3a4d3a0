#pragma once

/// \file
/// \brief Shapes from the columns of a reader's file.

#include "02_primitives/shapes/plane_shapes.hpp"
#include "02_primitives/shapes/shapes.hpp"
#include "common/files/pairs_row.hpp"

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

// [shape_columns]
/// What a shape is called in the finder, the columns that it has, and how it is read from them.
template <class Shape>
struct ShapeColumns;

template <class Real>
struct ShapeColumns<Vector3<Real>>
{
  static constexpr const char *name = "point", *columns = "x,y,z";
  static Vector3<Real> read(const ShapeRow<Real>& row) { return row.point(0); }
};

template <class Real>
struct ShapeColumns<Segment<Real>>
{
  static constexpr const char *name = "segment", *columns = "px,py,pz,qx,qy,qz";
  static Segment<Real> read(const ShapeRow<Real>& row) { return {row.point(0), row.point(3)}; }
};
// [shape_columns]

template <class Real>
struct ShapeColumns<Ray<Real>>
{
  static constexpr const char *name = "ray", *columns = "ox,oy,oz,dx,dy,dz";
  static Ray<Real> read(const ShapeRow<Real>& row)
  {
    return {row.point(0), row.template direction<3>(3, row.point(3))};
  }
};

template <class Real>
struct ShapeColumns<Plane<Real>>
{
  static constexpr const char *name = "plane", *columns = "nx,ny,nz,d";
  static Plane<Real> read(const ShapeRow<Real>& row) { return row.plane(); }
};

template <class Real>
struct ShapeColumns<Sphere<Real>>
{
  static constexpr const char *name = "sphere", *columns = "x,y,z,r";
  static Sphere<Real> read(const ShapeRow<Real>& row) { return {row.point(0), row.radius(3)}; }
};

template <class Real>
struct ShapeColumns<Capsule<Real>>
{
  static constexpr const char *name = "capsule", *columns = "px,py,pz,qx,qy,qz,r";
  static Capsule<Real> read(const ShapeRow<Real>& row)
  {
    return {{row.point(0), row.point(3)}, row.radius(6)};
  }
};

template <class Real>
struct ShapeColumns<Aabb<Real>>
{
  static constexpr const char *name = "aabb", *columns = "x,y,z,hx,hy,hz";
  static Aabb<Real> read(const ShapeRow<Real>& row)
  {
    const Vector3<Real> c = row.point(0), h = row.half_extents(3);
    return Aabb<Real>(Vector3<Real>(c - h), Vector3<Real>(c + h));
  }
};

template <class Real>
struct ShapeColumns<Obb<Real>>
{
  static constexpr const char *name = "obb", *columns = "x,y,z,qw,qx,qy,qz,hx,hy,hz";
  static Obb<Real> read(const ShapeRow<Real>& row)
  {
    return {row.point(0), row.axes(3), row.half_extents(7)};
  }
};

template <class Real>
struct ShapeColumns<Triangle<Real>>
{
  static constexpr const char *name = "triangle", *columns = "px,py,pz,qx,qy,qz,rx,ry,rz";
  static Triangle<Real> read(const ShapeRow<Real>& row)
  {
    return {row.point(0), row.point(3), row.point(6)};
  }
};

template <class Real>
struct ShapeColumns<Tetrahedron<Real>>
{
  static constexpr const char *name = "tetrahedron",
                              *columns = "px,py,pz,qx,qy,qz,rx,ry,rz,sx,sy,sz";
  static Tetrahedron<Real> read(const ShapeRow<Real>& row)
  {
    return {row.point(0), row.point(3), row.point(6), row.point(9)};
  }
};

template <class Real>
struct ShapeColumns<Vector<Real, 2>>
{
  static constexpr const char *name = "point2", *columns = "x,y";
  static Vector<Real, 2> read(const ShapeRow<Real>& row) { return row.point2(0); }
};

template <class Real>
struct ShapeColumns<Segment2<Real>>
{
  static constexpr const char *name = "segment2", *columns = "px,py,qx,qy";
  static Segment2<Real> read(const ShapeRow<Real>& row) { return {row.point2(0), row.point2(2)}; }
};

template <class Real>
struct ShapeColumns<Ray2<Real>>
{
  static constexpr const char *name = "ray2", *columns = "ox,oy,dx,dy";
  static Ray2<Real> read(const ShapeRow<Real>& row)
  {
    return {row.point2(0), row.template direction<2>(2, row.point2(2))};
  }
};

template <class Real>
struct ShapeColumns<Circle<Real>>
{
  static constexpr const char *name = "circle", *columns = "x,y,r";
  static Circle<Real> read(const ShapeRow<Real>& row) { return {row.point2(0), row.radius(2)}; }
};

template <class Real>
struct ShapeColumns<Rectangle<Real>>
{
  static constexpr const char *name = "rectangle", *columns = "x,y,hx,hy";
  static Rectangle<Real> read(const ShapeRow<Real>& row)
  {
    return {row.point2(0), row.half_extents2(2)};
  }
};

template <class Real>
struct ShapeColumns<TurnedRectangle<Real>>
{
  static constexpr const char *name = "turned_rectangle", *columns = "x,y,angle,hx,hy";
  static TurnedRectangle<Real> read(const ShapeRow<Real>& row)
  {
    return {row.point2(0), row.number(2), row.half_extents2(3)};
  }
};

} // namespace cookbook
