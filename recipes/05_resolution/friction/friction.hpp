#pragma once

/// \file
/// \brief Friction at a contact point: one impulse along the surface, no longer than its cone lets
/// it be.

#include "05_resolution/impulse/impulse.hpp"

#include <algorithm>
#include <cmath>

namespace cookbook
{

// [sliding_velocity]
/// What of a vector lies along the surface that has this unit normal.
template <class Real>
Vector3<Real> along_surface(const Vector3<Real>& v, const Vector3<Real>& normal)
{
  return v - v.dot(normal) * normal;
}

/// The velocity [m/s] with which B's surface slides over A's at a contact point.
template <class Real>
Vector3<Real> sliding_velocity(
    const Body<Real>& a, const Body<Real>& b, const Vector3<Real>& normal, const Arms<Real>& arms)
{
  return along_surface<Real>(relative_velocity(a.motion, b.motion, arms), normal);
}
// [sliding_velocity]

// [within_cone]
/// An impulse [N s] along the surface, shortened to at most a length [N s]: the cone's cut; R6.
///
/// A length of zero or less leaves none.
template <class Real>
Vector3<Real> within_cone(const Vector3<Real>& impulse, const Real& most)
{
  using std::max;
  const Real length = impulse.norm();
  return either(length <= most, impulse, [&] { return impulse * (max(Real(0), most) / length); });
}
// [within_cone]

// [sliding_mass]
/// A unit direction of the surface that has this unit normal, without a branch (Duff 2017); for a
/// normal of zero the world's x axis.
template <class Real>
Vector3<Real> direction_along(const Vector3<Real>& normal)
{
  using std::copysign;
  const Real side = copysign(Real(1), normal.z());
  const Real share = normal.x() / (side + normal.z());
  return {Real(1) - side * share * normal.x(), -side * share * normal.y(), -side * normal.x()};
}

/// How much speed [m/s] along one direction of the surface one newton second along another gives a
/// body at an arm [1/kg].
template <class Real>
Real coupling_at(
    const Body<Real>& body, const Vector3<Real>& along, const Vector3<Real>& other,
    const Vector3<Real>& arm)
{
  const Vector3<Real> turn = body.inverse_inertia * arm.cross(other);
  return body.inverse_mass * along.dot(other) + arm.cross(along).dot(turn);
}

/// A direction whose K is less than this share of the largest is not told from one that nothing
/// moves.
inline constexpr float almost_none = 1e-6f;

/// What a push along the surface feels. It stays as it is while impulses are found.
template <class Real>
struct SlidingMass
{
  Matrix3<Real> ending; ///< [kg], world: times a sliding velocity, the impulse that ends it
  Real least;           ///< [kg], in the direction that is moved most, 1/K; zero: none is moved
};

/// The mass that a push along the surface feels, from K in a direction u of it and in one across.
template <class Real>
SlidingMass<Real> sliding_mass(
    const Body<Real>& a, const Body<Real>& b, const Vector3<Real>& normal, const Arms<Real>& arms)
{
  using std::sqrt;
  const Vector3<Real> u = direction_along(normal), v = normal.cross(u);
  const Real half(Real(1) / Real(2));
  const Real uu = inverse_mass_at(a, b, u, arms), vv = inverse_mass_at(a, b, v, arms);
  const Real uv = coupling_at(a, u, v, arms.a) + coupling_at(b, u, v, arms.b);
  const Real apart = half * (uu - vv);
  const Real least = effective_mass<Real>(half * (uu + vv) + sqrt(apart * apart + uv * uv));
  const Real alone = least * (uu + vv) - Real(1); // the lesser K, as a share of the largest
  const Matrix3<Real> all = u * u.transpose() + v * v.transpose();
  Matrix3<Real> across = (vv * least) * (u * u.transpose()) + (uu * least) * (v * v.transpose()) -
                         (uv * least) * (u * v.transpose() + v * u.transpose());
  const auto one_alone = alone <= Real(almost_none);
  const Real share = either(one_alone, least, [&] { return least / alone; });
  return {share * either(one_alone, all, [&] { return across; }), least};
}
// [sliding_mass]

// [friction_impulse]
/// The impulse [N s] of friction on B after one more visit to a contact point that slides at a
/// velocity [m/s]; R6.
///
/// It is what ends the sliding, where that is at most μ times the normal impulse, `most` [N s].
/// Where that is more, it goes straight against the sliding, by so little that no direction is
/// turned back, and is cut. `so_far` is what earlier visits gave, and only the difference is still
/// to be given: it may be one that takes back.
template <class Real>
Vector3<Real> friction_impulse(
    const Vector3<Real>& sliding, const SlidingMass<Real>& mass, const Vector3<Real>& so_far,
    const Real& most)
{
  const Vector3<Real> holding = so_far - mass.ending * sliding;
  const auto cut = [&] { return within_cone<Real>(so_far - mass.least * sliding, most); };
  return either(holding.norm() <= most, holding, cut);
}
// [friction_impulse]

} // namespace cookbook
