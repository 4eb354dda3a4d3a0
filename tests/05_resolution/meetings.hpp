/// \file
/// Bodies that meet, as the tests of this chapter need them: exact, and the same ones every time.
#pragma once

#include "05_resolution/impulse/impulse.hpp"
#include "05_resolution/impulse/trial/conserved.hpp"
#include "05_resolution/mass_properties/mass_properties.hpp"
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"

#include <random>
#include <tuple>

namespace cookbook
{

/// A few roundings of numbers of size one: double's unit roundoff is 1.1e-16.
inline constexpr double rounding = 1e-15;

template <class Real>
Vector3<Real> vec(const Real& x, const Real& y, const Real& z)
{
  return {x, y, z};
}

/// The unit cube of 1 kg with its centre at the origin, down at 1 m/s, above something immovable.
template <class Real>
BodyPair<Real> falling_on_ground()
{
  const Real half = Real(1) / Real(2);
  const MassProperties<Real> cube = solid_box<Real>(1, Vector3<Real>::Constant(half));
  const Motion<Real> down{Vector3<Real>::Zero(), vec<Real>(0, -1, 0), Vector3<Real>::Zero()};
  return {
      dynamic_body<Real>(down, cube, Matrix3<Real>::Identity()),
      static_body<Real>(Vector3<Real>::Zero())};
}

/// A body of mass 1 and moments 1 at the origin, that moves along y and turns about z, above
/// something immovable.
template <class Real>
BodyPair<Real> unit_body(const Real& velocity, const Real& spin)
{
  const Motion<Real> motion{
      Vector3<Real>::Zero(), vec<Real>(0, velocity, 0), vec<Real>(0, 0, spin)};
  return {{motion, Real(1), Matrix3<Real>::Identity()}, static_body<Real>(Vector3<Real>::Zero())};
}

/// Two bodies about to meet, with all that is needed to weigh them.
struct RandomMeeting
{
  BodyPair<Rational> bodies;
  Rational mass_a, mass_b;
  Matrix3<Rational> inertia_a, inertia_b;
  Vector3<Rational> normal, point;

  /// [m/s], of these bodies as they move now.
  Rational separating_velocity_of(const BodyPair<Rational>& moving) const
  {
    return separating_velocity(moving.a, moving.b, normal, arms_to(moving, point));
  }
  /// [1/kg], along the normal.
  Rational inverse_mass() const
  {
    return inverse_mass_at(bodies.a, bodies.b, normal, arms_to(bodies, point));
  }
  Conserved<Rational> sums(const BodyPair<Rational>& moving) const
  {
    return conserved(moving.a.motion, mass_a, inertia_a) +
           conserved(moving.b.motion, mass_b, inertia_b);
  }
};

/// Exact bodies and contacts from whole numbers, the same ones every time.
class RandomMeetings
{
public:
  RandomMeeting next()
  {
    RandomMeeting meeting;
    std::tie(meeting.bodies.a, meeting.mass_a, meeting.inertia_a) = body();
    std::tie(meeting.bodies.b, meeting.mass_b, meeting.inertia_b) = body();
    meeting.normal = rotation().col(0);
    meeting.point = vector();
    if (meeting.separating_velocity_of(meeting.bodies) > 0)
    {
      meeting.normal = -meeting.normal;
    }
    return meeting;
  }

private:
  int whole(int least, int most)
  {
    return least + static_cast<int>(random_() % static_cast<unsigned>(most - least + 1));
  }
  Vector3<Rational> vector()
  {
    const int x = whole(-9, 9), y = whole(-9, 9);
    return Vector3<Rational>(x, y, whole(-9, 9)) / Rational(4);
  }
  Matrix3<Rational> rotation()
  {
    const int x = whole(-5, 5), y = whole(-5, 5);
    return rational_rotation<Rational>(whole(1, 5), x, y, whole(-5, 5));
  }
  std::tuple<Body<Rational>, Rational, Matrix3<Rational>> body()
  {
    const int x = whole(1, 9), y = whole(1, 9);
    const MassProperties<Rational> properties{whole(1, 9), {x, y, whole(1, 9)}};
    const Matrix3<Rational> axes = rotation();
    const Vector3<Rational> center = vector(), velocity = vector();
    const Body<Rational> made =
        dynamic_body<Rational>({center, velocity, vector()}, properties, axes);
    return {made, properties.mass, world_inertia(properties.moments, axes)};
  }
  std::mt19937 random_{5};
};

} // namespace cookbook
