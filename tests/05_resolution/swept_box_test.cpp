/// \file
/// What holds for the first touch of boxes that move and turn: formula P20.

#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "05_resolution/tunnelling/swept_box.hpp"
#include "05_resolution/tunnelling/trial/tunnelling_box_scenes.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

namespace
{

constexpr double tolerance = 1e-6; ///< [m], the gap at which an advance is content
constexpr double rounding = 1e-13;

std::optional<double> time_of_impact(const BoxSweep& sweep)
{
  const auto hit = swept_boxes(sweep.a, sweep.b, tolerance);
  return hit ? std::optional(hit->time * sweep.duration) : std::nullopt;
}

double gap(const SweptBox<double>& a, const SweptBox<double>& b, double time)
{
  return box_gap(box_at(a, time), box_at(b, time)).length;
}

/// Boxes that fly at each other and turn, the same ones every time.
class RandomBoxes
{
public:
  SweptBox<double> next(double side)
  {
    const Matrix3<double> axes =
        rational_rotation<double>(1 + whole(), whole(), whole(), whole() - 2);
    const Vector3<double> half_extents = vector(0.4) + Vector3<double>::Constant(0.5);
    const Vector3<double> start(side * 3, 0, 0), end = vector(1.2);
    return {{start, axes, half_extents}, 1.5 * (end - start), vector(2)};
  }

private:
  int whole() { return draw_.whole(5); }
  Vector3<double> vector(double size) { return draw_.vector(-size, size); }
  BoxDraw draw_{1};
};

} // namespace

// [P20]
TEST_CASE("a square 10 m away touches a box of half extents 1 and 1.5 after 8 s", "[P20][case:J6]")
{
  for (const double duration : {10.0, 16.0, 30.0, 1000.0})
  {
    const auto time = time_of_impact(square_and_box("", "", duration));
    REQUIRE(time);
    CHECK(std::abs(*time - 8) <= 1000 * rounding);
  }
  CHECK(!time_of_impact(square_and_box("", "", 7.999)));
}

TEST_CASE("a rod of 4 m turns into a peg beside its middle at an angle of atan(40/9)", "[P20]")
{
  // The rod's corners move at 2 m a radian and the peg is met at 0.9: the time is early by less
  // than the gap that is left over the slower of the two.
  const BoxSweep sweep = rod_and_peg();
  const auto time = time_of_impact(sweep);
  REQUIRE(time);
  CHECK(*time <= *sweep.time + rounding);
  CHECK(*time >= *sweep.time - tolerance / (0.9 * 3));
}

TEST_CASE(
    "of 2,000 pairs none overlaps before its touch; 1 hit in 50 at most stops up to 5 cm short",
    "[P20][long]")
{
  RandomBoxes random;
  int hits = 0, short_of = 0;
  double most_left = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const SweptBox<double> a = random.next(-1), b = random.next(1);
    const auto hit = swept_boxes(a, b, tolerance);
    const double free = hit ? hit->time : 1;
    for (int part = 0; part <= 50; ++part)
    {
      REQUIRE(gap(a, b, free * part / 50) >= -rounding);
    }
    if (hit)
    {
      ++hits;
      REQUIRE(hit->normal.norm() == Catch::Approx(1).epsilon(1e-12));
      const double left = gap(a, b, hit->time);
      most_left = std::max(most_left, left);
      short_of += left > tolerance ? 1 : 0;
    }
  }
  INFO(hits << " hits, " << short_of << " stop short, by up to " << most_left << " m");
  CHECK(short_of <= hits / 50);
  CHECK(most_left <= 0.05);
  CHECK(hits > 1000);
  CHECK(hits < 1500);
}
// [P20]

TEST_CASE("two boxes 6.7 m apart or more are separate, whatever the size of the angle", "[case:J5]")
{
  const BoxSweep sweep = box_sweeps()[0];
  CHECK(gap(sweep.a, sweep.b, 1) == Catch::Approx(6.6946).margin(1e-3));
  CHECK(!time_of_impact(sweep));
  // With a turn of 513 rad until time 1 the bound asks for more looks, but for an end too.
  SweptBox<double> spinning = sweep.b;
  spinning.rotation = {0, 0, 513};
  const auto hit = swept_boxes(sweep.a, spinning, tolerance);
  CHECK((!hit || gap(sweep.a, spinning, hit->time) > 0));
}

TEST_CASE("boxes at rest touch at once or not at all")
{
  const SweptBox<double> box = standing(0, 0, 0, 1, 1);
  CHECK(!swept_boxes(box, standing(3, 0, 0, 1, 1), tolerance));
  CHECK(swept_boxes(box, standing(2, 0, 0, 1, 1), tolerance)->time == 0);
  CHECK(swept_boxes(box, standing(1, 0, 0, 1, 1), tolerance)->time == 0);
  CHECK(swept_boxes(box, box, tolerance)->time == 0);
}

TEST_CASE("the gap of two boxes is 1 m face to face, √2 m edge to edge along 45°")
{
  const Obb<double> unit = standing(0, 0, 0, 1, 1).box;
  const Direction<double> face = box_gap(unit, standing(-3, 0.5, 0, 1, 1).box);
  CHECK(face.length == 1);
  CHECK(face.unit == Vector3<double>(-1, 0, 0));
  // B's corner points at A's face: 3 less A's 1 and B's √2.
  const Direction<double> corner = box_gap(unit, standing(3, 0, std::atan(1.0), 1, 1).box);
  CHECK(corner.length == Catch::Approx(2 - std::sqrt(2.0)).epsilon(rounding));
}

TEST_CASE("beside the wide face of a slab a box turned anyhow has its gap along that face's axis")
{
  const Matrix3<double> turned = rational_rotation<double>(4, 1, 2, 3);
  for (int axis = 0; axis < 3; ++axis)
  {
    Obb<double> slab{{0, 0, 0}, turned, {10, 10, 10}};
    slab.half_extents[axis] = 1;
    const Vector3<double> normal = turned.col(axis);
    const Obb<double> box{5 * normal, Matrix3<double>::Identity(), {0.5, 1, 0.75}};
    const double radius_bound = normal.cwiseAbs().dot(box.half_extents);
    const Direction<double> there = box_gap(slab, box), back = box_gap(box, slab);
    CAPTURE(axis);
    CHECK(there.length == Catch::Approx(5 - 1 - radius_bound).epsilon(8 * rounding));
    CHECK((there.unit - normal).norm() <= 8 * rounding);
    CHECK(back.length == Catch::Approx(there.length).epsilon(8 * rounding));
    CHECK((back.unit + normal).norm() <= 8 * rounding);
  }
}

TEST_CASE("the gap of two edges that cross 1 m apart is 1 m, though their cross product is short")
{
  // Unit cubes that stand on an edge along x, and along (24, 0, 7) / 25: the sine is 0.28.
  const Vector3<double> x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const Vector3<double> u(0.96, 0, 0.28), v(-0.28, 0, 0.96);
  Matrix3<double> along_x, along_u;
  along_x << x, (y + z).normalized(), (z - y).normalized();
  along_u << u, (y + v).normalized(), (v - y).normalized();
  const double half_diagonal = std::sqrt(2.0);
  const Obb<double> a{{0, 0, 0}, along_x, {1, 1, 1}};
  const Obb<double> b{{0, 2 * half_diagonal + 1, 0}, along_u, {1, 1, 1}};
  const Direction<double> gap = box_gap(a, b);
  CHECK(gap.length == Catch::Approx(1).epsilon(rounding));
  CHECK((gap.unit - y).norm() <= rounding);
  CHECK((box_gap(b, a).unit + y).norm() <= rounding);
}
