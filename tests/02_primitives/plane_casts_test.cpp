/// \file
/// What holds for every cast in the plane, on a grid where the truth is exact, and at the ends of
/// the range of numbers.

#include "02_primitives/in_the_plane/in_the_plane.hpp"

#include "tests/02_primitives/plane_around.hpp"
#include "tests/02_primitives/plane_inputs.hpp"
#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <limits>
#include <type_traits>

using namespace cookbook;

namespace
{

/// What is wrong, and how often what was seen.
struct Wrong
{
  int verdicts = 0; ///< hit or miss
  int places = 0;   ///< the point, or t
  int normals = 0;
  int early = 0; ///< the ray was in the shape before
  int hits = 0;
  int inside = 0;
  int misses = 0;
};

/// Looks at one hit: the point is of the ray and of the shape, nothing of which was met before; no
/// corner lies beyond the line through the point perpendicular to the normal.
template <class Real, class Shape>
void look_at(
    Wrong& wrong, const Hit<Real, 2>& hit, const Ray2<Real>& ray, const Shape& shape,
    double tolerance)
{
  const Around all = around(shape);
  const Vector<Long, 2> point = hit.point.template cast<Long>();
  const Vector<Long, 2> n = hit.normal.template cast<Long>();
  const Vector<Long, 2> d = ray.direction.template cast<Long>();
  const Vector<Long, 2> difference = point - ray.origin.template cast<Long>();
  wrong.normals += std::abs(double(n.norm()) - 1) > 1e-6 * (tolerance > 1e-9 ? 1 : 1e-9);
  if (hit.t == Real(0))
  {
    ++wrong.inside;
    wrong.places += hit.point != ray.origin || out_of(all, point) > tolerance;
    wrong.normals += !d.isZero(0) && (n + d / d.norm()).norm() > 1e-6;
    return;
  }
  wrong.places += double((difference - Long(hit.t) * d).norm()) > 40 * tolerance;
  wrong.places += out_of(all, point) > tolerance;
  wrong.normals += extent_beyond(all, point, n) > 40 * tolerance || n.dot(d) > tolerance;
  const Real before = hit.t * Real(1 - 1e-4);
  const Vector<Real, 2> end = ray.origin + before * ray.direction;
  // Where it grazes, or begins at the edge, it was near the edge before.
  const bool grazes = n.dot(d) > -1e-2 * d.norm() || double(difference.norm()) < 100 * tolerance;
  wrong.early += !grazes && overlaps<Real>(Segment2<Real>{ray.origin, end}, shape);
}

/// Casts rays and segments against shapes of the grid.
template <class Real, class Shape>
Wrong casts_on_the_grid(unsigned seed)
{
  GridDraw draw(seed);
  Wrong wrong;
  const bool is_float = std::is_same_v<Real, float>;
  const bool oriented = std::is_same_v<Shape, OrientedRectangle<Real>>;
  const double tolerance = oriented ? (is_float ? 1e-5 : 1e-13) : (is_float ? 2e-6 : 4e-14);
  const int powers[] = {0, is_float ? -100 : -1000, is_float ? 100 : 1000};
  for (int i = 0; i < random_inputs; ++i)
  {
    Segment2<Real> path;
    Shape shape;
    GridShape on_path, on_shape;
    draw(path, on_path);
    draw(shape, on_shape);
    const int k = powers[i % 3];
    const Ray2<Real> ray{path.start, path.end - path.start};
    const GridTruth truth = truth_of(on_path, on_shape);
    const auto hit = cast<Real>(times_power(path, k), times_power(shape, k));
    const bool decided = !oriented || !truth.touching;
    wrong.verdicts += decided && hit.has_value() != truth.overlap;
    wrong.misses += !hit;
    // The ray goes on; thirty times as far it is out of the grid.
    GridShape longer = on_path;
    const GridPoint along = on_path.corners[1] - on_path.corners[0];
    longer.corners[1] = {longer.corners[0].x + 30 * along.x, longer.corners[0].y + 30 * along.y};
    const GridTruth of_ray = truth_of(longer, on_shape);
    const Ray2<Real> scaled{times_power(ray.origin, k), times_power(ray.direction, k / 2)};
    const auto hit_of_ray = cast<Real>(scaled, times_power(shape, k));
    wrong.verdicts += (!oriented || !of_ray.touching) && hit_of_ray.has_value() != of_ray.overlap;
    const auto look = [&](const std::optional<Hit<Real, 2>>& one, int power_of_t)
    {
      if (one)
      {
        ++wrong.hits;
        look_at<Real>(
            wrong, {std::ldexp(one->t, power_of_t), times_power(one->point, -k), one->normal}, ray,
            shape, tolerance);
      }
    };
    look(hit, 0);
    look(hit_of_ray, k / 2 - k);
  }
  return wrong;
}

template <class Real, class Shape>
void check_casts(unsigned seed, const char* name)
{
  INFO(name << (std::is_same_v<Real, float> ? " in float" : " in double"));
  const Wrong wrong = casts_on_the_grid<Real, Shape>(seed);
  CHECK(wrong.verdicts == 0);
  CHECK(wrong.places == 0);
  CHECK(wrong.normals == 0);
  CHECK(wrong.early == 0);
  CHECK(wrong.hits > 0);
  CHECK(wrong.inside > 0);
  CHECK(wrong.misses > 0);
}

/// Numbers from one end of the range to the other.
template <class Real>
class ExtremeDraw
{
public:
  Real number()
  {
    using Limits = std::numeric_limits<Real>;
    const Real most = Limits::max() / 16, least = Limits::denorm_min();
    const Real choices[] = {0,           least,       Limits::min(), Real(1e-30), Real(-1e-30),
                            1,           Real(1) / 3, Real(-1),      1e6,         Real(1e30),
                            Real(-1e30), most,        -most,         most / 3,    -least};
    return choices[engine_() % std::size(choices)];
  }

  Vector<Real, 2> point() { return {number(), number()}; }
  Vector<Real, 2> extents() { return point().cwiseAbs(); }

private:
  std::mt19937 engine_{7};
};

/// Whether there is nothing but numbers in an answer, which may be infinite only in t.
template <class Real>
bool is_sound(const std::optional<Hit<Real, 2>>& hit)
{
  return !hit || (hit->t >= Real(0) && hit->point.allFinite() && hit->normal.allFinite() &&
                  std::abs(hit->normal.norm() - Real(1)) < Real(1e-5));
}

template <class Real, class First, class Second>
int unsound_pairs(const First& a, const Second& b)
{
  const auto found = closest_points<Real>(a, b);
  const bool sound = found.a.allFinite() && found.b.allFinite() && found.distance >= Real(0) &&
                     std::isfinite(found.distance);
  return sound && (!overlaps<Real>(a, b) || found.distance == Real(0)) ? 0 : 1;
}

} // namespace

// [casts]
TEMPLATE_TEST_CASE(
    "every cast on a grid: hit or miss, t, point and normal are right", "[casts]", float, double)
{
  check_casts<TestType, Circle<TestType>>(1, "circle");
  check_casts<TestType, Segment2<TestType>>(2, "segment");
  check_casts<TestType, Rectangle<TestType>>(3, "rectangle");
  check_casts<TestType, OrientedRectangle<TestType>>(4, "turned rectangle");
}
// [casts]

// [extremes]
TEMPLATE_TEST_CASE(
    "from the least number to the largest, nothing is NaN, and only t may be infinite", "[casts]",
    float, double)
{
  using Real = TestType;
  ExtremeDraw<Real> draw;
  int unsound = 0;
  for (int i = 0; i < random_inputs / 4; ++i)
  {
    const Vector<Real, 2> point = draw.point();
    const Segment2<Real> segment{draw.point(), draw.point()};
    const Circle<Real> circle{draw.point(), std::abs(draw.number())};
    const Rectangle<Real> rectangle{draw.point(), draw.extents()};
    const OrientedRectangle<Real> oriented{draw.point(), Real(i % 7), draw.extents()};
    const Ray2<Real> ray{draw.point(), draw.point()};
    const Segment2<Real> path{draw.point(), draw.point()};
    const auto all = [&](const auto& shape)
    {
      unsound += unsound_pairs<Real>(point, shape) + unsound_pairs<Real>(segment, shape) +
                 unsound_pairs<Real>(circle, shape) + unsound_pairs<Real>(rectangle, shape) +
                 unsound_pairs<Real>(oriented, shape);
      unsound += is_sound(cast<Real>(ray, shape)) ? 0 : 1;
      unsound += is_sound(cast<Real>(path, shape)) ? 0 : 1;
    };
    all(Segment2<Real>{draw.point(), segment.start});
    all(Circle<Real>{segment.start, circle.radius});
    all(Rectangle<Real>{draw.point(), rectangle.half_extents});
    all(OrientedRectangle<Real>{circle.center, Real(i % 5), draw.extents()});
  }
  CHECK(unsound == 0);
}
// [extremes]

// [cast_examples]
TEST_CASE("from inside t is 0 and the normal is against the ray; from outside it is the edge's")
{
  using V = Vector<double, 2>;
  const Rectangle<double> bounds{{0, 0}, {2, 1}};
  const auto inside = cast(Ray2<double>{{1, 0}, {3, 4}}, bounds);
  REQUIRE(inside);
  CHECK(inside->t == 0);
  CHECK(inside->point == V(1, 0));
  CHECK((inside->normal - V(-0.6, -0.8)).norm() <= 1e-15);
  const auto outside = cast(Ray2<double>{{-6, 0.5}, {2, 0}}, bounds);
  REQUIRE(outside);
  CHECK(outside->t == 2);
  CHECK(outside->point == V(-2, 0.5));
  CHECK(outside->normal == V(-1, 0));
  CHECK_FALSE(cast(Ray2<double>{{-6, 1.5}, {2, 0}}, bounds));
  CHECK_FALSE(cast(Ray2<double>{{-6, 0.5}, {-2, 0}}, bounds));
}

TEST_CASE("a direction of zero meets only what holds the origin, with the normal +y")
{
  using V = Vector<double, 2>;
  const Circle<double> circle{{0, 0}, 1};
  const auto held = cast(Ray2<double>{{0.5, 0}, {0, 0}}, circle);
  REQUIRE(held);
  CHECK(held->t == 0);
  CHECK(held->normal == V(0, 1));
  CHECK_FALSE(cast(Ray2<double>{{2, 0}, {0, 0}}, circle));
}

TEST_CASE("a ray along a segment meets its nearer end; across, the side it comes from")
{
  using V = Vector<double, 2>;
  const Segment2<double> wall{{5, 0}, {3, 0}};
  const auto along = cast(Ray2<double>{{0, 0}, {1, 0}}, wall);
  REQUIRE(along);
  CHECK(along->t == 3);
  CHECK(along->point == V(3, 0));
  CHECK(along->normal == V(-1, 0));
  const auto above = cast(Ray2<double>{{4, 2}, {0, -1}}, wall);
  const auto below = cast(Ray2<double>{{4, -2}, {0, 1}}, wall);
  REQUIRE(above);
  REQUIRE(below);
  CHECK(above->normal == V(0, 1));
  CHECK(below->normal == V(0, -1));
  CHECK(above->point == V(4, 0));
}
// [cast_examples]

TEST_CASE("a segment that ends on a turned edge is met, at t = 1 or a rounding before, never after")
{
  // The edge of the board goes through (3, 4).
  const OrientedRectangle<double> board{{0, 0}, std::atan2(4, 3), {5, 2}};
  for (int y = 26; y <= 30; ++y)
  {
    const auto hit = cast(Segment2<double>{{-25, double(y)}, {3, 4}}, board);
    REQUIRE(hit);
    CHECK(hit->t <= 1);
    CHECK(hit->t > 1 - 1e-14);
  }
}

TEST_CASE("a path on a wall's line, to rounding, that ends .384 m before the wall misses it")
{
  const Segment2<double> path{
      {1.5398156678068315, 0.012482248352688852}, {2.382518965375158, -0.5235360735640324}};
  const Segment2<double> wall{
      {0.373172543727752, 0.7545489893385298}, {1.2158758412960786, 0.2185306674218085}};
  CHECK_FALSE(cast(path, wall));
  const auto back = cast(Segment2<double>{path.end, wall.start}, wall);
  REQUIRE(back);
  CHECK((back->point - wall.end).norm() < 1e-14);
}
