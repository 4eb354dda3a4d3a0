#pragma once

/// \file
/// \brief What bodies on flush tiles need within a step.

#include "06_world/contacts/world_contact.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace cookbook
{

// [seams]
/// A face of a fixed body: n·x = offset.
struct Face
{
  Vector3<double> normal; ///< [1], unit, world, out of the solid
  double offset;          ///< [m], along the normal
  int axis;               ///< of the box whose face it is, 0 … 2

  /// How far [m] a point is above it.
  double height(const Vector3<double>& point) const { return normal.dot(point) - offset; }
};

/// A contact of a body that moves with a fixed one, seen from the fixed one.
struct RestingContact
{
  WorldContact* contact;
  bool fixed_a;           ///< whether the fixed one is its body A
  int fixed, moving;      ///< the places of the two bodies
  Vector3<double> normal; ///< [1], world, from the fixed body to the one that moves
};

/// A contact as that; which of its bodies is fixed is known.
inline RestingContact resting_contact(WorldContact& contact, bool fixed_a)
{
  return {
      &contact, fixed_a, fixed_a ? contact.a : contact.b, fixed_a ? contact.b : contact.a,
      fixed_a ? contact.normal : Vector3<double>(-contact.normal)};
}

/// Where a point is [m] on the body that moves, in its frame.
inline const Vector3<double>& moving_anchor(const RestingContact& of, const WorldPoint& point)
{
  return of.fixed_a ? point.anchor_b : point.anchor_a;
}

/// A contact point on a surface which several faces continue.
struct SurfacePoint
{
  Vector2<double> place;        ///< [m], along the surface
  Vector3<double> on_body;      ///< [m], world, on the body that moves
  int contact;                  ///< which of its contacts has it
  int point;                    ///< which of that contact's points it is
  bool known;                   ///< whether it was there in the step before
  Vector3<double> fixed_center; ///< [m], of the body whose face it is on
  bool kept;                    ///< whether the surface needs it
};

/// A point that the first contact on a surface carries through a step, for another.
struct CarriedPoint
{
  WorldPoint point;   ///< as it is on the body whose face it is on
  WorldPoint carried; ///< as it is on the body of the contact which carries it
  int home;           ///< the number of its own contact
  int carrier;        ///< that of the contact which carries it
  bool flips;         ///< whether A is B there
};

/// Room for that, empty where no body is on more than one fixed one.
struct Seams
{
  ContactChanges changes;                   ///< of this step
  std::vector<WorldContact> begun;          ///< taken for ghosts, but on a surface
  std::vector<std::uint8_t> fixed_bodies;   ///< how many each body touches: none, one, more
  std::vector<std::pair<int, int>> resting; ///< bodies that move, and their contacts
  std::vector<RestingContact> contacts;     ///< those of one body
  std::vector<std::optional<Face>> faces;   ///< which each of these lies on
  std::vector<SurfacePoint> points;         ///< of one body on one surface
  std::vector<int> together;                ///< which of these contacts act as one
  std::vector<CarriedPoint> carried;        ///< until the solver has run
  std::vector<std::size_t> order;           ///< these along the surface
  std::vector<std::size_t> hull;            ///< which of these are the corners of their hull
};
// [seams]

} // namespace cookbook
