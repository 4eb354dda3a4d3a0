#pragma once

/// \file
/// \brief Which part of a picture a scene takes.

#include "06_world/scenes/trial/frames.hpp"

namespace cookbook
{

/// A rectangle of the picture, right and up as seen [m].
using PictureBounds = Eigen::AlignedBox2d;

/// The rectangle that a body covers; empty for a plane, and where the body is nowhere.
inline PictureBounds
bounds_of(const SceneBody& body, const BodyState& state, const Matrix3<double>& axes)
{
  Vector3<double> reach = Vector3<double>::Zero();
  if (const auto* const box = std::get_if<BoxShape>(&body.shape))
  {
    const Matrix3<double> halves =
        axes * state.orientation.toRotationMatrix() * box->half_extents.asDiagonal();
    reach = halves.cwiseAbs().rowwise().sum();
  }
  if (const auto* const sphere = std::get_if<SphereShape>(&body.shape))
  {
    reach.setConstant(sphere->radius);
  }
  const Vector3<double> center = axes * state.position;
  const bool seen = reach.allFinite() && !reach.isZero(0) && center.allFinite();
  return seen ? PictureBounds((center - reach).head<2>(), (center + reach).head<2>())
              : PictureBounds();
}

/// The rectangle of all movable bodies, or of all fixed ones.
inline PictureBounds
bounds_of(const Scene& scene, const Frame& frame, const Matrix3<double>& axes, bool movable)
{
  PictureBounds bounds;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
  {
    if ((scene.bodies[i].mass > 0) == movable)
    {
      bounds.extend(bounds_of(scene.bodies[i], frame.bodies[i], axes));
    }
  }
  return bounds;
}

} // namespace cookbook
