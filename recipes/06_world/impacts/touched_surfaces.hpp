#pragma once

/// \file
/// \brief Surfaces that bodies touch within a step, and which bodies continue them.

#include "06_world/impacts/next_toi.hpp"
#include "06_world/seams/flush_face.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <variant>

namespace cookbook
{

// [touched_surfaces]
/// The faces of fixed bodies that others press on as a step begins, or touch within it.
///
/// What goes far in a step passes over tiles that it did not touch as the step began: sunk a little
/// into the first, it would meet the edges of all others.
class TouchedSurfaces
{
public:
  explicit TouchedSurfaces(const StepTrajectories& step) : step_(step) {}

  /// How deep [m] a body was, as the step began, in a face of a third body that it touches and that
  /// the other continues where it is at a time [s]: zero unless it is a sphere. Nothing if there is
  /// no such face.
  std::optional<double> depth(int first, int other, double time)
  {
    if (!stays(*step_.trajectories[index_of(other)].of))
    {
      return std::nullopt;
    }
    find_pressed();
    const Vector3<double> center = step_.trajectories[index_of(first)].place_at(time);
    const auto [begin, end] = surfaces_.equal_range(first);
    for (auto touched = begin; touched != end; ++touched)
    {
      const auto& [fixed, surface] = touched->second;
      const std::optional<Face> face = face_towards(other, surface.normal);
      if (fixed != other && face && are_flush(surface, *face, center))
      {
        return depth_at_start(first, surface);
      }
    }
    return std::nullopt;
  }

  /// Takes down that a body touches another, along a normal from it to that.
  void add(int first, int other, const Vector3<double>& normal)
  {
    find_pressed();
    take(first, other, normal);
  }

private:
  struct Touched
  {
    int fixed; // the number of the body whose face it is
    Face face;
  };

  std::optional<Face> face_towards(int i, const Vector3<double>& direction) const
  {
    return std::visit(
        [&](const auto& shape)
        { return cookbook::face_towards(*step_.trajectories[index_of(i)].of, shape, direction); },
        step_.scene.bodies[index_of(i)].shape);
  }

  double depth_at_start(int i, const Face& surface) const
  {
    const SceneBody& body = step_.scene.bodies[index_of(i)];
    const SphereShape* const sphere = std::get_if<SphereShape>(&body.shape);
    return sphere ? std::max(0.0, sphere->radius - surface.height(body.position)) : 0;
  }

  void take(int first, int other, const Vector3<double>& normal)
  {
    if (!stays(*step_.trajectories[index_of(other)].of))
    {
      return;
    }
    const double angle = is_sphere(step_.scene, first) ? rounding_angle : resting_angle;
    const std::optional<Face> face = face_towards(other, -normal);
    if (face && are_parallel(face->normal, -normal, angle))
    {
      surfaces_.emplace(first, Touched{other, *face});
    }
  }

  /// Takes down what presses on what, once.
  void find_pressed()
  {
    if (std::exchange(searched_, true))
    {
      return;
    }
    for (const WorldContact& contact : step_.contacts)
    {
      if (is_touching(contact))
      {
        take(contact.a, contact.b, contact.normal);
        take(contact.b, contact.a, -contact.normal);
      }
    }
  }

  const StepTrajectories& step_;
  bool searched_ = false;
  std::multimap<int, Touched> surfaces_; // by the number of the body that touches them
};
// [touched_surfaces]

} // namespace cookbook
