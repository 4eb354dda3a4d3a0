#pragma once

/// \file
/// \brief From a rotation matrix to its quaternion, whatever the rotation.

#include "01_math/rotations/unit_quaternion.hpp"

#include <cmath>

namespace cookbook
{

// [quaternion_column]
/// The column of 4qqᵀ with an entry of one or more on the diagonal: a multiple of q.
///
/// Each of its entries is a sum or difference of entries of the rotation matrix `r`.
template <class Real>
Quaternion<Real> quaternion_column(const Matrix3<Real>& r)
{
  const Real xx = r(0, 0), yy = r(1, 1), zz = r(2, 2);
  const Real wx = r(2, 1) - r(1, 2), wy = r(0, 2) - r(2, 0), wz = r(1, 0) - r(0, 1);
  const Real xy = r(1, 0) + r(0, 1), xz = r(0, 2) + r(2, 0), yz = r(2, 1) + r(1, 2);
  if (zz >= Real(0))
  {
    return xx + yy >= Real(0) ? Quaternion<Real>(Real(1) + xx + yy + zz, wx, wy, wz)
                              : Quaternion<Real>(wz, xz, yz, Real(1) - xx - yy + zz);
  }
  return xx > yy ? Quaternion<Real>(wx, Real(1) + xx - yy - zz, xy, xz)
                 : Quaternion<Real>(wy, xy, Real(1) - xx + yy - zz, yz);
}
// [quaternion_column]

// [quaternion_of]
/// The quaternion of a rotation matrix: of length one, with w > 0; half a turn, where w = 0, has
/// the first other part that is not zero above zero.
///
/// Right to two units in the last place of one. A matrix that has drifted from a rotation still
/// gets a quaternion of length one.
template <class Real>
Quaternion<Real> quaternion_of(const Matrix3<Real>& r)
{
  using std::sqrt;
  const Quaternion<Real> q = quaternion_column(r);
  const Real first = q.w() != Real(0)   ? q.w()
                     : q.x() != Real(0) ? q.x()
                     : q.y() != Real(0) ? q.y()
                                        : q.z();
  const Real length = sqrt(dot(q, q));
  return times<Real>((first < Real(0) ? Real(-1) : Real(1)) / length, q);
}
// [quaternion_of]

} // namespace cookbook
