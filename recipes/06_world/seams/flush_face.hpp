#pragma once

/// \file
/// \brief Faces of fixed bodies which a body rests on, and which of them continue one surface.

#include "06_world/seams/seams.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <variant>

namespace cookbook
{

// [flush_face]
/// Faces are flush where they differ in height by no more than this fraction of the height of the
/// body's centre above them, and in direction by no more than this angle [rad].
///
/// A sphere of radius r that rolls onto a step of height s meets its edge with a normal of which
/// cos = 1 − s/r: it loses the fraction s/r of its speed. So a step that is left out would have
/// cost no more than this fraction of the speed, and a bend this fraction of the weight.
inline constexpr double flush_tolerance = 5e-4;
/// A box whose normal is a face's to this angle [rad] lies on that face, tilted as solvers leave
/// it.
inline constexpr double resting_angle = 0.01;
/// A sphere is above a face where its normal is the face's to rounding; beside, it is at an edge.
/// What lies on the same face in every digit has its normal to that.
inline constexpr double rounding_angle = 1e-9;

/// The face of a shape whose normal is nearest to a direction; a sphere has none.
inline std::optional<Face>
face_towards(const RigidBody& body, const BoxShape& box, const Vector3<double>& direction)
{
  int axis = 0;
  const double most = (body.axes.transpose() * direction).cwiseAbs().maxCoeff(&axis);
  const double side = body.axes.col(axis).dot(direction) < 0 ? -1 : 1;
  const Vector3<double> normal = side * body.axes.col(axis);
  return most > 0 ? std::optional(
                        Face{normal, normal.dot(body.motion.center) + box.half_extents[axis], axis})
                  : std::nullopt;
}
inline std::optional<Face>
face_towards(const RigidBody&, const PlaneShape& plane, const Vector3<double>&)
{
  return Face{plane.normal, plane.offset, 0};
}
inline std::optional<Face>
face_towards(const RigidBody&, const SphereShape&, const Vector3<double>&)
{
  return std::nullopt;
}

/// None whose edges are known.
inline std::optional<Face>
face_towards(const RigidBody&, const ConvexShape&, const Vector3<double>&)
{
  return std::nullopt;
}

/// Whether two unit vectors differ by no more than an angle [rad], which is small.
inline bool are_parallel(const Vector3<double>& one, const Vector3<double>& other, double angle)
{
  return one.dot(other) > 0 && (one - other).squaredNorm() <= angle * angle;
}

/// Whether a face continues a surface for a body whose centre is at a place [m] above that.
inline bool are_flush(const Face& surface, const Face& face, const Vector3<double>& center)
{
  const double height = surface.height(center);
  return are_parallel(face.normal, surface.normal, flush_tolerance) &&
         std::abs(height - face.height(center)) <= flush_tolerance * std::max(0.0, height);
}
// [flush_face]

/// The bodies of a world, and scratch, for the contacts of one of them.
struct SeamView
{
  Seams& seams;
  const Scene& scene;
  std::span<const RigidBody> bodies;
  double margin; ///< [m], how far apart bodies in contact may be

  bool is_box(int i) const
  {
    return std::holds_alternative<BoxShape>(scene.bodies[index_of(i)].shape);
  }
};

/// The face of a contact's fixed body that is nearest to a direction.
inline std::optional<Face>
face_towards(const SeamView& view, const RestingContact& of, const Vector3<double>& direction)
{
  return std::visit(
      [&](const auto& shape)
      { return face_towards(view.bodies[index_of(of.fixed)], shape, direction); },
      view.scene.bodies[index_of(of.fixed)].shape);
}

/// The face that a contact lies on; none at an edge or a corner of the fixed body.
inline std::optional<Face> face_of(const SeamView& view, const RestingContact& of)
{
  const bool sphere = view.bodies[index_of(of.moving)].is_sphere;
  std::optional<Face> face = face_towards(view, of, of.normal);
  return face && are_parallel(face->normal, of.normal, sphere ? rounding_angle : resting_angle)
             ? face
             : std::nullopt;
}

/// How far [m] the faces of a surface may differ in height, under a body at a place on them.
inline double height_tolerance(const SeamView& view, int moving, const Face& face)
{
  return flush_tolerance * std::max(0.0, face.height(view.bodies[index_of(moving)].motion.center));
}

/// The face of a contact's fixed body which continues another body's face, under the centre of the
/// body that moves; none if it has no such face.
inline std::optional<Face>
flush_face(const SeamView& view, const RestingContact& of, const Face& surface)
{
  const std::optional<Face> face = face_towards(view, of, surface.normal);
  const Vector3<double>& center = view.bodies[index_of(of.moving)].motion.center;
  return face && are_flush(surface, *face, center) ? face : std::nullopt;
}

} // namespace cookbook
