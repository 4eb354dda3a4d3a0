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
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

using namespace cookbook;

namespace
{

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
    const double t = std::clamp(draw_.between(-0.25, 1.25), 0.0, 1.0);
    return segment.start + t * (segment.end - segment.start);
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
Reference
separation_after(const Sphere<Real>& a, const Sphere<Real>& b, const Vector3<Reference>& move)
{
  const Vector3<Reference> way = exact<Reference>(b.center) + move - exact<Reference>(a.center);
  return way.norm() - Reference(a.radius) - Reference(b.radius);
}

template <class Real>
Reference
separation_after(const Sphere<Real>& a, const Plane<Real>& b, const Vector3<Reference>& move)
{
  const Vector3<Reference> normal = exact<Reference>(b.normal);
  return normal.dot(exact<Reference>(a.center) - move) - Reference(b.distance) -
         Reference(a.radius);
}

template <class Real>
Reference
separation_after(const Sphere<Real>& a, const Capsule<Real>& b, const Vector3<Reference>& move)
{
  const Vector3<Reference> start = exact<Reference>(b.segment.start) + move;
  const Vector3<Reference> along = exact<Reference>(b.segment.end) + move - start;
  const Vector3<Reference> from_start = exact<Reference>(a.center) - start;
  const Reference squared = along.squaredNorm(), projection = from_start.dot(along);
  const Reference t =
      squared == 0 ? Reference(0) : std::clamp<Reference>(projection / squared, 0, 1);
  return (from_start - t * along).norm() - Reference(a.radius) - Reference(b.radius);
}

template <class Real>
Reference
separation_after(const Sphere<Real>& a, const Obb<Real>& b, const Vector3<Reference>& move)
{
  const Vector3<Reference> from = exact<Reference>(a.center) - exact<Reference>(b.center) - move;
  const Vector3<Reference> local = b.axes.template cast<Reference>().transpose() * from;
  const Vector3<Reference> half = exact<Reference>(b.half_extents);
  const Reference inside = (half - local.cwiseAbs()).minCoeff();
  const Vector3<Reference> outside = local - local.cwiseMax(-half).cwiseMin(half);
  return (inside > 0 ? Reference(-inside) : outside.norm()) - Reference(a.radius);
}

template <class Real>
Reference separation_after(const Obb<Real>& a, const Obb<Real>& b, const Vector3<Reference>& move)
{
  Obb<Reference> from = box_in<Reference>(a), to = box_in<Reference>(b);
  to.center += move;
  return -true_depth(true_least_overlap(from, to));
}

/// The largest number of a pair [m], of which rounding takes its part.
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
    const Reference left = -separation_after(a, b, normal * Reference(manifold->depth));
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

constexpr int pairs = inputs(20'000, 300);

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

// [separating_boxes]
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
// [separating_boxes]

namespace
{

/// Multiples of a half from -1 to 1 along each axis: with half extents these are the corners of a
/// box, the middles of its edges and faces, its centre, and points between them.
std::vector<Vector3<double>> lattice(double most = 1)
{
  std::vector<Vector3<double>> points;
  for (double x = -most; x <= most; x += 0.5)
  {
    for (double y = -most; y <= most; y += 0.5)
    {
      for (double z = -most; z <= most; z += 0.5)
      {
        points.push_back({x, y, z});
      }
    }
  }
  return points;
}

/// A length and a place [m] that all numbers of a pair are made of.
struct Setting
{
  double unit;
  Vector3<double> origin;

  Vector3<double> at(const Vector3<double>& point) const { return origin + unit * point; }
};

/// Metres, millimetres, and as small and as large as leaves room for squares in double and for
/// sums in float; each at the origin and a thousand times its unit away.
std::vector<Setting> settings()
{
  std::vector<Setting> all;
  const std::vector<double> units{1e-30, 1e30, 1.0, 1e-3};
  for (const double unit : std::span(units).first(inputs<std::size_t>(4, 1)))
  {
    all.push_back({unit, {0, 0, 0}});
    all.push_back({unit, unit * Vector3<double>(1000, -700, 300)});
  }
  return all;
}

/// Along the axes, +y and −y among them, and along 2-3-6.
const Vector3<double> directions[] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                      {0, -1, 0}, {-1, 0, 0}, {2.0 / 7, 3.0 / 7, 6.0 / 7}};

/// Boxes that are cubes, of three lengths, plates, rods and points.
const Vector3<double> half_extents[] = {{1, 1, 1}, {0.5, 1, 2}, {1, 0, 0.5}, {0, 0, 1}, {0, 0, 0}};

} // namespace

TEMPLATE_TEST_CASE(
    "balls in each other's centre, on surfaces, ends, faces, edges and corners part, from 1e-30 to "
    "1e30 m",
    "[S5][S8][case:C3][case:D4]", float, double)
{
  using Real = TestType;
  for (const Setting& set : settings())
  {
    const double unit = set.unit;
    const Vector3<double>& origin = set.origin;
    CAPTURE(unit, origin.x());
    Partings spheres, planes, capsules, boxes;
    for (const double radius : {0.0, 0.25, 1.0, 3.0})
    {
      for (const Vector3<double>& point : lattice())
      {
        const Sphere<Real> ball = in<Real>(Sphere<double>{set.at(point), unit * radius});
        for (const double other : {0.0, 0.5, 1.0})
        {
          const Sphere<Real> b = in<Real>(Sphere<double>{origin, unit * other});
          spheres.add(ball, b, sphere_sphere(ball, b));
        }
        for (const Vector3<double>& direction : directions)
        {
          const Vector3<Real> normal = direction.cast<Real>();
          const Plane<Real> plane{normal, normal.dot(Vector3<Real>(origin.cast<Real>()))};
          planes.add(ball, plane, sphere_plane(ball, plane));
          // Segments of no length too; the ball is on an end of some, and on the middle of others.
          for (const double length : {0.0, 0.5, 1.0})
          {
            const Capsule<Real> capsule =
                in<Real>(Capsule<double>{{origin, set.at(length * direction)}, unit * radius / 4});
            capsules.add(ball, capsule, sphere_capsule(ball, capsule));
          }
        }
      }
      for (const Vector3<double>& half : half_extents)
      {
        for (const Vector3<double>& point : lattice(1.5))
        {
          const Matrix3<double> axes = rational_rotation<double>(1, 2, 3, 4);
          const Vector3<double> on_box = axes * half.cwiseProduct(point);
          const Sphere<Real> ball = in<Real>(Sphere<double>{set.at(on_box), unit * radius / 2});
          const Obb<Real> box = box_in<Real>(Obb<double>{origin, axes, unit * half});
          boxes.add(ball, box, sphere_box(ball, box));
        }
      }
    }
    spheres.check(8);
    planes.check(8);
    capsules.check(8);
    boxes.check(16);
  }
}

TEMPLATE_TEST_CASE(
    "cubes, plates, rods and points, parallel, turned and contained, part, from 1e-30 to 1e30 m",
    "[O5][case:G5][long]", float, double)
{
  using Real = TestType;
  const Matrix3<double> turns[] = {
      rational_rotation<double>(1, 0, 0, 0), rational_rotation<double>(3, 0, 1, 0),
      rational_rotation<double>(30'000, 1, 2, 3), rational_rotation<double>(1, 2, 3, 4)};
  for (const Setting& set : settings())
  {
    const double unit = set.unit;
    const Vector3<double>& origin = set.origin;
    CAPTURE(unit, origin.x());
    Partings axes, edges, faces, recommended, gjk;
    int count = 0;
    for (const Vector3<double>& half_a : half_extents)
    {
      for (const Vector3<double>& half_b : half_extents)
      {
        for (const Matrix3<double>& turn : turns)
        {
          for (const Vector3<double>& point : lattice())
          {
            if (++count % 8 != 0)
            {
              continue; // of 12,500 pairs every eighth
            }
            const Matrix3<double> first = rational_rotation<double>(count % 16, 1, 2, 2);
            const Obb<Real> a = box_in<Real>(Obb<double>{origin, first, unit * half_a});
            const Obb<Real> b =
                box_in<Real>(Obb<double>{set.at(first * point), first * turn, unit * half_b});
            if (const auto least = separating_axes(a, b))
            {
              axes.add(a, b, std::optional(Manifold<Real>{least->normal, least->depth, {}}));
            }
            edges.add(a, b, edge_clipping(a, b));
            faces.add(a, b, face_clipping(a, b));
            recommended.add(a, b, box_box(a, b));
            gjk.add(a, b, gjk_epa(a, b));
          }
        }
      }
    }
    CHECK(axes.deepest <= 16);
    edges.check(16);
    faces.check(16);
    recommended.check(16);
    gjk.check(64);
  }
}

namespace
{

using Exact3 = Vector3<Rational>;

/// Whole vectors of whole length: units in fractions.
std::vector<Direction<Rational>> whole_directions()
{
  std::vector<Direction<Rational>> all;
  for (const auto& [v, length] :
       {std::pair(Exact3(2, 3, 6), 7), std::pair(Exact3(-1, 2, 2), 3),
        std::pair(Exact3(3, 0, -4), 5), std::pair(Exact3(1, -4, 8), 9),
        std::pair(Exact3(0, 1, 0), 1)})
  {
    all.push_back({v / Rational(length), length});
  }
  return all;
}

/// A box in fractions, its corner and its turn out of small whole numbers.
Obb<Rational> whole_box(BoxDraw& draw)
{
  const auto whole = [&](int least, int most)
  { return Rational(least + draw.whole(most - least + 1), 2); };
  const int w = 1 + draw.whole(3), x = draw.whole(3), y = draw.whole(3), z = draw.whole(3);
  const Exact3 center(whole(-2, 2), whole(-2, 2), whole(-2, 2));
  return {center, rational_rotation<Rational>(w, x, y, z), {whole(0, 3), whole(0, 3), whole(0, 3)}};
}

/// Moves B by the least of the fifteen overlaps, along its axis L by overlap L / |L|², which needs
/// no root; nothing where the boxes are apart.
std::optional<Obb<Rational>> parted(const Obb<Rational>& a, Obb<Rational> b)
{
  const RelativeBoxes<Rational> boxes = relative_boxes(a, b);
  std::optional<AxisOverlap<Rational>> least;
  for (int axis = 0; axis < box_axes; ++axis)
  {
    const AxisOverlap<Rational> along = axis_overlap(boxes, axis);
    if (from_parallel_edges(along))
    {
      continue;
    }
    if (along.overlap < 0)
    {
      return std::nullopt;
    }
    const auto square = [](const AxisOverlap<Rational>& o) -> Rational
    { return o.overlap * o.overlap / o.squared_length; };
    least = !least || square(along) < square(*least) ? along : *least;
  }
  const Rational way = (least->offset < 0 ? -1 : 1) * least->overlap / least->squared_length;
  b.center += a.axes * Exact3(least->axis * way);
  return b;
}

} // namespace

TEST_CASE("in fractions balls touch, to the last digit, once they have parted", "[S1][S5][P1][P2]")
{
  for (const Direction<Rational>& along : whole_directions())
  {
    for (int quarters = 0; quarters <= 12; ++quarters)
    {
      const Rational distance(quarters, 4), a(3, 2), b(5, 4);
      const SphereOverlap<Rational> two = sphere_overlap<Rational>({along.unit, distance}, a, b);
      const Exact3 apart = along.unit * distance + two.normal * two.depth;
      CHECK((two.depth < 0 || apart.squaredNorm() == (a + b) * (a + b)));
      const Plane<Rational> plane{along.unit, Rational(1, 3)};
      const Exact3 center = along.unit * (distance - 1);
      const Rational height = signed_distance(plane, center),
                     depth = depth_at<Rational>(height, a, 0);
      const Plane<Rational> lowered{plane.normal, plane.distance - depth};
      CHECK((depth < 0 || signed_distance(lowered, center) == a));
      // A capsule along 2-3-6 and a ball beside it, along 3-(-6)-2, or beyond one of its ends.
      const Exact3 axis = Exact3(2, 3, 6) / Rational(7), beside = Exact3(3, -6, 2) / Rational(7);
      const Segment<Rational> segment{along.unit, along.unit + axis * Rational(2)};
      const bool beyond = quarters > 8;
      const Rational off(quarters % 3 == 0 ? 0 : 1, 2);
      const Exact3 ball = segment.start + axis * distance + beside * (beyond ? Rational(0) : off);
      const Exact3 way = closest_point(segment, ball) - ball;
      const Rational length = beyond ? distance - 2 : off;
      CHECK(way.squaredNorm() == length * length);
      const Direction<Rational> to{length == 0 ? beside : Exact3(way / length), length};
      const SphereOverlap<Rational> capsule = sphere_overlap<Rational>(to, a, b);
      const Exact3 move = capsule.normal * capsule.depth;
      const Segment<Rational> moved{segment.start + move, segment.end + move};
      CHECK((closest_point(moved, ball) - ball).squaredNorm() == (a + b) * (a + b));
    }
  }
}

TEST_CASE("in fractions a ball touches a box once it has left its nearest face", "[S8][P3][P5]")
{
  const Exact3 half(2, 1, Rational(1, 2));
  const Rational radius(3, 4);
  for (const Vector3<double>& point : lattice())
  {
    const Exact3 local = half.cwiseProduct(exact<Rational>(point));
    const Direction<Rational> out = nearest_face(local, half);
    // The ball's normal is into the box: the box moves against the MTV.
    const SphereOverlap<Rational> overlap =
        sphere_overlap<Rational>({-out.unit, out.length}, radius, 0);
    CHECK(overlap.depth >= radius);
    const Exact3 left = local - overlap.normal * overlap.depth;
    const Exact3 outside = left - clamp_to_box(left, half);
    CHECK(outside.squaredNorm() == radius * radius);
  }
}

TEST_CASE(
    "in fractions 2,000 boxes, flat and equal ones among them, do not overlap any more", "[O5]")
{
  BoxDraw draw(8);
  int touching = 0, contained = 0;
  for (int i = 0; i < pairs / 10; ++i)
  {
    const Obb<Rational> a = whole_box(draw);
    Obb<Rational> b = i % 8 == 0 ? a : whole_box(draw);
    b.axes = i % 4 == 0 ? a.axes : b.axes;
    if (const std::optional<Obb<Rational>> moved = parted(a, b))
    {
      ++touching;
      contained += a.center == b.center ? 1 : 0;
      CHECK(true_least_overlap(a, *moved).signed_square <= 0);
    }
  }
  CHECK(touching > pairs / 40);
  CHECK(contained > 0);
}
