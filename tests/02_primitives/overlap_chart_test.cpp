/// \file
/// What holds for two oriented boxes, asked by their axes, and for the triangles that are timed.

#include "02_primitives/overlap_chart/trial/overlap_chart.hpp"
#include "02_primitives/overlap_chart/trial/triangles_chart.hpp"
#include "02_primitives/triangle_triangle/triangles_meet.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/random_numbers.hpp"

#include <cmath>

using namespace cookbook;

namespace
{

/// How far apart two boxes are as far as 15 axes tell, in double: negative where they overlap.
double separation_of(const Obb<double>& a, const Obb<double>& b)
{
  double separation = -1e300;
  const auto ask = [&](const Vector3<double>& axis)
  {
    if (axis.norm() > 1e-3)
    {
      const Vector3<double> n = axis.normalized();
      separation = std::max(
          separation, std::abs(n.dot(b.center - a.center)) - box_radius(a, n) - box_radius(b, n));
    }
  };
  for (int i = 0; i < 3; ++i)
  {
    ask(a.axes.col(i));
    ask(b.axes.col(i));
    for (int k = 0; k < 3; ++k)
    {
      ask(a.axes.col(i).cross(b.axes.col(k)));
    }
  }
  return separation;
}

} // namespace

// [boxes_overlap_exact]
TEST_CASE("15 axes are right where fractions are; 6 never miss an overlap", "[boxes_overlap]")
{
  int too_many = 0;
  for (const float most : {2.0f, 10.0f})
  {
    int overlapping = 0, wrong = 0, missed = 0;
    for (const KnownBoxes& pair : known_boxes_in_pairs(random_inputs / 100, most))
    {
      overlapping += pair.overlap;
      wrong += boxes_overlap(pair.a, pair.b) != pair.overlap;
      missed += pair.overlap &&
                (!faces_overlap(pair.a, pair.b) || !spheres_around_overlap(pair.a, pair.b) ||
                 !bounds_overlap(pair.a, pair.b));
      too_many += !pair.overlap && faces_overlap(pair.a, pair.b);
    }
    CHECK(overlapping > 0);
    CHECK(wrong == 0);
    CHECK(missed == 0);
  }
  CHECK(too_many > 0);
}
// [boxes_overlap_exact]

// [boxes_overlap_random]
TEMPLATE_TEST_CASE(
    "boxes of all sizes: never wrong beyond rounding, whichever is first", "[boxes_overlap]", float,
    double)
{
  Random draw(11);
  const double roundings = 32.0 * static_cast<double>(std::numeric_limits<TestType>::epsilon());
  int wrong = 0, other_order = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const double size = std::pow(10.0, draw.whole(-15, 15));
    const auto box = [&](double distance)
    {
      const Vector3<double> v = draw.in_cube(1), half = draw.in_cube(1).cwiseAbs();
      const Quaternion<double> turn = Quaternion<double>(draw.between(-1, 1), v.x(), v.y(), v.z());
      return Obb<TestType>{
          (size * draw.in_cube(distance)).template cast<TestType>(),
          turn.normalized().toRotationMatrix().template cast<TestType>(),
          (size * (half + Vector3<double>::Constant(1e-3))).template cast<TestType>()};
    };
    const Obb<TestType> a = box(1.2);
    Obb<TestType> b = box(1.2);
    b.axes = i % 4 == 0 ? a.axes : b.axes;
    const auto wide = [](const Obb<TestType>& o)
    {
      return Obb<double>{
          o.center.template cast<double>(), o.axes.template cast<double>(),
          o.half_extents.template cast<double>()};
    };
    const double separation = separation_of(wide(a), wide(b)) / size;
    const bool says = boxes_overlap(a, b);
    wrong += std::abs(separation) > 10 * roundings && says != (separation < 0);
    other_order += says != boxes_overlap(b, a);
  }
  CHECK(wrong == 0);
  CHECK(other_order <= random_inputs / 1000); // only where boxes touch to rounding
}
// [boxes_overlap_random]

// [boxes_overlap_degenerate]
TEST_CASE(
    "boxes that are equal, touch, lie in each other, are turned by 1e-9 rad", "[boxes_overlap]")
{
  const Obb<double> box{{1, 2, 3}, Matrix3<double>::Identity(), {1, 2, 3}};
  Obb<double> other = box;
  CHECK(boxes_overlap(box, box));
  other.center.x() += 2; // face on face
  CHECK(boxes_overlap(box, other));
  other.center.x() += 1e-14;
  CHECK_FALSE(boxes_overlap(box, Obb<double>{{3 + 1e-12, 2, 3}, box.axes, box.half_extents}));
  other = box;
  other.half_extents /= 1000; // inside
  CHECK(boxes_overlap(box, other));
  // Turned by so little that the cross product of edges is nothing but rounding.
  for (const double angle : {1e-16, 1e-15, 1e-12, 1e-9})
  {
    other = box;
    other.axes = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix();
    other.center.y() += 3.999;
    CHECK(boxes_overlap(box, other));
    other.center.y() += 0.002;
    CHECK_FALSE(boxes_overlap(box, other));
  }
}
// [boxes_overlap_degenerate]

// [triangles_chart_agree]
TEST_CASE("triangles anywhere: all but one library answer as fractions do", "[triangle_triangle]")
{
  for (const KnownTriangles& pair : known_triangles_in_pairs(random_inputs / 50, false))
  {
    CHECK(triangles_meet(pair.a, pair.b) == pair.overlap);
    CHECK(triangles_meet_by_17_axes(pair.a, pair.b) == pair.overlap);
#ifdef COOKBOOK_HAS_FCL
    CHECK(fcl_meet(pair.a, pair.b) == pair.overlap);
#endif
#ifdef COOKBOOK_HAS_BULLET
    CHECK((bullet_meet(pair.a, pair.b) || !pair.overlap));
#endif
  }
}

TEST_CASE("triangles that share a plane or a corner: exact signs are right", "[triangle_triangle]")
{
  int meeting = 0;
  for (const KnownTriangles& pair : known_triangles_in_pairs(random_inputs / 50, true))
  {
    CHECK(triangles_meet(pair.a, pair.b) == pair.overlap);
    meeting += pair.overlap;
  }
  CHECK(meeting > random_inputs / 100);
  CHECK(meeting < random_inputs / 50);
}
// [triangles_chart_agree]

// [overlaps_by_axes]
TEST_CASE("1,000 pairs of boxes and of triangles: overlaps is right where fractions are")
{
  for (const KnownBoxes& pair : known_boxes_in_pairs(1000, 2.0f))
  {
    CHECK(overlaps(pair.a, pair.b) == pair.overlap);
  }
  for (const KnownTriangles& pair : known_triangles_in_pairs(1000, false))
  {
    CHECK(overlaps(pair.a, pair.b) == pair.overlap);
  }
}

TEMPLATE_TEST_CASE(
    "overlaps asks the axes of boxes and triangles, and says what closest_points does",
    "[overlaps]", float, double)
{
  using V = Vector3<TestType>;
  Random draw(57);
  int by_distance = 0, not_the_axes = 0, contradictions = 0;
  const auto ask = [&](const auto& a, const auto& b, bool says, bool random)
  {
    by_distance += random && !overlap_beyond_rounding(a, b).has_value();
    not_the_axes += random && overlaps(a, b) != says;
    contradictions += overlaps(a, b) != (closest_points(a, b).distance == 0);
  };
  const auto point = [&](double size) -> V
  { return (size * draw.in_cube(1)).template cast<TestType>(); };
  for (int i = 0; i < random_inputs / 5; ++i)
  {
    const auto turn = [&]() -> Quaternion<double>
    {
      const Vector3<double> v = draw.in_cube(1);
      return Quaternion<double>(draw.between(-1, 1), v.x(), v.y(), v.z()).normalized();
    };
    const auto box = [&](const Quaternion<double>& q) -> Obb<TestType>
    {
      return {
          point(1.2), q.toRotationMatrix().template cast<TestType>(),
          point(1).cwiseAbs() + V::Constant(TestType(1e-3))};
    };
    const Quaternion<double> q = turn();
    const Obb<TestType> a = box(q);
    Obb<TestType> b = box(turn());
    ask(a, b, boxes_overlap(a, b), true);
    // Boxes and triangles that touch, up to 1e-17 to 1e-3 m, some nearly parallel.
    const double tiny = std::pow(10.0, draw.between(-17, -3));
    b = i % 2 == 0 ? b : box(q * Quaternion<double>(1, tiny, 0, -tiny).normalized());
    const auto boxes = closest_points(a, b);
    b.center -= (boxes.b - boxes.a) * TestType(1 + (i % 3 - 1) * tiny);
    ask(a, b, false, false);
    const Triangle<TestType> s{point(1), point(1), point(1)}, t{point(1), point(1), point(1)};
    ask(s, t, triangles_meet_by_17_axes(s, t), true);
    const auto triangles = closest_points(s, t);
    const V move = (triangles.b - triangles.a) * TestType(1 + (i % 3 - 1) * tiny);
    ask(s, Triangle<TestType>{t.a - move, t.b - move, t.c - move}, false, false);
  }
  CHECK(by_distance <= random_inputs / 1000);
  CHECK(not_the_axes == 0);
  CHECK(contradictions == 0);
}
// [overlaps_by_axes]
