#pragma once

/// \file
/// \brief Points, vectors, normals and planes through a transform, and the way back.

#include "01_math/matrices/matrices.hpp"
#include "01_math/transforms/plain_transforms.hpp"
#include "common/math/norm.hpp"
#include "common/math/vector.hpp"

#include <algorithm>
#include <optional>

namespace cookbook
{

// [to_local_affine]
/// The same for any affine transform; nothing where its matrix is singular to rounding, or its
/// inverse does not fit.
template <class Real>
std::optional<Vector3<Real>> to_local(const Affine3<Real>& t, const Vector3<Real>& point)
{
  const Matrix3<Real> m = t.linear();
  const std::optional<Matrix3<Real>> back = inverse<Real, 3>(m);
  if (!back || !back->allFinite())
  {
    return std::nullopt;
  }
  return *back * (point - t.translation());
}
// [to_local_affine]

// [ordinary_size]
/// A direction in 105 binary digits, brought to an ordinary size.
template <class Real>
Vector3<Real> ordinary_size(const Vector3<WideDouble>& v)
{
  int largest = 0;
  bool any = false;
  for (const WideDouble& x : v)
  {
    largest = x.high == 0 ? largest : any ? std::max(largest, x.exponent) : x.exponent;
    any = any || x.high != 0;
  }
  const auto sized = [&](const WideDouble& x) {
    return static_cast<Real>(static_cast<double>(WideDouble(x.high, x.low, x.exponent - largest)));
  };
  return v.unaryExpr(sized);
}
// [ordinary_size]

// [transformed_normal]
/// The unit normal of a surface after the matrix `m`: along M⁻ᵀ n, M14, by cofactors.
///
/// Right for entries of every size, for mirrors, and for a matrix that flattens space to a plane.
/// A normal that has no image, for it is perpendicular to what is squashed or a line is left, gets
/// +y. Which side the answer points to is certain wherever the matrix has an inverse(). `n` may
/// have any length; zero counts as +y.
template <class Real>
Vector3<Real> transformed_normal(const Matrix3<Real>& m, const Vector3<Real>& normal)
{
  const Vector3<Real> n = normalize<Real>(normal).unit;
  const Real determinant = m.determinant();
  if (keeps_digits<Real, 3>(m, determinant))
  {
    const Vector3<Real> along = cofactors<Real>(m) * n;
    return normalize<Real>(determinant < Real(0) ? Vector3<Real>(-along) : along).unit;
  }
  const Matrix3<WideDouble> wide = m.template cast<WideDouble>();
  const Matrix3<WideDouble> c = cofactors<WideDouble>(wide);
  const Vector3<WideDouble> along = c * n.template cast<WideDouble>();
  const WideDouble exact = wide.col(0).dot(c.col(0));
  const Vector3<WideDouble> outward = exact.high < 0 ? Vector3<WideDouble>(-along) : along;
  return normalize<Real>(ordinary_size<Real>(outward)).unit;
}
// [transformed_normal]

// [transformed_plane]
/// A plane after a transform, with a unit normal; M14. One of its points is carried along.
///
/// The plane's normal must be of length one.
template <class Real>
Hyperplane3<Real> transformed_plane(const Affine3<Real>& t, const Hyperplane3<Real>& plane)
{
  const Vector3<Real> n = plane.normal(), point = -plane.offset() * n;
  const Matrix3<Real> m = t.linear();
  const Vector3<Real> carried = t * point;
  return Hyperplane3<Real>(transformed_normal<Real>(m, n), carried);
}
// [transformed_plane]

// [conventions]
/// A matrix for row vectors, v M, as the one for column vectors, M v, and the other way round.
template <class Real>
Matrix4<Real> rows_and_columns_exchanged(const Matrix4<Real>& m)
{
  return m.transpose();
}

/// A transform between left-handed and right-handed coordinates: the third axis is turned round
/// before and after.
template <class Real>
Matrix4<Real> hand_exchanged(const Matrix4<Real>& m)
{
  const Vector<Real, 4> turned_round(1, 1, -1, 1);
  return turned_round.asDiagonal() * m * turned_round.asDiagonal();
}

/// The rotation from coordinates with z up to those with y up, both right-handed.
template <class Real>
Matrix3<Real> y_up_from_z_up()
{
  Matrix3<Real> m;
  m << Real(1), Real(0), Real(0), Real(0), Real(0), Real(1), Real(0), Real(-1), Real(0);
  return m;
}
// [conventions]

} // namespace cookbook
