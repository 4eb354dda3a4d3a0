/// \file
/// What holds for contacts that are solved in turn: formulas R7 to R9, with and without warm
/// starting.

#include "05_resolution/contact_constraint/contact_constraint.hpp"
#include "05_resolution/contact_constraint/trial/columns.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <numbers>
#include <vector>

using namespace cookbook;

namespace
{

/// A unit cube of 1 kg that lands flat at 1 m/s, and its four corners.
template <class Real>
struct LandingCube
{
  Body<Real> ground = static_body<Real>(Vector3<Real>::Zero());
  Body<Real> cube = static_body<Real>(Vector3<Real>::Zero());
  std::vector<ContactConstraint<Real>> corners;

  LandingCube()
  {
    const Real half = Real(1) / Real(2);
    cube.motion.velocity.y() = Real(-1);
    cube.inverse_mass = Real(1);
    cube.inverse_inertia = Matrix3<Real>::Identity() * Real(6);
    for (const auto& [x, z] : {std::pair(1, 1), {1, -1}, {-1, -1}, {-1, 1}})
    {
      ContactConstraint<Real> corner{};
      corner.normal = Vector3<Real>::UnitY();
      corner.arms = {Vector3<Real>::Zero(), {half * Real(x), -half, half * Real(z)}};
      corner.impulse = Real(0);
      corner.normal_mass =
          effective_mass<Real>(inverse_mass_at<Real>(ground, cube, corner.normal, corner.arms));
      corners.push_back(corner);
    }
  }
};

} // namespace

// [R7]
TEST_CASE("a cube's corners get 1/4, 3/16, 21/64, 51/256 N s in the first pass", "[R7]")
{
  LandingCube<Rational> landing;
  auto& [ground, cube, corners] = landing;
  for (ContactConstraint<Rational>& corner : corners)
  {
    const Rational closing = -separating_velocity<Rational>(ground, cube, corner);
    add_impulse<Rational>(ground, cube, corner, corner.normal_mass * closing);
  }
  CHECK(corners[0].impulse == Rational(1) / 4);
  CHECK(corners[1].impulse == Rational(3) / 16);
  CHECK(corners[2].impulse == Rational(21) / 64);
  CHECK(corners[3].impulse == Rational(51) / 256);
  // The third has got too much: its corner separates.
  CHECK(separating_velocity<Rational>(ground, cube, corners[2]) == Rational(51) / 256);
}
// [R7]

// [handed_back]
TEST_CASE("100 passes stop the cube; without taking back it gets 3 % too much and hops", "[R7]")
{
  LandingCube<double> right, wrong;
  for (int pass = 0; pass < 100; ++pass)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      ContactConstraint<double>&one = right.corners[i], &other = wrong.corners[i];
      const double closing = -separating_velocity<double>(right.ground, right.cube, one);
      add_impulse<double>(right.ground, right.cube, one, one.normal_mass * closing);
      const double left = -separating_velocity<double>(wrong.ground, wrong.cube, other);
      const double push = std::max(0.0, other.normal_mass * left); // the change, not the sum
      add_impulse<double>(wrong.ground, wrong.cube, other, push);
    }
  }
  CHECK(right.cube.motion.velocity.norm() < 1e-12);
  CHECK(right.cube.motion.angular_velocity.norm() < 1e-12);
  CHECK(wrong.cube.motion.velocity.y() > 0.03);
}

TEST_CASE("the upper of two spheres is taken away: 1 N s of the 2 is given back", "[R7]")
{
  Column<Rational> alone = column_of<Rational>({1});
  alone.contacts[0].impulse = 2;
  solve_frame<Rational>(alone, 1, 1, true);
  CHECK(alone.contacts[0].impulse == 1);
  CHECK(alone.bodies[1].motion.velocity.y() == 0);
}
// [handed_back]

// [R8]
TEST_CASE("r kg on 1 kg: each pass leaves exactly r / (1 + r) of the error", "[R8]")
{
  for (const int r : {1, 10, 100})
  {
    Column<Rational> column = column_of<Rational>({1, r});
    solve_frame<Rational>(column, 1, 0, false);
    Rational error = r;
    for (int pass = 0; pass < 20; ++pass)
    {
      solve_once(column);
      error *= Rational(r) / (1 + r);
      CHECK(r - column.contacts[1].impulse == error);
    }
  }
}
// [R8]

// [passes]
TEST_CASE("to 0.1 %, r = 1, 10, 100 take 10, 73, 695 passes: ln 1000 / ln((1 + r)/r)", "[R8]")
{
  for (const auto& [ratio, passes] : {std::pair(1.0, 10), {10.0, 73}, {100.0, 695}})
  {
    CHECK(passes == std::ceil(std::log(1000) / std::log((1 + ratio) / ratio)));
    CHECK(passes_needed({1, ratio}, 1e-3) == passes);
  }
}

TEST_CASE("n equal spheres: cos²(π/2n) of the error stays, for n = 2 to 20", "[R8]")
{
  for (const auto& [n, passes] : {std::pair(2, 7), {5, 47}, {10, 192}, {20, 776}})
  {
    const std::vector<double> masses(std::size_t(n), 1.0);
    const double cosine = std::cos(std::numbers::pi / (2 * n));
    const std::vector<double> errors = errors_by_pass(masses, 1e-9, 3000);
    const double factor = errors.back() / errors[errors.size() - 2];
    CHECK(factor == Catch::Approx(cosine * cosine).epsilon(1e-5));
    CHECK(passes_needed(masses, 0.01) == passes);
  }
}
// [passes]

// [R9]
TEST_CASE("spheres of 1, 2, 3 kg on each other press with 6, 5, 3 kg: then all is at rest", "[R9]")
{
  const std::vector<Rational> masses{1, 2, 3};
  const std::vector<Rational> impulses = carrying_impulses<Rational>(masses, Rational(1) / 6);
  CHECK(impulses == std::vector<Rational>{1, Rational(5) / 6, Rational(1) / 2});
  Column<Rational> column = column_of(masses);
  for (std::size_t i = 0; i < 3; ++i)
  {
    column.contacts[i].impulse = impulses[i];
  }
  solve_frame<Rational>(column, Rational(1) / 6, 0, true);
  for (const Body<Rational>& body : column.bodies)
  {
    CHECK(body.motion.velocity.y() == 0);
  }
}
// [R9]

// [warm]
TEST_CASE(
    "without it, two spheres sink for ever at g h ρ^k / (1 − ρ^k): 8 passes, g h / 255", "[R8]")
{
  Column<Rational> column = column_of<Rational>({1, 1});
  column.bodies[1].motion.velocity.y() = column.bodies[2].motion.velocity.y() = Rational(-1) / 255;
  solve_frame<Rational>(column, 1, 8, false);
  CHECK(column.bodies[2].motion.velocity.y() == Rational(-1) / 255);
}

TEST_CASE("warm, the velocity after a frame is ρ^k (2 v − v of the frame before): it dies", "[R8]")
{
  Column<Rational> column = column_of<Rational>({1, 10});
  const auto velocity = [&] { return column.bodies[2].motion.velocity.y(); };
  const Rational left = Rational(1000) / 1331; // three passes with 10/11
  Rational before = 0;
  solve_frame<Rational>(column, 1, 3, true);
  for (int frame = 0; frame < 12; ++frame)
  {
    const Rational now = velocity();
    solve_frame<Rational>(column, 1, 3, true);
    CHECK(velocity() == left * (2 * now - before));
    before = now;
  }
}
// [warm]
