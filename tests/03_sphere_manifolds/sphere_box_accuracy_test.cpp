/// \file
/// How far float is from the truth over a million random spheres and boxes in each of five worlds,
/// with the sphere's centre outside, inside and near the surface. The truth is that of the very box
/// that the floats describe.

#include "tests/03_sphere_manifolds/accuracy.hpp"

#include "03_sphere_manifolds/sphere_box/sphere_box.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

namespace
{

struct SphereAndBox
{
  Sphere<double> sphere;
  Obb<double> box;
};

Matrix3<double> random_axes(Random& random)
{
  const int w = random.whole(1, 9);
  const int x = random.whole(-9, 9);
  const int y = random.whole(-9, 9);
  return rational_rotation<double>(w, x, y, random.whole(-9, 9));
}

/// A box, and a sphere whose centre is as likely outside as inside, often close to the surface.
SphereAndBox random_pair(Random& random, double ratio)
{
  const Vector3<double> half(
      random.between(0.05, 1), random.between(0.05, 1), random.between(0.05, 1));
  const Obb<double> box{random.in_cube(1), random_axes(random), half};
  const double radius = ratio * random.between(0.05, 1);
  Vector3<double> local = random.in_cube(1).cwiseProduct(half);
  const int axis = random.whole(0, 2);
  if (!random.one_in(3))
  {
    const double side = random.one_in(2) ? 1 : -1;
    local[axis] = side * (half[axis] + radius * random.between(-0.5, 1.2));
  }
  return {{box.center + box.axes * local, radius}, box};
}

/// The truth from the definition: the closest point, or the nearest face.
template <class Real>
TrueOverlap<Real>
true_overlap(const Vector3<Real>& center, const Real& radius, const Obb<Real>& box)
{
  const Vector3<Real> to_center = center - box.center;
  Vector3<Real> way = Vector3<Real>::Zero(); // from the box to the centre
  Real inset = box.half_extents.maxCoeff() * 2;
  Vector3<Real> face_normal = way;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3<Real> axis = box.axes.col(i);
    const Real along = axis.dot(to_center);
    using std::abs;
    const Real beyond = abs(along) - box.half_extents[i];
    const Real side = along < Real(0) ? Real(-1) : Real(1);
    if (beyond > Real(0))
    {
      way[i] = side * beyond;
    }
    if (-beyond < inset)
    {
      inset = -beyond;
      face_normal = side * axis;
    }
  }
  using std::sqrt;
  const Real distance = sqrt(way.squaredNorm());
  if (distance == Real(0))
  {
    return {-face_normal, radius + inset, box.half_extents.maxCoeff() + radius};
  }
  return {box.axes * way / -distance, radius - distance, distance};
}

template <class Wider>
Obb<Wider> exactly(const Obb<float>& box)
{
  return {exact<Wider>(box.center), box.axes.cast<Wider>(), exact<Wider>(box.half_extents)};
}

/// What the errors are measured in: the largest length that takes part.
float size_of(const Sphere<float>& sphere, const Obb<float>& box)
{
  return std::max(sphere.radius, box.half_extents.maxCoeff());
}

Accuracy accuracy_of_float(double scale, double ratio)
{
  Random random(2);
  Accuracy accuracy;
  for (int i = 0; i < pairs_per_world; ++i)
  {
    const SphereAndBox pair = random_pair(random, ratio);
    const Sphere<float> sphere = rounded(pair.sphere, scale);
    const Obb<float> box = rounded(pair.box, scale);
    accuracy.compare(
        sphere_box(sphere, box), size_of(sphere, box),
        [&](auto real)
        {
          using Real = decltype(real);
          return true_overlap<Real>(
              exact<Real>(sphere.center), Real(sphere.radius), exactly<Real>(box));
        });
  }
  return accuracy;
}

} // namespace

TEST_CASE("sphere and box in float answer within 4 ulp at the scale of metres", "[S7][S8]")
{
  expect_within_4_ulp(accuracy_of_float(1, 1));
}

TEST_CASE("sphere and box in float answer within 4 ulp at the scale of millimetres", "[S7][S8]")
{
  expect_within_4_ulp(accuracy_of_float(1e-3, 1));
}

TEST_CASE("sphere and box in float answer within 4 ulp at the scale of kilometres", "[S7][S8]")
{
  expect_within_4_ulp(accuracy_of_float(1e3, 1));
}

TEST_CASE("a sphere a million times smaller than the box is answered within 4 ulp", "[S7][S8]")
{
  expect_within_4_ulp(accuracy_of_float(1e3, 1e-6));
}

TEST_CASE(
    "relative to the box, sphere and box answer within 4 ulp a million metres away", "[S7][S8]")
{
  Random random(2);
  Accuracy accuracy;
  const Vector3<double> distant(1e6, 1e6, 1e6);
  for (int i = 0; i < pairs_per_world; ++i)
  {
    SphereAndBox pair = random_pair(random, 1);
    pair.sphere.center += distant;
    pair.box.center += distant;
    const float radius = rounded(pair.sphere.radius);
    const Obb<float> box = rounded(pair.box, 1);
    accuracy.compare(
        sphere_box_relative<float>(
            pair.box.center - pair.sphere.center, radius, box.axes, box.half_extents),
        size_of({{0, 0, 0}, radius}, box),
        [&](auto real)
        {
          using Real = decltype(real);
          Obb<Real> true_box = exactly<Real>(box);
          true_box.center = exact<Real>(pair.box.center);
          return true_overlap<Real>(exact<Real>(pair.sphere.center), Real(radius), true_box);
        });
  }
  expect_within_4_ulp(accuracy);
}
