#pragma once

/// \file
/// \brief Friction at a contact point: one impulse along the surface, no longer than its cone lets
/// it be.

#include "05_resolution/impulse/contact_impulse.hpp"

#include <algorithm>
#include <cmath>

namespace cookbook
{

// [surface_axes]
/// What of a vector lies along the surface that has this unit normal.
template <class Real>
Vector3<Real> along_surface(const Vector3<Real>& v, const Vector3<Real>& normal)
{
  return v - v.dot(normal) * normal;
}

/// Two unit directions of a surface, at right angles, world.
template <class Real>
struct SurfaceAxes
{
  Vector3<Real> u;
  Vector3<Real> w;

  /// A vector of the surface in the world.
  Vector3<Real> in_world(const Vector2<Real>& of) const { return of.x() * u + of.y() * w; }
  /// What of a vector of the world lies along the surface.
  Vector2<Real> along(const Vector3<Real>& v) const { return {v.dot(u), v.dot(w)}; }
};

/// Those of the surface that has this unit normal, without a branch (Duff 2017); for a normal of
/// zero two axes of the world.
template <class Real>
SurfaceAxes<Real> surface_axes(const Vector3<Real>& normal)
{
  using std::copysign;
  const Real &x = normal.x(), &y = normal.y();
  const Real side = copysign(Real(1), normal.z());
  const Real share = Real(1) / (side + normal.z());
  const Real mixed = -share * x * y;
  return {
      {Real(1) - side * share * x * x, side * mixed, -side * x}, {mixed, side - share * y * y, -y}};
}
// [surface_axes]

// [sliding_velocity]
/// The velocity [m/s] with which B's surface slides over A's at a contact point, along the axes of
/// the surface.
template <class Real>
Vector2<Real> sliding_velocity(
    const Body<Real>& a, const Body<Real>& b, const SurfaceAxes<Real>& surface,
    const Arms<Real>& arms)
{
  return surface.along(relative_velocity(a.motion, b.motion, arms));
}
// [sliding_velocity]

// [within_cone]
/// An impulse [N s] along the surface, shortened to at most a length [N s]: the cone's cut; R6.
///
/// A length of zero or less leaves none.
template <class Real, int Size>
Vector<Real, Size> within_cone(const Vector<Real, Size>& impulse, const Real& max_friction)
{
  using std::max;
  const Real length = impulse.norm();
  return either(
      length <= max_friction, impulse,
      [&] { return impulse * (max(Real(0), max_friction) / length); });
}
// [within_cone]

// [sliding_mass]
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

/// A direction whose K is less than this fraction of the largest is not told from one that nothing
/// moves.
inline constexpr float singular_fraction = 1e-6f;

/// What a push along the surface feels. It stays as it is while impulses are found.
template <class Real>
struct SlidingMass
{
  Matrix2<Real> matrix; ///< [kg], surface: times a sliding velocity, the impulse that ends it
  Real smallest;        ///< [kg], in the direction that is moved most, 1/K; zero: none is moved
};

/// The mass that a push along the surface feels, from K along its two axes.
template <class Real>
SlidingMass<Real> sliding_mass(
    const Body<Real>& a, const Body<Real>& b, const SurfaceAxes<Real>& surface,
    const Arms<Real>& arms)
{
  using std::sqrt;
  const auto& [u, w] = surface;
  const Real half(Real(1) / Real(2));
  const Real uu = inverse_mass_at(a, b, u, arms), ww = inverse_mass_at(a, b, w, arms);
  const Real uw = coupling_at(a, u, w, arms.a) + coupling_at(b, u, w, arms.b);
  const Real apart = half * (uu - ww);
  const Real least = effective_mass<Real>(half * (uu + ww) + sqrt(apart * apart + uw * uw));
  const Real alone = least * (uu + ww) - Real(1); // the lesser K, as a fraction of the largest
  const auto one_alone = alone <= Real(singular_fraction);
  const Real share = either(one_alone, least, [&] { return least / alone; });
  const auto entry = [&](const Real& if_alone, const Real& of)
  { return share * either(one_alone, if_alone, [&] { return of * least; }); };
  const Real across = entry(Real(0), -uw);
  SlidingMass<Real> mass{{}, least};
  mass.matrix << entry(Real(1), ww), across, across, entry(Real(1), uu);
  return mass;
}
// [sliding_mass]

// [friction_impulse]
/// The impulse [N s] of friction on B after one more visit to a contact point that slides at a
/// velocity [m/s], both along the surface; R6.
///
/// It is what ends the sliding, where that is at most μ times the normal impulse, `max_friction` [N
/// s]. Where that is more, it goes straight against the sliding, by so little that no direction is
/// turned back, and is cut. `accumulated` is what earlier visits gave, and only the difference is
/// still to be given: it may be one that takes back.
template <class Real>
Vector2<Real> friction_impulse(
    const Vector2<Real>& sliding, const SlidingMass<Real>& mass, const Vector2<Real>& accumulated,
    const Real& max_friction)
{
  const Vector2<Real> holding = accumulated - mass.matrix * sliding;
  const auto cut = [&]
  { return within_cone<Real, 2>(accumulated - mass.smallest * sliding, max_friction); };
  return either(holding.norm() <= max_friction, holding, cut);
}
// [friction_impulse]

} // namespace cookbook
