#pragma once

/// \file
/// \brief Approach and nature of a collision, from a manifold and two moving bodies, and how they
/// are separated.

#include "03_sphere_manifolds/collision/motion.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"

#include <optional>

namespace cookbook
{

// [approach]
/// What two bodies are about to do at a contact point.
enum class Approach
{
  approaching, ///< the surfaces move into each other
  resting,     ///< they keep their distance
  separating   ///< they move apart
};

/// The approach at a contact: the sign of the relative velocity along the normal; S11.
///
/// Speeds up to `resting_speed` [m/s] count as none.
template <class Real>
Approach
approach(const Vector3<Real>& relative_velocity, const Vector3<Real>& normal, Real resting_speed)
{
  const Real speed = relative_velocity.dot(normal);
  if (speed < -resting_speed)
  {
    return Approach::approaching;
  }
  return speed > resting_speed ? Approach::separating : Approach::resting;
}
// [approach]

// [nature]
/// The nature of a collision.
enum class Nature
{
  separated,  ///< no overlap
  colliding,  ///< surfaces that meet: an overlap of no more than the tolerance
  penetrating ///< an overlap that has to be taken away
};

/// The nature of a collision: nothing to do, an impact to answer, or a depth to undo first.
///
/// Depths up to `tolerance` [m] count as meeting surfaces.
template <class Real>
Nature nature(const std::optional<Manifold<Real>>& manifold, Real tolerance)
{
  if (!manifold)
  {
    return Nature::separated;
  }
  return manifold->depth > tolerance ? Nature::penetrating : Nature::colliding;
}
// [nature]

// [separating_moves]
/// How far each of two bodies moves to end the overlap.
template <class Real>
struct SeparatingMoves
{
  Vector3<Real> a; ///< [m], world
  Vector3<Real> b; ///< [m], world
};

/// The moves that undo an overlap, shared by inverse mass [1/kg], so that the common centre of mass
/// stays where it is; S6.
///
/// A body of inverse mass zero stands still; two such bodies both do.
template <class Real, std::size_t Capacity>
SeparatingMoves<Real>
separating_moves(const Manifold<Real, Capacity>& manifold, Real inverse_mass_a, Real inverse_mass_b)
{
  const Real sum = inverse_mass_a + inverse_mass_b;
  if (sum == Real(0))
  {
    return {Vector3<Real>::Zero(), Vector3<Real>::Zero()};
  }
  const Vector3<Real> whole = manifold.depth * manifold.normal;
  return {whole * -(inverse_mass_a / sum), whole * (inverse_mass_b / sum)};
}
// [separating_moves]

} // namespace cookbook
