/// \file
/// Casts of whole numbers, times powers of two, against decisions that are exact.

#include "02_primitives/casts/casts.hpp"
#include "02_primitives/casts/trial/casts_truth.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tools/exact/exact.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace cookbook;
using whole::Relation;

namespace
{

using Vec = Vector3<double>;

Vec real(const whole::V& v)
{
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// Whole numbers, many of them zero or alike.
class Numbers
{
public:
  whole::Int up_to(int most) { return static_cast<whole::Int>(engine_() % unsigned(most + 1)); }
  whole::Int around(int most) { return up_to(2 * most) - most; }
  whole::V vector(int most)
  {
    whole::V v{around(most), around(most), around(most)};
    switch (up_to(7))
    {
    case 0:
      v.x = 0;
      break;
    case 1:
      v.y = v.z = 0;
      break;
    case 2:
      v.z = v.y;
      break;
    case 3:
      v = last_;
      break;
    default:
      break;
    }
    return last_ = v;
  }
  whole::Path path()
  {
    whole::Path path{vector(8), vector(8), up_to(1) == 0};
    if (up_to(3) == 0)
    {
      path.direction = vector(4) - path.origin; // towards something
    }
    if (up_to(31) == 0)
    {
      path.direction = {0, 0, 0};
    }
    return path;
  }

private:
  std::mt19937 engine_{20260401};
  whole::V last_{0, 0, 0};
};

/// A shape of whole numbers: what is exact about it, and what a hit must fulfil.
template <class Shape>
struct Known
{
  Shape shape;                                          ///< scaled
  std::function<Relation(const whole::Path&)> relation; ///< exact
  std::function<double(const Vec&)> support;            ///< the most of n·x in the shape
  std::function<double(const Vec&)> outside; ///< how far a point is from the shape, about
  bool solid = true;                         ///< false for what has no inside
};

// [check_cast]
/// Casts a path, and checks the verdict and whatever holds for a hit.
template <class Real, class Shape>
Relation check_cast(
    const whole::Path& path, const Known<Shape>& known, const Vec& distant, int size, int speed)
{
  const auto scaled_by = [](const Vec& v, int exponent) -> Vector3<Real>
  { return times_power_of_two<double>(v, exponent).template cast<Real>(); };
  const Vec o = real(path.origin), d = real(path.direction);
  const Vector3<Real> origin = scaled_by(o + distant, size);
  const std::optional<Hit<Real, 3>> hit =
      path.ends ? cast(Segment<Real>{origin, scaled_by(o + d + distant, size)}, known.shape)
                : cast(Ray<Real>{origin, scaled_by(d, speed)}, known.shape);
  const Relation relation = known.relation(path);
  const auto must = [&](bool right, const char* what)
  {
    if (!right)
    {
      INFO("origin " << o.transpose() << " direction " << d.transpose() << " ends " << path.ends);
      INFO("size " << size << " speed " << speed << " lie " << static_cast<int>(relation));
      if (hit)
      {
        INFO("t " << hit->t << " point " << hit->point.transpose());
        INFO("normal " << hit->normal.transpose());
        FAIL(what);
      }
      INFO("from outside: " << known.outside(o) << ", at the end " << known.outside(o + d));
      FAIL(what);
    }
  };
  must(relation != Relation::overlapping || hit, "a hit");
  must(relation != Relation::separate || !hit, "no hit");
  if (!hit)
  {
    return relation;
  }
  const double unit = std::is_same_v<Real, float> ? 1e-6 : 1e-13,
               tolerance = (32 + distant.norm()) * unit;
  const Vec n = hit->normal.template cast<double>();
  const Vec point = times_power_of_two<double>(hit->point.template cast<double>(), -size) - distant;
  const double t = std::ldexp(static_cast<double>(hit->t), path.ends ? 0 : speed - size);
  // Such a t is larger than the largest number, or less than the smallest: the point is not.
  const bool fits =
      path.ends || std::abs(speed - size) < std::numeric_limits<Real>::max_exponent - 9;
  must(std::abs(n.norm() - 1) <= unit, "normal of length one");
  const double off_line = (point - o).cross(d.stableNormalized()).norm();
  must((fits ? (o + t * d - point).norm() : off_line) <= tolerance, "point on the path");
  must(known.outside(point) <= tolerance, "point in the shape");
  must(t >= 0 && (!path.ends || t <= 1), "t in its range");
  must(n.dot(d) <= tolerance, "normal against the direction");
  const Relation start = known.relation({path.origin, {0, 0, 0}, true});
  must(t == 0 || start != Relation::overlapping, "t = 0 from inside");
  must(t > 0 || !fits || start != Relation::separate, "t > 0 from outside");
  if (!fits)
  {
    return relation;
  }
  if (start == Relation::overlapping)
  {
    must(hit->point == origin, "the origin, from inside");
    must((n + d.normalized()).norm() <= unit || d.isZero(0), "straight back, from inside");
  }
  else if (relation == Relation::overlapping && t > 0)
  {
    must(std::abs(known.support(n) - n.dot(point)) <= tolerance, "the first touch");
  }
  return relation;
}
// [check_cast]

double segment_distance(const Vec& p, const Vec& a, const Vec& b)
{
  const Vec u = b - a;
  const double fraction = u.isZero(0) ? 0 : std::clamp((p - a).dot(u) / u.squaredNorm(), 0.0, 1.0);
  return (p - a - fraction * u).norm();
}

double triangle_distance(const Vec& p, const Vec& a, const Vec& b, const Vec& c)
{
  const double edges =
      std::min({segment_distance(p, a, b), segment_distance(p, b, c), segment_distance(p, c, a)});
  const Vec n = (b - a).cross(c - a), unit = n.normalized();
  const auto left = [&](const Vec& q, const Vec& r) { return n.dot((r - q).cross(p - q)) >= 0; };
  const bool above = !n.isZero(0) && left(a, b) && left(b, c) && left(c, a);
  return above ? std::min(edges, std::abs(unit.dot(p - a))) : edges;
}

std::function<double(const Vec&)> corner_support(const std::vector<Vec>& corners)
{
  return [corners](const Vec& n)
  {
    double most = -1e300;
    for (const Vec& corner : corners)
    {
      most = std::max(most, n.dot(corner));
    }
    return most;
  };
}

/// Calls `make(numbers, scale, length)` for a known shape, and casts at it, at all sizes, and as
/// far from the origin as leaves whole numbers exact.
template <class Real, class Make>
void cast_at_all_sizes(const Make& make, bool anywhere = true)
{
  Numbers numbers;
  int seen[3] = {0, 0, 0};
  for (int i = 0; i < random_inputs; ++i)
  {
    const int sizes[] = {0, 0, 100, -100}, speeds[] = {0, 100, -100, 0};
    const whole::Int which = numbers.up_to(3), other = numbers.up_to(3);
    // Doubles go much farther.
    const bool small = std::is_same_v<Real, float>;
    const int more = !small && numbers.up_to(1) == 0 ? 9 : 1;
    const int size = more * sizes[which], speed = more * speeds[other];
    const Vec distant =
        anywhere && numbers.up_to(3) == 0 ? Vec(small ? 0x1p18 : 0x1p40, -0x1p12, 3) : Vec(0, 0, 0);
    const whole::Path path = numbers.path();
    const auto scale = [&](const whole::V& v) -> Vector3<Real>
    { return times_power_of_two<double>(real(v) + distant, size).template cast<Real>(); };
    const auto length = [&](whole::Int x)
    { return static_cast<Real>(std::ldexp(static_cast<double>(x), size)); };
    const Relation relation =
        check_cast<Real>(path, make(numbers, scale, length), distant, size, speed);
    ++seen[static_cast<int>(relation) + 1];
  }
  for (const int times : seen)
  {
    CHECK(times > random_inputs / 200); // apart, touching and overlapping
  }
}

} // namespace

TEMPLATE_TEST_CASE("casts at half-spaces agree with whole numbers", "[P8]", float, double)
{
  cast_at_all_sizes<TestType>(
      [](Numbers& numbers, const auto&, const auto& length)
      {
        const whole::V axes[] = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
        const whole::V n = axes[numbers.up_to(2)];
        const whole::Int d = numbers.around(8);
        return Known<Plane<TestType>>{
            {real(n).cast<TestType>(), length(d)},
            [=](const whole::Path& path) { return whole::plane(path, n, d); },
            [=](const Vec&) { return static_cast<double>(d); },
            [=](const Vec& p) { return real(n).dot(p) - static_cast<double>(d); }};
      },
      false);
}

TEMPLATE_TEST_CASE("casts at spheres agree with whole numbers", "[P9]", float, double)
{
  cast_at_all_sizes<TestType>(
      [](Numbers& numbers, const auto& scale, const auto& length)
      {
        const whole::V c = numbers.vector(6);
        const whole::Int r = numbers.up_to(6);
        const double radius = static_cast<double>(r);
        return Known<Sphere<TestType>>{
            {scale(c), length(r)},
            [=](const whole::Path& path) { return whole::sphere(path, c, r); },
            [=](const Vec& n) { return n.dot(real(c)) + radius; },
            [=](const Vec& p) { return (p - real(c)).norm() - radius; }};
      });
}

TEMPLATE_TEST_CASE("casts at capsules agree with whole numbers", "[P9]", float, double)
{
  cast_at_all_sizes<TestType>(
      [](Numbers& numbers, const auto& scale, const auto& length)
      {
        const whole::V a = numbers.vector(6), b = numbers.vector(6);
        const whole::Int r = numbers.up_to(5);
        const double radius = static_cast<double>(r);
        return Known<Capsule<TestType>>{
            {{scale(a), scale(b)}, length(r)},
            [=](const whole::Path& path) { return whole::capsule(path, a, b, r); },
            [=](const Vec& n) { return std::max(n.dot(real(a)), n.dot(real(b))) + radius; },
            [=](const Vec& p) { return segment_distance(p, real(a), real(b)) - radius; }};
      });
}

namespace
{

struct WholeBox
{
  whole::V min, max;
};

WholeBox draw_box(Numbers& numbers)
{
  const whole::V p = numbers.vector(6);
  return {p, p + whole::V{numbers.up_to(4), numbers.up_to(4), numbers.up_to(4)}};
}

double box_outside(const Vec& p, const Vec& min, const Vec& max)
{
  return (p - p.cwiseMax(min).cwiseMin(max)).norm();
}

double box_support(const Vec& n, const Vec& min, const Vec& max)
{
  return n.cwiseProduct(min).cwiseMax(n.cwiseProduct(max)).sum();
}

} // namespace

TEMPLATE_TEST_CASE("casts at boxes along the axes agree with whole numbers", "[P10]", float, double)
{
  cast_at_all_sizes<TestType>(
      [](Numbers& numbers, const auto& scale, const auto&)
      {
        const WholeBox box = draw_box(numbers);
        const Vec min = real(box.min), max = real(box.max);
        return Known<Aabb<TestType>>{
            {scale(box.min), scale(box.max)},
            [=](const whole::Path& path) { return whole::box(path, box.min, box.max); },
            [=](const Vec& n) { return box_support(n, min, max); },
            [=](const Vec& p) { return box_outside(p, min, max); }};
      });
}

TEMPLATE_TEST_CASE(
    "casts at boxes turned by quarters agree with whole numbers", "[P10]", float, double)
{
  cast_at_all_sizes<TestType>(
      [](Numbers& numbers, const auto& scale, const auto& length)
      {
        const whole::V half{numbers.up_to(3), numbers.up_to(3), numbers.up_to(3)};
        const whole::V c = numbers.vector(6), permuted{half.y, half.z, half.x};
        const Vec min = real(c - permuted), max = real(c + permuted);
        Matrix3<TestType> axes;
        axes << 0, -1, 0, 0, 0, -1, 1, 0, 0;
        return Known<Obb<TestType>>{
            {scale(c), axes, {length(half.x), length(half.y), length(half.z)}},
            [=](const whole::Path& path) { return whole::box(path, c - permuted, c + permuted); },
            [=](const Vec& n) { return box_support(n, min, max); },
            [=](const Vec& p) { return box_outside(p, min, max); }};
      });
}

TEMPLATE_TEST_CASE("casts at triangles agree with whole numbers", "[P12]", float, double)
{
  cast_at_all_sizes<TestType>(
      [](Numbers& numbers, const auto& scale, const auto&)
      {
        const whole::V a = numbers.vector(6), b = numbers.vector(6), c = numbers.vector(6);
        return Known<Triangle<TestType>>{
            {scale(a), scale(b), scale(c)},
            [=](const whole::Path& path) {
              return whole::corners(path, {a, b, c});
            },
            corner_support({real(a), real(b), real(c)}),
            [=](const Vec& p) { return triangle_distance(p, real(a), real(b), real(c)); },
            false};
      });
}

TEMPLATE_TEST_CASE("casts at tetrahedra agree with whole numbers", "[P12]", float, double)
{
  cast_at_all_sizes<TestType>(
      [](Numbers& numbers, const auto& scale, const auto&)
      {
        const whole::V all[] = {
            numbers.vector(6), numbers.vector(6), numbers.vector(6), numbers.vector(6)};
        const Vec a = real(all[0]), b = real(all[1]), c = real(all[2]), d = real(all[3]);
        const auto outside = [=](const Vec& p)
        {
          const auto volume = [](const Vec& e, const Vec& f, const Vec& g, const Vec& h)
          { return (f - e).cross(g - e).dot(h - e); };
          const double v = volume(a, b, c, d);
          const bool within = v != 0 && volume(p, b, c, d) / v >= 0 &&
                              volume(a, p, c, d) / v >= 0 && volume(a, b, p, d) / v >= 0 &&
                              volume(a, b, c, p) / v >= 0;
          return within ? 0.0
                        : std::min(
                              {triangle_distance(p, a, b, c), triangle_distance(p, a, b, d),
                               triangle_distance(p, a, c, d), triangle_distance(p, b, c, d)});
        };
        return Known<Tetrahedron<TestType>>{
            {scale(all[0]), scale(all[1]), scale(all[2]), scale(all[3])},
            [=](const whole::Path& path) {
              return whole::corners(path, {all[0], all[1], all[2], all[3]});
            },
            corner_support({a, b, c, d}),
            outside};
      });
}

TEST_CASE("at flat and thin triangles t is that of fractions", "[P12]")
{
  using Q = Vector3<Rational>;
  std::mt19937 engine{20261128};
  const auto number = [&] { return std::ldexp(static_cast<double>(engine() % 2048), -10) - 1; };
  const auto vector = [&] { return Vec(number(), number(), number()); };
  const double widths[] = {0, 0x1p-40, 0x1p-20, 0x1p-10};
  int met[] = {0, 0, 0, 0};
  for (int i = 0; i < random_inputs / 5; ++i)
  {
    const std::size_t which = engine() % 4;
    const Vec a = vector(), b = vector(), aside = vector(), far_side = 4 * vector();
    const double part = static_cast<double>(engine() % 9) / 8, along = std::abs(number());
    const Vec c = a + part * (b - a) + widths[which] * aside; // exactly
    const Vec aim = (1 - along) * (a + c) / 2 + along * b, towards = aim - far_side;
    const auto hit = cast(Ray<double>{far_side, towards}, Triangle<double>{a, b, c});
    const Q d = exact<Rational>(towards), to_a = exact<Rational>(a) - exact<Rational>(far_side);
    const Q ab = exact<Rational>(b) - exact<Rational>(a);
    const Q ac = exact<Rational>(c) - exact<Rational>(a);
    // A flat one is a segment: there t is that of the point on the path closest to its line.
    const Q n = which == 0 ? Q(ab.cross(Q(d.cross(ab)))) : Q(ab.cross(ac));
    const Vec unit = (n * Rational(0x1p40)).cast<double>().stableNormalized();
    if (hit && std::abs(unit.dot(towards)) > 0.1)
    {
      ++met[which];
      const Rational error = Rational(hit->t) - n.dot(to_a) / n.dot(d);
      INFO("width " << widths[which] << " t " << hit->t << " error " << double(error));
      REQUIRE(std::abs(double(error)) <= 1e-13);
    }
    // Along a line, a flat one is met at the first of its corners.
    const Vec line = b - a, start = a - (2 + part) * line;
    const auto first = cast(Ray<double>{start, 3 * line}, Triangle<double>{b, c, a});
    if (first && which == 0)
    {
      REQUIRE(std::abs(first->t - (2 + part) / 3) <= 1e-15);
    }
  }
  for (const int times : met)
  {
    CHECK(times > random_inputs / 200);
  }
}
