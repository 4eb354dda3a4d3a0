#pragma once

/// \file
/// \brief Up to four contacts side by side, and their points.

#include "05_resolution/islands/island_points.hpp"
#include "05_resolution/wide_solver/four_lanes.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace cookbook
{

// [wide_contact]
/// Up to four contacts of a colour, each in a lane of its own.
struct WideContact
{
  std::array<WorldContact*, 4> contacts; ///< none: a lane without one
  std::array<int, 4> a;                  ///< the numbers of bodies A; none: that of nobody
  std::array<int, 4> b;                  ///< the numbers of bodies B
  Body<Four> body_a;                     ///< the four bodies A, as far as a push changes them
  Body<Four> body_b;                     ///< the four bodies B
  Vector3<Four> across;                  ///< [1], world, a direction of each surface
  Four correction_speed;                 ///< [m/s], no overlap is taken away faster
  std::size_t first;                     ///< the place of its first point
  std::size_t points;                    ///< how many there are: the most of any lane
};

/// The points of the contact in a lane; none if there is no contact.
inline std::span<WorldPoint> points_in(const WideContact& four, std::size_t lane)
{
  WorldContact* const contact = four.contacts[lane];
  return contact != nullptr ? contact->points() : std::span<WorldPoint>();
}

/// A point that pushes nothing: it has no normal, no impulse, and no friction.
inline ContactConstraint<Four> no_point()
{
  const Four none(0);
  const Vector3<Four> zero(none, none, none);
  const Matrix3<Four> zeros = Matrix3<Four>::Constant(none);
  return {zero, {zero, zero}, none, none, none, zero, none, {zeros, none}};
}

/// Four lanes without a contact, between nobody and nobody.
inline WideContact no_contact(std::size_t nobody)
{
  WideContact four = {};
  four.a.fill(static_cast<int>(nobody));
  four.b = four.a;
  four.across = no_point().normal;
  return four;
}

/// Sets one lane of a vector.
template <class Real>
void set_lane(Vector3<Four>& to, std::size_t lane, const Vector3<Real>& from)
{
  for (int i = 0; i < 3; ++i)
  {
    to[i].lanes[lane] = static_cast<float>(from[i]);
  }
}

/// Sets one lane of a point, but for its masses.
template <class Real>
void set_lane(ContactConstraint<Four>& to, std::size_t lane, const ContactConstraint<Real>& from)
{
  set_lane(to.normal, lane, from.normal);
  set_lane(to.arms.a, lane, from.arms.a);
  set_lane(to.arms.b, lane, from.arms.b);
  set_lane(to.friction, lane, from.friction);
  to.coefficient.lanes[lane] = static_cast<float>(from.coefficient);
  to.apart.lanes[lane] = static_cast<float>(from.apart);
  to.impulse.lanes[lane] = static_cast<float>(from.impulse);
}

/// Puts a contact into a lane, but for its points, and how fast [m/s] its overlap is taken away.
inline void
put_contact(WideContact& four, std::size_t lane, WorldContact& contact, float correction_speed)
{
  four.contacts[lane] = &contact;
  four.a[lane] = contact.a;
  four.b[lane] = contact.b;
  four.correction_speed.lanes[lane] = correction_speed;
  set_lane(four.across, lane, contact.normal().unitOrthogonal());
}

/// Puts the points of four contacts into their lanes, their impulses as so large a share of a
/// frame's.
inline void put_points(
    const WideContact& four, IslandView world, std::span<ContactConstraint<Four>> points,
    double share)
{
  for (std::size_t lane = 0; lane < 4; ++lane)
  {
    std::size_t place = 0;
    for (const WorldPoint& point : points_in(four, lane))
    {
      const WorldContact& contact = *four.contacts[lane];
      const RigidBody& a = world.bodies[place_of(contact.a)];
      const RigidBody& b = world.bodies[place_of(contact.b)];
      ContactConstraint<double> at = constraint_of(a, b, contact, point);
      at.impulse *= share;
      at.friction *= share;
      set_lane(points[place++], lane, at);
    }
  }
}

/// Takes the masses of four contacts' bodies, and finds what impulses at their points feel.
inline void take_masses(
    WideContact& four, std::span<LaneBody> bodies, std::span<ContactConstraint<Four>> points)
{
  gather_inverse_masses(bodies, four.a, four.body_a);
  gather_inverse_masses(bodies, four.b, four.body_b);
  for (ContactConstraint<Four>& at : points)
  {
    find_masses<Four>(at, four.body_a, four.body_b, four.across);
  }
}

/// Takes what a point in one lane has been given, so many times.
inline void
take_lane(const ContactConstraint<Four>& from, std::size_t lane, float scale, WorldPoint& to)
{
  const Vector3<Four>& friction = from.friction;
  to.impulse = scale * from.impulse[lane];
  to.friction = {
      scale * friction.x()[lane], scale * friction.y()[lane], scale * friction.z()[lane]};
}
// [wide_contact]

} // namespace cookbook
