#pragma once

/// \file
/// \brief What a ray or a ball meets first among the bodies of a world, and what a shape overlaps.

#include "02_primitives/casts/casts.hpp"
#include "02_primitives/meshes/ray_enters_box.hpp"
#include "02_primitives/overlaps/overlaps.hpp"
#include "02_primitives/shape_bounds/shape_bounds.hpp"
#include "02_primitives/shapes/checked_more_shapes.hpp"
#include "05_resolution/tunnelling/swept_sphere.hpp"
#include "06_world/contacts/near_shapes.hpp"
#include "06_world/game_world/game_world.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace cookbook
{

// [world_queries]
/// What a ray has met.
struct BodyHit
{
  BodyId body;        ///< whom
  Hit<double, 3> hit; ///< where, as chapter 2's casts say
};

/// What a ball that is moved has met.
struct BallHit
{
  BodyId body;          ///< whom
  SweptHit<double> hit; ///< which share of the way is free, and the normal: out of the ball, into
                        ///< the body, where that of a ray's hit points out of the body
};

/// Bounds of a body that hold it in spite of rounding; infinite for a plane.
inline Eigen::AlignedBox<double, 3> sure_bounds(const RigidBody& body, const SceneBody& of)
{
  const Eigen::AlignedBox<double, 3> box = bounds_of(body, of.shape, 0);
  const double largest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  const Vector3<double> little =
      Vector3<double>::Constant(8 * std::numeric_limits<double>::epsilon() * largest);
  return {box.min() - little, box.max() + little};
}

/// Asks every body.
inline constexpr auto everybody = [](BodyId) { return true; };

/// Answers questions about the bodies of a world as they are now. It is made anew after a step,
/// once a body was put in, or elsewhere, and once the world is another. Who was taken out meanwhile
/// does not answer.
class WorldQueries
{
public:
  explicit WorldQueries(GameWorld&&) = delete;
  /// Sorts the bodies that are there by where they are; the world has to outlive the answers.
  explicit WorldQueries(const GameWorld& world) : world_(world)
  {
    std::vector<Bounds> bounds;
    for (std::size_t i = 0; i < world.bodies().size(); ++i)
    {
      if (world.has(world.id(i)))
      {
        bounds.push_back(
            {sure_bounds(world.bodies()[i], world.scene().bodies[i]), static_cast<int>(i)});
      }
    }
    tree_.build(bounds);
  }

  /// The body that a ray meets first, of those for which `asked(id)`, the one with the least
  /// id of several; nothing if none. InvalidShape if the ray is none.
  template <class Asked = decltype(everybody)>
  std::optional<BodyHit> cast(const Ray<double>& ray, const Asked& asked = everybody) const
  {
    checked(ray);
    const double endless = std::numeric_limits<double>::infinity();
    return first_met<BodyHit>(
        ray, 0, endless, asked, [](const Hit<double, 3>& hit) { return hit.t; },
        [&](const auto& shape) { return cookbook::cast(ray, shape); });
  }

  /// The body that a ball meets first which is moved by a way [m], world, of those for which
  /// `asked(id)`, the one with the least id of several; nothing if none, or if there is no
  /// way to go. One that it overlaps is met at once, if the way leads deeper into it. InvalidShape
  /// if the ball is none, or the way not finite.
  template <class Asked = decltype(everybody)>
  std::optional<BallHit>
  cast(const Sphere<double>& ball, const Vector3<double>& way, const Asked& asked = everybody) const
  {
    checked(ball);
    check_finite("way", way);
    return first_met<BallHit>(
        {ball.center, way}, ball.radius, 1, asked,
        [](const SweptHit<double>& hit) { return hit.time; },
        [&](const auto& shape) { return sweep(ball, way, shape); });
  }

  /// The ids of all bodies that a ball or a box overlaps or touches, the least first;
  /// InvalidShape if it is none.
  template <class Shape>
  std::vector<BodyId> overlapping(const Shape& shape) const
  {
    static_assert(
        std::is_same_v<Shape, Sphere<double>> || std::is_same_v<Shape, Obb<double>>,
        "a ball is a Sphere<double>, a box an Obb<double>");
    checked(shape);
    const Eigen::AlignedBox<double, 3> around = bounds_of(shape);
    std::vector<BodyId> found;
    each_that(
        tree_, [&](const Eigen::AlignedBox<double, 3>& box) { return box.intersects(around); },
        [&](int body)
        {
          const auto meets = [&](const auto& of) { return overlaps(placed(at(body), of), shape); };
          if (world_.has(id_of(body)) && std::visit(meets, shape_of(body)))
          {
            found.push_back(id_of(body));
          }
        });
    std::sort(found.begin(), found.end());
    return found;
  }

private:
  static auto sweep(const Sphere<double>& ball, const Vector3<double>& way, const Obb<double>& box)
  {
    return swept_sphere_box(ball, way, box);
  }
  static auto
  sweep(const Sphere<double>& ball, const Vector3<double>& way, const Plane<double>& plane)
  {
    return swept_sphere_plane(ball, way, plane);
  }
  static auto
  sweep(const Sphere<double>& ball, const Vector3<double>& way, const Sphere<double>& other)
  {
    return swept_sphere_sphere(ball, way, other);
  }

  /// The first of all hits of something that goes along a ray and is as thick as a radius [m], for
  /// up to so many lengths of the ray: `when` a hit is, `meet` a shape where it is.
  template <class Met, class Asked, class When, class Meet>
  std::optional<Met> first_met(
      const Ray<double>& ray, double radius, double lengths, const Asked& asked, const When& when,
      const Meet& meet) const
  {
    std::optional<Met> first;
    RayForBoxes<double> thick = ray_for_boxes(ray, tree_.finite_box());
    for (int i = 0; i < 3; ++i)
    {
      thick.little[i] += std::copysign(radius, thick.little[i]);
    }
    const double longest = ray.direction.cwiseAbs().maxCoeff();
    const auto may_come_first = [&](const Eigen::AlignedBox<double, 3>& box)
    {
      const double enter = ray_enters_box(thick, box);
      return enter < std::numeric_limits<double>::infinity() &&
             enter <= (first ? when(first->hit) : lengths) * longest * (1 + 1e-12);
    };
    const auto ask = [&](int body)
    {
      const BodyId id = id_of(body);
      if (!world_.has(id) || !asked(id))
      {
        return;
      }
      const auto hit = std::visit(
          [&](const auto& shape) { return meet(placed(at(body), shape)); }, shape_of(body));
      const auto sooner = [&](const Met& other)
      { return std::pair(when(*hit), id) < std::pair(when(other.hit), other.body); };
      if (hit && (!first || sooner(*first)))
      {
        first = Met{id, *hit};
      }
    };
    each_that(tree_, may_come_first, ask);
    return first;
  }

  BodyId id_of(int body) const { return world_.id(place_of(body)); }
  const RigidBody& at(int body) const { return world_.bodies()[place_of(body)]; }
  const decltype(SceneBody::shape)& shape_of(int body) const
  {
    return world_.scene().bodies[place_of(body)].shape;
  }

  const GameWorld& world_;
  BoundsTree tree_;
};
// [world_queries]

} // namespace cookbook
