#pragma once

/// \file
/// \brief The check that a shape's numbers make sense.

#include "02_primitives/shapes/shapes.hpp"
#include "common/math/rotation.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace cookbook
{

/// What a shape with impossible numbers is answered with; `member()` is the number's name.
class InvalidShape : public std::invalid_argument
{
public:
  /// Names the member, what it must be, and what it is.
  InvalidShape(std::string member, const std::string& must, const std::string& is)
      : std::invalid_argument(member + " must be " + must + ", got " + is),
        member_(std::move(member))
  {
  }

  /// The member at fault, for example `radius` or `half_extents.y`.
  const std::string& member() const { return member_; }

private:
  std::string member_;
};

/// A number as the shortest text that reads back as the same number.
template <class Real>
std::string text_of(Real value)
{
  char text[64];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

/// Throws InvalidShape unless the number is finite.
template <class Real>
void check_finite(const std::string& member, Real value)
{
  if (!std::isfinite(value))
  {
    throw InvalidShape(member, "finite", text_of(value));
  }
}

/// Throws InvalidShape unless all components, two or three, are finite.
template <class Real, int Size>
void check_finite(const std::string& member, const Vector<Real, Size>& value)
{
  const char* const names[] = {".x", ".y", ".z"};
  for (int i = 0; i < Size; ++i)
  {
    check_finite(member + names[i], value[i]);
  }
}

/// Throws InvalidShape unless the radius is finite and not negative.
template <class Real>
void check_radius(Real radius)
{
  check_finite("radius", radius);
  if (radius < Real(0))
  {
    throw InvalidShape("radius", "zero or more", text_of(radius));
  }
}

// [checked]
/// The sphere itself, or InvalidShape if its center or radius cannot be a sphere's.
template <class Real>
const Sphere<Real>& checked(const Sphere<Real>& sphere)
{
  check_finite("center", sphere.center);
  check_radius(sphere.radius);
  return sphere;
}
// [checked]

/// The box itself, or InvalidShape: half extents must be positive, axes orthonormal to 1e-4.
///
/// The bound 1e-4 is far above what rounding to float leaves (about 1e-7) and far below what a
/// scaled or sheared matrix shows.
template <class Real>
const Obb<Real>& checked(const Obb<Real>& box)
{
  check_finite("center", box.center);
  check_finite("half_extents", box.half_extents);
  const char* const names[] = {"half_extents.x", "half_extents.y", "half_extents.z"};
  for (int i = 0; i < 3; ++i)
  {
    if (!(box.half_extents[i] > Real(0)))
    {
      throw InvalidShape(names[i], "greater than zero", text_of(box.half_extents[i]));
    }
  }
  const Real error = rotation_error(box.axes);
  if (!(error <= Real(1e-4)))
  {
    throw InvalidShape("axes", "a rotation", "an error of " + text_of(error));
  }
  return box;
}

/// The plane itself, or InvalidShape: the normal must have length one to 1e-4.
template <class Real>
const Plane<Real>& checked(const Plane<Real>& plane)
{
  check_finite("normal", plane.normal);
  check_finite("distance", plane.distance);
  const Real length = plane.normal.norm();
  if (std::abs(length - Real(1)) > Real(1e-4))
  {
    throw InvalidShape("normal", "of length one", "length " + text_of(length));
  }
  return plane;
}

/// The capsule itself, or InvalidShape; a segment of length zero is allowed, it makes a sphere.
template <class Real>
const Capsule<Real>& checked(const Capsule<Real>& capsule)
{
  check_finite("start", capsule.segment.start);
  check_finite("end", capsule.segment.end);
  check_radius(capsule.radius);
  return capsule;
}

} // namespace cookbook
