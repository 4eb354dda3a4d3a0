/// \file
/// GJK and EPA against the fifteen axes, which are held against fractions elsewhere: a million
/// pairs of random cubes, and pairs that stand as boxes stand in practice.

#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "04_obb_manifolds/gjk_epa/trial/gjk_epa_cases.hpp"
#include "04_obb_manifolds/gjk_epa/trial/gjk_epa_pitfalls.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

namespace
{

constexpr int pairs = 1'000'000;

/// How far answers are from those of the axes; lengths as parts of the sum of all half extents.
struct Difference
{
  int compared = 0;
  int hits = 0;
  int wrong = 0;    ///< decisions where the gap or the depth is more than `tolerance`
  double depth = 0; ///< the largest error of a depth
  double tolerance; ///< of decisions

  template <class Real>
  void compare(const Obb<Real>& a, const Obb<Real>& b)
  {
    const auto wide = [](const Obb<Real>& box) -> Obb<double>
    {
      return {
          box.center.template cast<double>(), box.axes.template cast<double>(),
          box.half_extents.template cast<double>()};
    };
    const double size = double(a.half_extents.sum() + b.half_extents.sum());
    const double separation = largest_separation(wide(a), wide(b)) / size;
    const auto manifold = gjk_epa(a, b);
    ++compared;
    hits += manifold ? 1 : 0;
    wrong += manifold.has_value() != (separation <= 0) && std::abs(separation) > tolerance ? 1 : 0;
    depth =
        manifold
            ? std::max(depth, std::abs(double(manifold->depth) / size + std::max(separation, -1.0)))
            : depth;
  }
};

/// Numbers that every compiler draws alike.
class Draw : public BoxDraw
{
public:
  using BoxDraw::BoxDraw;

  int whole(int low, int high) { return low + BoxDraw::whole(high - low + 1); }
  Vector3<double> whole_vector(int low, int high)
  {
    const double x = whole(low, high), y = whole(low, high);
    return {x, y, double(whole(low, high))};
  }
  Matrix3<double> rotation()
  {
    const Vector3<double> v = vector(-1, 1);
    return Quaternion<double>(between(-1, 1), v.x(), v.y(), v.z()).normalized().toRotationMatrix();
  }
};

} // namespace

// [K4]
TEST_CASE(
    "of a million pairs of random cubes none is decided wrongly, in double and in float",
    "[case:K4]")
{
  Difference in_doubles{.tolerance = 1e-15}, in_floats{.tolerance = 1e-15};
  RandomCubes draw(1);
  for (int i = 0; i < pairs; ++i)
  {
    const Obb<double> a = draw.next(), b = draw.next();
    in_doubles.compare(a, b);
    in_floats.compare(to_float(a), to_float(b));
  }
  CHECK(in_doubles.compared == pairs);
  CHECK(in_doubles.hits > pairs / 5);
  CHECK(in_doubles.hits < pairs / 2);
  CHECK(in_doubles.wrong == 0);
  // Both ways to the depth round a few times: far less than the tolerance of 7e-15.
  CHECK(in_doubles.depth <= 2e-15);
  // Floats are taken as they are and computed in double; only the answer is rounded.
  CHECK(in_floats.wrong == 0);
  CHECK(in_floats.depth <= 6e-8);
}

TEST_CASE("without the rebuild, contacts of random cubes in float get lost", "[case:K4]")
{
  RandomCubes draw(1);
  int lost = 0, lost_in_double = 0, wrong = 0;
  for (int i = 0; i < 50'000; ++i)
  {
    const Obb<double> a = draw.next(), b = draw.next();
    const double separation = largest_separation(a, b);
    const ConvexPair<float> pair = convex_pair(to_float(a), to_float(b));
    if (separation < -1e-4)
    {
      lost += no_rebuild(pair.support, pair.start, tolerance_of(pair)) ? 0 : 1;
      const ConvexPair<double> exact = convex_pair(a, b);
      lost_in_double += no_rebuild(exact.support, exact.start, tolerance_of(exact)) ? 0 : 1;
      const auto depth = convex_depth(pair.support, pair.start, tolerance_of(pair));
      wrong += depth && std::abs(double(*depth) + separation) <= 1e-4 ? 0 : 1;
    }
  }
  CHECK(lost > 0);
  // Which is why random tests in double do not find the fault.
  CHECK(lost_in_double == 0);
  CHECK(wrong == 0);
}
// [K4]

// [nearly_aligned]
TEST_CASE("boxes turned against each other by next to nothing have the depth of the axes", "[epa]")
{
  Draw draw(2);
  for (const double angle : {1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15, 0.0})
  {
    Difference difference{.tolerance = 1e-15};
    for (int i = 0; i < pairs / 100; ++i)
    {
      const Matrix3<double> rotation = draw.rotation();
      const Obb<double> a{draw.vector(-1, 1), rotation, draw.vector(0.3, 1)};
      const Vector3<double> center = a.center + rotation * draw.vector(-1.5, 1.5);
      const double turn = draw.between(-angle, angle);
      const Matrix3<double> tilted = turned(turn, draw.vector(0.1, 1)) * rotation;
      difference.compare(a, Obb<double>{center, tilted, draw.vector(0.3, 1)});
    }
    CAPTURE(angle);
    CHECK(difference.wrong == 0);
    // Among faces as thin as needles EPA may close a whole tolerance of O8 early, and round.
    CHECK(difference.depth <= 36 * std::numeric_limits<double>::epsilon());
  }
}

TEST_CASE("boxes on a grid of whole numbers have exactly the depth of the axes", "[epa]")
{
  Draw draw(3);
  Difference difference{.tolerance = 0};
  for (int i = 0; i < pairs / 100; ++i)
  {
    const auto box = [&]() -> Obb<double>
    {
      const Vector3<double> center = draw.whole_vector(-3, 3);
      return upright(center, draw.whole_vector(1, 3));
    };
    const Obb<double> a = box();
    difference.compare(a, box());
  }
  CHECK(difference.hits > pairs / 200);
  CHECK(difference.wrong == 0);
  CHECK(difference.depth == 0);
}

TEST_CASE(
    "plates and rods of a micrometre and boxes in one place have the depth of the axes", "[epa]")
{
  Draw draw(4);
  Difference thin{.tolerance = 1e-15}, rods = thin, inside = thin;
  for (int i = 0; i < pairs / 100; ++i)
  {
    const auto box = [&](double y, double z) -> Obb<double>
    {
      const Vector3<double> center = draw.vector(-1, 1);
      return {center, draw.rotation(), {draw.between(0.5, 2), y, z}};
    };
    const Obb<double> plate = box(1e-6, 1), rod = box(1e-6, 1e-6), block = box(1, 0.5);
    thin.compare(plate, box(1e-6, 0.7));
    Obb<double> across = box(1e-6, 1e-6);
    across.center = rod.center + draw.vector(-2e-6, 2e-6);
    rods.compare(rod, across);
    Obb<double> within = box(0.7, 0.9);
    within.center = block.center;
    inside.compare(block, within);
  }
  CHECK(thin.wrong + rods.wrong + inside.wrong == 0);
  CHECK(std::max({thin.depth, rods.depth, inside.depth}) <= 2e-15);
}
// [nearly_aligned]

// [rods]
TEST_CASE(
    "rods a billion times longer than thick: never too shallow, now and then too deep", "[epa]")
{
  Draw draw(5);
  double below = 0, above = 0;
  for (int i = 0; i < 40'000; ++i)
  {
    const auto rod = [&](const Vector3<double>& center) -> Obb<double> {
      return {center, draw.rotation(), {draw.between(0.5, 2), 1e-9, 1e-9}};
    };
    const Obb<double> a = rod({0, 0, 0}), b = rod(draw.vector(-2e-9, 2e-9));
    const double depth = -largest_separation(a, b);
    if (const auto manifold = gjk_epa(a, b))
    {
      below = std::max(below, depth - manifold->depth);
      above = std::max(above, manifold->depth - depth);
    }
  }
  // Tolerance of O8 for five metres of half extents.
  CHECK(below <= 4e-14);
  CHECK(above > 1e-10);
  CHECK(above < 1e-8);
}
// [rods]
