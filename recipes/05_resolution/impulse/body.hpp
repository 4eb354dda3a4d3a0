#pragma once

/// \file
/// \brief Bodies that can be pushed and turned: motion, inverse mass, inverse inertia.

#include "03_sphere_manifolds/collision/motion.hpp"
#include "05_resolution/mass_properties/solid_mass.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cookbook
{

// [inertia]
/// One over a mass [kg] or a moment [kg m²], as far as products of such numbers stay finite.
///
/// A mass too small for that, even zero, counts as the smallest that is not, 5e-20 in float and
/// 7e-155 in double; one too large as immovable.
template <class Real>
Real bounded_inverse(const Real& resistance)
{
  using std::sqrt;
  const Real inverse = Real(1) / resistance;
  if constexpr (std::numeric_limits<Real>::has_infinity)
  {
    const Real most = sqrt(std::numeric_limits<Real>::max());
    return inverse < Real(1) / most ? Real(0) : std::min(inverse, most);
  }
  return inverse;
}

/// The inverse inertia [1/(kg m²)] in the world of a body whose axes are the columns of a matrix.
template <class Real>
Matrix3<Real> world_inverse_inertia(const Vector3<Real>& moments, const Matrix3<Real>& axes)
{
  const Vector3<Real> inverses = moments.unaryExpr(&bounded_inverse<Real>);
  return axes * inverses.asDiagonal() * axes.transpose();
}
// [inertia]

// [body]
/// A moving body, and how much a push changes its motion.
template <class Real>
struct Body
{
  Motion<Real> motion;           ///< how it moves now
  Real inverse_mass;             ///< [1/kg], zero where no push moves it
  Matrix3<Real> inverse_inertia; ///< [1/(kg m²)], world; zero where no push turns it
};

/// A body with these mass properties, turned so that its axes are the columns of a matrix.
template <class Real>
Body<Real> dynamic_body(
    const Motion<Real>& motion, const MassProperties<Real>& properties, const Matrix3<Real>& axes)
{
  return {
      motion, bounded_inverse(properties.mass), world_inverse_inertia(properties.moments, axes)};
}

/// A body at rest that nothing moves, such as the ground.
template <class Real>
Body<Real> static_body(const Vector3<Real>& center)
{
  const Vector3<Real> zero = Vector3<Real>::Zero();
  return {{center, zero, zero}, Real(0), Matrix3<Real>::Zero()};
}
// [body]

} // namespace cookbook
