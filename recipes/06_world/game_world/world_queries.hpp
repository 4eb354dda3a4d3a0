#pragma once

/// \file
/// \brief What a ray or a ball meets first among the bodies of a world, and what a shape overlaps.

#include "02_primitives/casts/casts.hpp"
#include "02_primitives/meshes/ray_enters_box.hpp"
#include "02_primitives/overlaps/overlaps.hpp"
#include "02_primitives/shape_bounds/shape_bounds.hpp"
#include "02_primitives/shapes/checked_more_shapes.hpp"
#include "06_world/contacts/near_shapes.hpp"
#include "06_world/contacts/tree_overlaps.hpp"
#include "06_world/game_world/game_world.hpp"
#include "06_world/shapes/sphere_sweep.hpp"

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
  BodyId body;        ///< which it is
  Hit<double, 3> hit; ///< where, as chapter 2's casts say
};

/// What a ball that is moved has met.
struct SphereHit
{
  BodyId body;          ///< which it is
  SweptHit<double> hit; ///< which fraction of the way is free, and the normal: out of the ball,
                        ///< into the body, where that of a ray's hit points out of the body
};

/// Bounds of a body that hold it in spite of rounding; infinite for a plane.
inline Eigen::AlignedBox<double, 3> conservative_bounds(const RigidBody& body, const SceneBody& of)
{
  const Eigen::AlignedBox<double, 3> box = bounds_of(body, of.shape, 0);
  const double largest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  const Vector3<double> padding =
      Vector3<double>::Constant(8 * std::numeric_limits<double>::epsilon() * largest);
  return {box.min() - padding, box.max() + padding};
}

/// Asks every body.
inline constexpr auto every_body = [](BodyId) { return true; };

/// Ray casts, sphere casts and overlap tests against the bodies of a world as they are now. It is
/// made anew after a step, or once a body was added or teleported; removed bodies are skipped.
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
            {conservative_bounds(world.bodies()[i], world.scene().bodies[i]), static_cast<int>(i)});
      }
    }
    tree_.build(bounds);
  }

  /// The first body that a ray hits, of those for which `filter(id)`, the least id of several.
  template <class Filter = decltype(every_body)>
  std::optional<BodyHit> cast(const Ray<double>& ray, const Filter& filter = every_body) const
  {
    checked(ray);
    const double unbounded = std::numeric_limits<double>::infinity();
    return first_hit<BodyHit>(
        ray, 0, unbounded, filter, [](const Hit<double, 3>& hit) { return hit.t; },
        [&](const auto& shape) { return cookbook::cast(ray, shape); });
  }

  /// The body that a ball meets first which is moved by a way [m], world, of those for which
  /// `filter(id)`, the one with the least id of several; nothing if none, or if there is no
  /// way to go. One that it overlaps is met at once, if the way leads deeper into it. InvalidShape
  /// if the ball is none, or the way not finite.
  template <class Filter = decltype(every_body)>
  std::optional<SphereHit> cast(
      const Sphere<double>& sphere, const Vector3<double>& displacement,
      const Filter& filter = every_body) const
  {
    checked(sphere);
    check_finite("displacement", displacement);
    return first_hit<SphereHit>(
        {sphere.center, displacement}, sphere.radius, 1, filter,
        [](const SweptHit<double>& hit) { return hit.time; },
        [&](const auto& shape) { return sweep(sphere, displacement, shape); });
  }

  /// The ids of all bodies that a sphere or a box overlaps or touches, the least first.
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
          const auto overlap = [&](const auto& of)
          { return overlaps(placed(at(body), of), shape); };
          if (world_.has(id_of(body)) && std::visit(overlap, shape_of(body)))
          {
            found.push_back(id_of(body));
          }
        });
    std::sort(found.begin(), found.end());
    return found;
  }

private:
  /// The first hit of a sphere of a radius [m] along a ray, up to so many lengths of the ray.
  template <class Found, class Filter, class When, class Meet>
  std::optional<Found> first_hit(
      const Ray<double>& ray, double radius, double lengths, const Filter& filter, const When& when,
      const Meet& query) const
  {
    std::optional<Found> first;
    RayForBoxes<double> thick = ray_for_boxes(ray, tree_.finite_box());
    for (int i = 0; i < 3; ++i)
    {
      thick.little[i] += std::copysign(radius, thick.little[i]);
    }
    const double longest = ray.direction.cwiseAbs().maxCoeff();
    const auto may_come_first = [&](const Eigen::AlignedBox<double, 3>& box)
    {
      const double add_body = ray_enters_box(thick, box);
      return add_body < std::numeric_limits<double>::infinity() &&
             add_body <= (first ? when(first->hit) : lengths) * longest * (1 + 1e-12);
    };
    const auto test = [&](int body)
    {
      const BodyId id = id_of(body);
      if (!world_.has(id) || !filter(id))
      {
        return;
      }
      const auto hit = std::visit(
          [&](const auto& shape) { return query(placed(at(body), shape)); }, shape_of(body));
      const auto sooner = [&](const Found& other)
      { return std::pair(when(*hit), id) < std::pair(when(other.hit), other.body); };
      if (hit && (!first || sooner(*first)))
      {
        first = Found{id, *hit};
      }
    };
    each_that(tree_, may_come_first, test);
    return first;
  }

  BodyId id_of(int body) const { return world_.id(index_of(body)); }
  const RigidBody& at(int body) const { return world_.bodies()[index_of(body)]; }
  const Shape& shape_of(int body) const { return world_.scene().bodies[index_of(body)].shape; }

  const GameWorld& world_;
  BoundsTree tree_;
};
// [world_queries]

} // namespace cookbook
