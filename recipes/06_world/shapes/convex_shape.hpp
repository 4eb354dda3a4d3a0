#pragma once

/// \file
/// \brief Any convex shape with six functions, as the shape of a body.

#include "06_world/shapes/shape_answers.hpp"

#include <concepts>
#include <memory>
#include <optional>

namespace cookbook
{

// [shape_concepts]
/// The six functions of a shape, each asked for by name where the shape is used. All but bounds()
/// are about a shape in its own frame, with the centre of mass at the origin and the principal axes
/// of inertia along x, y and z.
template <class Shape>
concept HasBounds = requires(const Shape& shape, const Pose& pose)
{
  {
    bounds(shape, pose)
    } -> std::convertible_to<Eigen::AlignedBox<double, 3>>;
};
template <class Shape>
concept HasSupport = requires(const Shape& shape, const Vector3<double>& direction)
{
  {
    support(shape, direction)
    } -> std::convertible_to<Vector3<double>>;
};
template <class Shape>
concept HasMassProperties = requires(const Shape& shape, double mass)
{
  {
    mass_properties(shape, mass)
    } -> std::convertible_to<MassProperties<double>>;
};
template <class Shape>
concept HasExtent = requires(const Shape& shape)
{
  {
    extent(shape)
    } -> std::convertible_to<Extent>;
};
template <class Shape>
concept HasDistance = requires(const Shape& shape, const Vector3<double>& point)
{
  {
    distance(shape, point)
    } -> std::convertible_to<Direction<double>>;
};
template <class Shape>
concept HasCast = requires(const Shape& shape, const Ray<double>& ray)
{
  {
    cast(ray, shape)
    } -> std::convertible_to<ShapeHit>;
};
// [shape_concepts]

// [convex_shape]
/// Any convex shape that has the six functions, so that a game brings its own: a body's shape can
/// be made of it, `body.shape = Cylinder{0.2, 0.5}`.
///
/// It never changes, and copies share it.
class ConvexShape
{
public:
  /// Wraps a shape; does not compile where one of its functions is missing.
  template <class Shape>
  ConvexShape(const Shape& shape)
  {
    static_assert(
        HasBounds<Shape>, "this shape has no bounds(shape, pose): its axis-aligned box [m], world");
    static_assert(
        HasSupport<Shape>,
        "this shape has no support(shape, direction): its point [m] farthest along it");
    static_assert(
        HasMassProperties<Shape>,
        "this shape has no mass_properties(shape, mass): its mass [kg] and moments [kg m²]");
    static_assert(
        HasExtent<Shape>, "this shape has no extent(shape): its inner and outer radius [m]");
    static_assert(
        HasDistance<Shape>, "this shape has no distance(shape, point): the direction out of it, "
                            "and how far its surface is [m]");
    static_assert(
        HasCast<Shape>,
        "this shape has no cast(ray, shape): where a ray first meets it, if it does");
    if constexpr (
        HasBounds<Shape> && HasSupport<Shape> && HasMassProperties<Shape> && HasExtent<Shape> &&
        HasDistance<Shape> && HasCast<Shape>)
    {
      functions_ = std::make_shared<FunctionsOf<Shape>>(shape);
    }
  }

  /// The bounds [m], world, of the shape at a place.
  friend Eigen::AlignedBox<double, 3> bounds(const ConvexShape& shape, const Pose& pose)
  {
    return shape.functions_->bounds_at(pose);
  }
  /// A point [m] of the shape farthest along a direction of any length but zero.
  friend Vector3<double> support(const ConvexShape& shape, const Vector3<double>& direction)
  {
    return shape.functions_->support_along(direction);
  }
  /// Mass [kg] and principal moments [kg m²] of the shape.
  friend MassProperties<double> mass_properties(const ConvexShape& shape, double mass)
  {
    return shape.functions_->mass_properties_of(mass);
  }
  /// How far the shape reaches.
  friend Extent extent(const ConvexShape& shape) { return shape.functions_->extent_of(); }
  /// The direction out of the shape at a point [m], and how far that is from its surface [m];
  /// negative inside.
  friend Direction<double> distance(const ConvexShape& shape, const Vector3<double>& point)
  {
    return shape.functions_->distance_to(point);
  }
  /// Where a ray first meets the shape; from inside at its start, with the normal against it.
  friend ShapeHit cast(const Ray<double>& ray, const ConvexShape& shape)
  {
    return shape.functions_->cast_along(ray);
  }

private:
  struct Functions
  {
    virtual ~Functions() = default;
    virtual Eigen::AlignedBox<double, 3> bounds_at(const Pose& pose) const = 0;
    virtual Vector3<double> support_along(const Vector3<double>& direction) const = 0;
    virtual MassProperties<double> mass_properties_of(double mass) const = 0;
    virtual Extent extent_of() const = 0;
    virtual Direction<double> distance_to(const Vector3<double>& point) const = 0;
    virtual ShapeHit cast_along(const Ray<double>& ray) const = 0;
  };

  template <class Shape>
  struct FunctionsOf final : Functions
  {
    explicit FunctionsOf(const Shape& wrapped) : shape(wrapped) {}

    Eigen::AlignedBox<double, 3> bounds_at(const Pose& pose) const override
    {
      return bounds(shape, pose);
    }
    Vector3<double> support_along(const Vector3<double>& direction) const override
    {
      return support(shape, direction);
    }
    MassProperties<double> mass_properties_of(double mass) const override
    {
      return mass_properties(shape, mass);
    }
    Extent extent_of() const override { return extent(shape); }
    Direction<double> distance_to(const Vector3<double>& point) const override
    {
      return distance(shape, point);
    }
    ShapeHit cast_along(const Ray<double>& ray) const override { return cast(ray, shape); }

    Shape shape;
  };

  std::shared_ptr<const Functions> functions_;
};
// [convex_shape]

} // namespace cookbook
