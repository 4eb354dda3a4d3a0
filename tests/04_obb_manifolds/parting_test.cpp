/// \file
/// The promise of every manifold: once B has moved by its depth along its normal, the two shapes no
/// longer overlap. For all pairs of shapes of chapters 3 and 4, degenerate ones among them.

#include "03_sphere_manifolds/sphere_box/sphere_box.hpp"
#include "03_sphere_manifolds/sphere_capsule/sphere_capsule.hpp"
#include "03_sphere_manifolds/sphere_plane/sphere_plane.hpp"
#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"
#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_overlap_truth.hpp"
#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "04_obb_manifolds/edge_clipping/edge_clipping.hpp"
#include "04_obb_manifolds/face_clipping/face_clipping.hpp"
#include "04_obb_manifolds/gjk_epa/gjk_epa.hpp"
#include "common/math/rational.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <limits>

using namespace cookbook;

namespace
{

// [parting]
/// Draws shapes that like to be degenerate: half of all numbers are multiples of a quarter, so that
/// centres meet, surfaces touch and lengths are zero; sizes go from a millimetre to a kilometre.
class ShapeDraw
{
public:
  explicit ShapeDraw(std::uint32_t seed) : draw_(seed) {}

  /// The unit of length [m] of the next pair, and how far from the origin it is.
  void next_pair()
  {
    unit_ = std::ldexp(1.0, draw_.whole(21) - 10);
    on_lattice_ = draw_.whole(2) == 0;
    origin_ = draw_.whole(4) == 0 ? 64 * unit_ * in_cube(1) : Vector3<double>(0, 0, 0);
  }
  double length(double most) { return unit_ * std::abs(number(most)); }
  Vector3<double> center() { return origin_ + unit_ * in_cube(1); }
  Matrix3<double> axes()
  {
    return draw_.whole(4) == 0 ? Matrix3<double>(Matrix3<double>::Identity()) : draw_.rotation();
  }
  Vector3<double> direction()
  {
    return draw_.whole(3) == 0
               ? Vector3<double>(draw_.side() * Vector3<double>::Unit(draw_.whole(3)))
               : draw_.direction();
  }
  Sphere<double> sphere() { return {center(), length(1)}; }
  Obb<double> box()
  {
    const Vector3<double> corner = unit_ * (in_cube(1) + in_cube(0.25));
    return {center(), axes(), corner.cwiseAbs()};
  }
  /// A capsule: of no length, along an axis, or anyhow.
  Capsule<double> capsule()
  {
    const Vector3<double> start = center();
    const Vector3<double> along = length(2) * direction();
    return {{start, start + along}, length(0.5)};
  }
  /// A point of a segment, as well as it can be written down.
  Vector3<double> on(const Segment<double>& segment)
  {
    const double share = std::clamp(draw_.between(-0.25, 1.25), 0.0, 1.0);
    return segment.start + share * (segment.end - segment.start);
  }
  bool one_in(int n) { return draw_.whole(n) == 0; }

private:
  double number(double most)
  {
    const double any = draw_.between(-most, most);
    return on_lattice_ ? std::round(4 * any) / 4 : any;
  }
  Vector3<double> in_cube(double half)
  {
    const double x = number(half), y = number(half);
    return {x, y, number(half)};
  }

  BoxDraw draw_;
  double unit_ = 1;
  bool on_lattice_ = false;
  Vector3<double> origin_ = Vector3<double>::Zero();
};

/// How far [m] two shapes are apart once B has moved by a vector [m], in a hundred digits;
/// negative: they overlap.
template <class Real>
Reference gap_after(const Sphere<Real>& a, const Sphere<Real>& b, const Vector3<Reference>& move)
{
  const Vector3<Reference> way = exact<Reference>(b.center) + move - exact<Reference>(a.center);
  return way.norm() - Reference(a.radius) - Reference(b.radius);
}

template <class Real>
Reference gap_after(const Sphere<Real>& a, const Plane<Real>& b, const Vector3<Reference>& move)
{
  const Vector3<Reference> normal = exact<Reference>(b.normal);
  return normal.dot(exact<Reference>(a.center) - move) - Reference(b.distance) -
         Reference(a.radius);
}

template <class Real>
Reference gap_after(const Sphere<Real>& a, const Capsule<Real>& b, const Vector3<Reference>& move)
{
  const Vector3<Reference> start = exact<Reference>(b.segment.start) + move;
  const Vector3<Reference> along = exact<Reference>(b.segment.end) + move - start;
  const Vector3<Reference> from_start = exact<Reference>(a.center) - start;
  const Reference squared = along.squaredNorm(), shadow = from_start.dot(along);
  const Reference t = squared == 0 ? Reference(0) : std::clamp<Reference>(shadow / squared, 0, 1);
  return (from_start - t * along).norm() - Reference(a.radius) - Reference(b.radius);
}

template <class Real>
Reference gap_after(const Sphere<Real>& a, const Obb<Real>& b, const Vector3<Reference>& move)
{
  const Vector3<Reference> from = exact<Reference>(a.center) - exact<Reference>(b.center) - move;
  const Vector3<Reference> local = b.axes.template cast<Reference>().transpose() * from;
  const Vector3<Reference> half = exact<Reference>(b.half_extents);
  const Reference inside = (half - local.cwiseAbs()).minCoeff();
  const Vector3<Reference> outside = local - local.cwiseMax(-half).cwiseMin(half);
  return (inside > 0 ? Reference(-inside) : outside.norm()) - Reference(a.radius);
}

template <class Real>
Reference gap_after(const Obb<Real>& a, const Obb<Real>& b, const Vector3<Reference>& move)
{
  Obb<Reference> from = box_in<Reference>(a), to = box_in<Reference>(b);
  to.center += move;
  return -true_depth(true_least_overlap(from, to));
}

/// The largest number of a pair [m], of which rounding takes its share.
template <class Real, class B>
Real size_of(const Sphere<Real>& a, const B& b)
{
  return std::max(largest(a), largest(b));
}

template <class Real>
Real size_of(const Obb<Real>& a, const Obb<Real>& b)
{
  return a.center.cwiseAbs().maxCoeff() + b.center.cwiseAbs().maxCoeff() + a.half_extents.sum() +
         b.half_extents.sum();
}

/// What was seen of many pairs.
struct Partings
{
  int asked = 0;
  int touching = 0;
  int not_unit = 0;   ///< normals that are not of length one
  double deepest = 0; ///< [ε of the pair's size], overlap that was left

  template <class A, class B, class Real, std::size_t Most>
  void add(const A& a, const B& b, const std::optional<Manifold<Real, Most>>& manifold)
  {
    ++asked;
    if (!manifold)
    {
      return;
    }
    ++touching;
    const Real epsilon = std::numeric_limits<Real>::epsilon();
    not_unit += std::abs(manifold->normal.norm() - 1) < 8 * epsilon ? 0 : 1;
    const Real unit = epsilon * size_of(a, b);
    const Vector3<Reference> normal = exact<Reference>(manifold->normal);
    const Reference left = -gap_after(a, b, normal * Reference(manifold->depth));
    deepest = std::max(deepest, left > 0 ? double(left / Reference(unit)) : 0);
  }

  /// No more is left than a few roundings.
  void check(double roundings) const
  {
    CAPTURE(asked, touching, deepest);
    CHECK(touching > asked / 3);
    CHECK(touching < asked);
    CHECK(not_unit == 0);
    CHECK(deepest <= roundings);
  }
};
// [parting]

#ifdef COOKBOOK_FEWER_PAIRS
constexpr int pairs = 1'000;
#else
constexpr int pairs = 20'000;
#endif

template <class Real>
Sphere<Real> in(const Sphere<double>& s)
{
  return {s.center.cast<Real>(), Real(s.radius)};
}

template <class Real>
Capsule<Real> in(const Capsule<double>& c)
{
  return {{c.segment.start.cast<Real>(), c.segment.end.cast<Real>()}, Real(c.radius)};
}

} // namespace

// [parting_spheres]
TEMPLATE_TEST_CASE(
    "20,000 balls and capsules, centres on each other's among them, part by their depth",
    "[S5][case:C3]", float, double)
{
  ShapeDraw draw(5);
  Partings spheres, capsules;
  for (int i = 0; i < pairs; ++i)
  {
    draw.next_pair();
    const Sphere<double> a = draw.sphere();
    Sphere<double> b = draw.sphere();
    b.center = draw.one_in(4) ? a.center : b.center;
    spheres.add(in<TestType>(a), in<TestType>(b), sphere_sphere(in<TestType>(a), in<TestType>(b)));
    Sphere<double> ball = draw.sphere();
    const Capsule<double> capsule = draw.capsule();
    ball.center = draw.one_in(2) ? draw.on(capsule.segment) : ball.center;
    capsules.add(
        in<TestType>(ball), in<TestType>(capsule),
        sphere_capsule(in<TestType>(ball), in<TestType>(capsule)));
  }
  spheres.check(8);
  capsules.check(8);
}

TEMPLATE_TEST_CASE(
    "20,000 balls part from planes and boxes by their depth", "[S5][S8]", float, double)
{
  using Real = TestType;
  ShapeDraw draw(6);
  Partings planes, boxes;
  for (int i = 0; i < pairs; ++i)
  {
    draw.next_pair();
    const Sphere<Real> ball = in<Real>(draw.sphere());
    const Vector3<Real> normal = draw.direction().cast<Real>();
    const Plane<Real> plane{normal, normal.dot(draw.center().cast<Real>())};
    planes.add(ball, plane, sphere_plane(ball, plane));
    Sphere<double> beside = draw.sphere();
    const Obb<double> box = draw.box();
    beside.center = draw.one_in(8) ? box.center : beside.center;
    const Obb<Real> b = box_in<Real>(box);
    boxes.add(in<Real>(beside), b, sphere_box(in<Real>(beside), b));
  }
  planes.check(8);
  boxes.check(16);
}
// [parting_spheres]

// [parting_boxes]
TEMPLATE_TEST_CASE(
    "20,000 boxes, equal, contained and flat ones among them, part by their depth", "[O5][case:G5]",
    float, double)
{
  using Real = TestType;
  ShapeDraw draw(7);
  Partings recommended, edges, faces, gjk;
  for (int i = 0; i < pairs; ++i)
  {
    draw.next_pair();
    const Obb<double> first = draw.box();
    Obb<double> second = draw.one_in(16) ? first : draw.box();
    second.axes = draw.one_in(4) ? first.axes : second.axes;
    const Obb<Real> a = box_in<Real>(first), b = box_in<Real>(second);
    recommended.add(a, b, box_box(a, b));
    if (i % 8 == 0)
    {
      edges.add(a, b, edge_clipping(a, b));
      faces.add(a, b, face_clipping(a, b));
      gjk.add(a, b, gjk_epa(a, b));
    }
  }
  recommended.check(16);
  edges.check(16);
  faces.check(16);
  gjk.check(64);
}
// [parting_boxes]
