#pragma once

/// \file
/// \brief Ways to carry a plane along, and transforms that break them.

#include "01_math/matrices/trial/matrix_instances.hpp"
#include "01_math/transforms/transforms.hpp"

#include <array>
#include <string>
#include <vector>

namespace cookbook
{

/// A transform from its matrix and its move.
inline Affine3<float> affine(const Matrix3<float>& m, const Vector3<float>& move)
{
  Affine3<float> t = Affine3<float>::Identity();
  t.linear() = m;
  t.translation() = move;
  return t;
}

/// The turn about z with cosine 4/5 and sine 3/5, each rounded once.
inline Matrix3<float> turned_345()
{
  return rows<float>({0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1});
}

/// A way to carry a plane along, by name.
struct PlaneMethod
{
  std::string name; ///< as on the page
  Hyperplane3<float> (*carry)(
      const Affine3<float>& t, const Hyperplane3<float>& plane); ///< the way
};

/// Our model of the seed's code, X35: the normal is turned, the distance stays.
inline Hyperplane3<float>
plane_as_published(const Affine3<float>& t, const Hyperplane3<float>& plane)
{
  return Hyperplane3<float>(Vector3<float>(t.linear() * plane.normal()), plane.offset());
}

/// The normal sent through the matrix as if it were a vector.
inline Hyperplane3<float> plane_by_matrix(const Affine3<float>& t, const Hyperplane3<float>& plane)
{
  const Vector3<float> n = plane.normal(), point = t * Vector3<float>(-plane.offset() * n);
  return Hyperplane3<float>(normalize<float>(t.linear() * n).unit, point);
}

/// Eigen's own function, which inverts the matrix.
inline Hyperplane3<float> plane_by_eigen(const Affine3<float>& t, const Hyperplane3<float>& plane)
{
  Hyperplane3<float> carried = plane;
  carried.transform(t);
  return carried;
}

/// The ways that compete, the recommended one last.
inline std::array<PlaneMethod, 4> plane_methods()
{
  return {
      {{"as published", plane_as_published},
       {"n by M", plane_by_matrix},
       {"Eigen's transform", plane_by_eigen},
       {"recommended", transformed_plane<float>}}};
}

/// A transform that some way does not survive; the plane is always 2x + y + 2z = 6.
struct PlaneCase
{
  std::string id;   ///< in the book; empty for a neighbour of the case above
  std::string what; ///< the transform, in a few words
  Affine3<float> t; ///< the transform
};

/// The plane.
inline const Hyperplane3<float> ramp(Vector3<float>(2.0f / 3, 1.0f / 3, 2.0f / 3), -2.0f);

/// The transforms to try on the plane.
inline std::vector<PlaneCase> plane_cases()
{
  const Vector3<float> none(0, 0, 0), move(5, -1, 2);
  const auto scale = [](float x, float y, float z)
  { return Matrix3<float>(Vector3<float>(x, y, z).asDiagonal()); };
  return {
      {"X35", "moved by (5, −1, 2)", affine(scale(1, 1, 1), move)},
      {"", "turned about z", affine(turned_345(), none)},
      {"", "turned, then moved", affine(turned_345(), move)},
      {"", "Scale(2, 2, 2)", affine(scale(2, 2, 2), none)},
      {"", "Scale(1, 1, 4)", affine(scale(1, 1, 4), none)},
      {"", "sheared along x", affine(rows<float>({1, 0.5, 0, 0, 1, 0, 0, 0, 1}), move)},
      {"", "mirrored in x", affine(scale(-1, 1, 1), move)},
      {"", "Scale(1e-20)", affine(scale(1e-20f, 1e-20f, 1e-20f), none)},
      {"", "flattened to z = 0", affine(scale(1, 1, 0), none)}};
}

/// What is right within this many roundings is right.
inline constexpr double allowed_in_transforms = 16;

} // namespace cookbook
