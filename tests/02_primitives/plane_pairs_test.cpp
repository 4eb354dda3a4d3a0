/// \file
/// What holds for every pair of shapes in the plane: overlaps and closest points, on a grid where
/// the truth is exact, and anywhere.

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

/// Counts what is wrong, so that a hundred thousand inputs need one assertion each kind.
struct Wrong
{
  int verdicts = 0;
  int distances = 0;
  int points = 0;
  int touching = 0;
  int overlapping = 0;
  int separate = 0;
};

/// Whether closest points are right: each is of its shape, and no corner is on the other's side.
template <class Real, class First, class Second>
bool closest_are_right(
    const ClosestPoints<Real, 2>& found, const First& a, const Second& b, double tolerance)
{
  const Around of_a = around(a), of_b = around(b);
  const Vector<Long, 2> p = found.a.template cast<Long>(), q = found.b.template cast<Long>();
  const double size = std::max(of_a.size, of_b.size), tolerated = tolerance * size;
  const bool members = out_of(of_a, p) <= tolerated && out_of(of_b, q) <= tolerated;
  const Long distance = (q - p).norm();
  if (found.distance == Real(0))
  {
    return members && distance <= tolerated;
  }
  // The nearer the points, the fewer digits their direction has.
  const Vector<Long, 2> n = (q - p) / distance;
  const double allowed = tolerated * (4 + 4 * size / double(distance));
  return members && std::abs(double(distance) - double(found.distance)) <= tolerated &&
         extent_beyond(of_a, p, n) <= allowed && extent_beyond(of_b, q, -n) <= allowed;
}

template <class Shape>
constexpr bool is_oriented = std::is_same_v<Shape, OrientedRectangle<float>> ||
                             std::is_same_v<Shape, OrientedRectangle<double>>;

/// Goes over pairs on the grid; each is also tried by a power of two smaller and larger.
template <class Real, class First, class Second>
Wrong on_the_grid(unsigned seed)
{
  GridDraw draw(seed);
  Wrong wrong;
  const bool is_float = std::is_same_v<Real, float>;
  const int powers[] = {0, is_float ? -140 : -1060, is_float ? 120 : 1015};
  const bool oriented = is_oriented<First> || is_oriented<Second>;
  // A float's angle is off by 1e-8, a double's by 1e-16.
  const double tolerance = oriented ? (is_float ? 1e-6 : 1e-14) : (is_float ? 1e-7 : 1e-15);
  for (int i = 0; i < random_inputs; ++i)
  {
    First a;
    Second b;
    GridShape on_a, on_b;
    draw(a, on_a);
    draw(b, on_b);
    const GridTruth truth = truth_of(on_a, on_b);
    const int k = powers[i % 3];
    const First scaled_a = times_power(a, k);
    const Second scaled_b = times_power(b, k);
    const bool overlap = overlaps<Real>(scaled_a, scaled_b);
    const ClosestPoints<Real, 2> found = closest_points<Real>(scaled_a, scaled_b);
    const bool undecided = oriented && truth.touching;
    wrong.touching += truth.touching;
    wrong.overlapping += truth.overlap;
    wrong.separate += !truth.overlap;
    wrong.verdicts += !undecided && overlap != truth.overlap;
    wrong.verdicts += !undecided && (found.distance == Real(0)) != truth.overlap;
    wrong.verdicts += overlaps<Real>(scaled_b, scaled_a) != overlap && !undecided;
    const double distance = double(std::ldexp(static_cast<long double>(found.distance), -k));
    // At the lower end of the range, numbers are whole multiples of its least.
    const double steps = is_float ? 4 * std::ldexp(1.0, -149 - k) : 4 * std::ldexp(1.0, -1074 - k);
    const double rounding = 12 * tolerance + (k < 0 ? steps : 0);
    wrong.distances += std::abs(distance - truth.distance / 5) > rounding;
    const ClosestPoints<Real, 2> here{
        times_power(found.a, -k), times_power(found.b, -k), Real(distance)};
    wrong.points += !closest_are_right(here, a, b, tolerance + rounding);
    if (i % 8 == 0)
    {
      const Real swapped = closest_points<Real>(scaled_b, scaled_a).distance;
      wrong.distances +=
          std::abs(double(std::ldexp(static_cast<long double>(swapped), -k)) - distance) > rounding;
    }
  }
  return wrong;
}

/// Shapes of sizes from 2^-30 to 2^30 about places of as many sizes.
template <class Real>
class AnywhereDraw
{
public:
  explicit AnywhereDraw(unsigned seed) : engine_(seed) {}

  Real number()
  {
    const double fraction = double(engine_()) / 4294967296.0 * 2 - 1;
    return Real(std::ldexp(fraction, int(engine_() % 61) - 30));
  }

  void operator()(Vector<Real, 2>& p) { p = {number(), number()}; }
  void operator()(Segment2<Real>& s)
  {
    (*this)(s.start);
    (*this)(s.end);
  }
  void operator()(Circle<Real>& c)
  {
    (*this)(c.center);
    c.radius = std::abs(number());
  }
  void operator()(Rectangle<Real>& r)
  {
    (*this)(r.center);
    r.half_extents = {std::abs(number()), std::abs(number())};
  }
  void operator()(OrientedRectangle<Real>& r)
  {
    (*this)(r.center);
    r.half_extents = {std::abs(number()), std::abs(number())};
    r.angle = Real(double(engine_()) / 4294967296.0 * 12 - 6);
  }

private:
  std::mt19937 engine_;
};

/// Goes over pairs of all sizes: where they are apart, closest points prove it; where they are not,
/// a common point does.
template <class Real, class First, class Second>
Wrong anywhere(unsigned seed)
{
  AnywhereDraw<Real> draw(seed);
  Wrong wrong;
  const double tolerance = 8 * double(std::numeric_limits<Real>::epsilon());
  for (int i = 0; i < random_inputs / 4; ++i)
  {
    First a;
    Second b;
    draw(a);
    draw(b);
    const ClosestPoints<Real, 2> found = closest_points<Real>(a, b);
    const bool overlap = overlaps<Real>(a, b);
    wrong.overlapping += overlap;
    wrong.separate += !overlap;
    wrong.verdicts += overlap && found.distance > Real(0);
    wrong.verdicts += !overlap && found.distance == Real(0);
    wrong.points += !closest_are_right(found, a, b, tolerance);
  }
  return wrong;
}

template <class Real, class First, class Second>
void check_pair(unsigned seed, const char* name)
{
  INFO(name << (std::is_same_v<Real, float> ? " in float" : " in double"));
  const Wrong grid = on_the_grid<Real, First, Second>(seed);
  CHECK(grid.verdicts == 0);
  CHECK(grid.distances == 0);
  CHECK(grid.points == 0);
  CHECK(grid.touching > 0);
  CHECK(grid.overlapping > 0);
  CHECK(grid.separate > 0);
  const Wrong all_sizes = anywhere<Real, First, Second>(seed + 1);
  CHECK(all_sizes.verdicts == 0);
  CHECK(all_sizes.points == 0);
}

} // namespace

// [pairs]
TEMPLATE_TEST_CASE(
    "every pair on a grid: verdict, distance and closest points are right", "[pairs]", float,
    double)
{
  using Real = TestType;
  using Point = Vector<Real, 2>;
  check_pair<Real, Point, Point>(1, "point, point");
  check_pair<Real, Point, Segment2<Real>>(2, "point, segment");
  check_pair<Real, Point, Circle<Real>>(3, "point, circle");
  check_pair<Real, Point, Rectangle<Real>>(4, "point, rectangle");
  check_pair<Real, Point, OrientedRectangle<Real>>(5, "point, turned rectangle");
  check_pair<Real, Segment2<Real>, Segment2<Real>>(6, "segment, segment");
  check_pair<Real, Segment2<Real>, Circle<Real>>(7, "segment, circle");
  check_pair<Real, Segment2<Real>, Rectangle<Real>>(8, "segment, rectangle");
  check_pair<Real, Segment2<Real>, OrientedRectangle<Real>>(9, "segment, turned rectangle");
  check_pair<Real, Circle<Real>, Circle<Real>>(10, "circle, circle");
  check_pair<Real, Circle<Real>, Rectangle<Real>>(11, "circle, rectangle");
  check_pair<Real, Circle<Real>, OrientedRectangle<Real>>(12, "circle, turned rectangle");
  check_pair<Real, Rectangle<Real>, Rectangle<Real>>(13, "rectangle, rectangle");
  check_pair<Real, Rectangle<Real>, OrientedRectangle<Real>>(14, "rectangle, turned rectangle");
  check_pair<Real, OrientedRectangle<Real>, OrientedRectangle<Real>>(15, "turned, turned");
}
// [pairs]
