/// \file
/// The first joints: a point on a rod, and a ball joint in the small world.

#include "07_constraints/first_joint/first_joint.hpp"
#include "07_constraints/first_joint/joined_step.hpp"
#include "07_constraints/first_joint/small_joint.hpp"
#include "07_constraints/first_joint/trial/rod_swings.hpp"
#include "07_constraints/springs/trial/spring_measure.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

using namespace cookbook;

namespace
{

using RodPoint = PhasePoint<Vector3<double>>;

const Vector3<double> nothing(0, 0, 0);

} // namespace

// [R41]
TEST_CASE(
    "the impulse −J v/(J M⁻¹ Jᵀ) leaves no velocity along the rod, and all across it", "[R41]")
{
  const Rod<double> rod{1, 0, 0};
  const RodPoint from{{0.6, -0.8, 0}, {1, 2, 3}}; // on the rod, J = (0.6, −0.8, 0)
  const RodPoint next = rod_step<double>(from, rod, nothing, 0.01);
  // J v = −1: the impulse is +1 along J for each kilogram, whatever the mass is
  CHECK((next.velocity - Vector3<double>(1.6, 1.2, 3)).norm() <= 1e-15);
  CHECK((next.position - from.position - 0.01 * next.velocity).norm() <= 1e-15);
}

TEST_CASE("between the centres of 1 and 3 kg an impulse feels 3/4 kg, in all directions", "[R41]")
{
  namespace small = small_world;
  const small::RigidBody a = small::sphere({0, 0, 0}, 0.1, 1), b = small::sphere({1, 0, 0}, 0.1, 3);
  const Arms<double> centers{nothing, nothing};
  const Vector3<double> along(1, 0, 0);
  CHECK(inverse_mass_at<double>(a, b, along, centers) == Catch::Approx(4.0 / 3).epsilon(1e-14));
  const Matrix3<double> k = joint_inverse_mass(a, b, centers);
  CHECK((k - 4.0 / 3 * Matrix3<double>::Identity()).norm() <= 1e-14);
}
// [R41]

// [R42]
TEST_CASE("a rod 10 cm too long is 0.1 (1 − β)ⁿ m too long after n steps", "[R42]")
{
  for (const double beta : {0.2, 0.5, 1.0})
  {
    const Rod<double> rod{1, beta, 1};
    RodPoint at{{0, -1.1, 0}, nothing};
    for (int step = 1; step <= 10; ++step)
    {
      at = rod_step<double>(at, rod, nothing, 1.0 / 60);
      CHECK(std::abs(at.position.norm() - 1 - 0.1 * std::pow(1 - beta, step)) <= 1e-14);
    }
  }
}

TEST_CASE("an ever stiffer spring becomes the rigid joint: at 1e9 Hz to 1e-7", "[R42]")
{
  const double step = 1.0 / 240;
  const Softness<double> stiff = softness(1e9, 1.0, step);
  const Softness<double> limit = small_world::rigid_joint(step);
  CHECK(stiff.bias_rate == Catch::Approx(limit.bias_rate).epsilon(1e-7));
  CHECK(stiff.mass_scale == Catch::Approx(limit.mass_scale).epsilon(1e-12));
  CHECK(stiff.impulse_scale == Catch::Approx(limit.impulse_scale).margin(1e-12));
  const auto [keeps, pulls] = spring_coefficients(1e9, 0.0, step); // and so does the exact one
  CHECK(pulls == Catch::Approx(-limit.bias_rate).epsilon(1e-12));
  CHECK(keeps <= 1e-12);
}
// [R42]

// [R43]
TEST_CASE("a point that goes round at 3 m/s is h² v²/(2 β L) off its rod, to 1 %", "[R43]")
{
  const double step = 1.0 / 240, speed = 3, length = 1;
  for (const double beta : {0.2, 0.5, 1.0})
  {
    RodPoint at{{length, 0, 0}, {0, speed, 0}}, turned = at;
    for (int i = 0; i < 480; ++i)
    {
      at = rod_step<double>(at, {length, beta, 0}, nothing, step);
      turned = rod_step<double>(turned, {length, beta, 1}, nothing, step);
    }
    const double gap = step * step * speed * speed / (2 * beta * length);
    CHECK(at.position.norm() - length == Catch::Approx(gap).epsilon(0.01));
    CHECK(std::abs(turned.position.norm() - length) <= 1e-3 * gap); // with what turning adds
    CHECK(at.velocity.norm() == Catch::Approx(speed).epsilon(1e-3));
  }
}
// [R43]

// [loses]
TEST_CASE(
    "without what turning adds and β = 0.2 a pendulum from 86° loses a third of its energy",
    "[R43]")
{
  const PendulumRun run = rod_swing({.amplitude = 1.5}, {1, 0.2, 0});
  CHECK(run.left == Catch::Approx(0.65).margin(0.01));
  CHECK(run.apart > 0.01); // [m]
  const PendulumRun turned = rod_swing({.amplitude = 1.5}, {1, 0.2, 1});
  CHECK(turned.left == Catch::Approx(1).margin(0.005));
  CHECK(turned.apart < 2e-5);
}

TEST_CASE(
    "a rod that only holds the velocity is more than a metre too long after a minute", "[R43]")
{
  CHECK(rod_swing({.amplitude = 1.5}, {1, 0, 0}).apart > 1);
}
// [loses]

// [period]
TEST_CASE(
    "points on rods and planks on joints have the elliptic period, to 1e-4, and keep .998", "[R31]")
{
  for (const double amplitude : {0.5, 1.5})
  {
    CAPTURE(amplitude);
    const PendulumRun rod = rod_swing({.amplitude = amplitude, .rate = 240}, {1});
    CHECK(rod.period == Catch::Approx(rod.right).epsilon(1e-4));
    CHECK(rod.left == Catch::Approx(1).margin(0.002));
    CHECK(rod.apart < 1e-6); // [m]
    const PendulumRun plank = plank_swing({.amplitude = amplitude, .rate = 120});
    CHECK(plank.period == Catch::Approx(plank.right).epsilon(1e-4));
    CHECK(plank.left == Catch::Approx(1).margin(0.002));
    CHECK(plank.apart < 1e-4);
  }
  const PendulumRun plank = plank_swing({.amplitude = 0.5, .rate = 60});
  CHECK(plank.period == Catch::Approx(plank.right).epsilon(1e-4));
}
// [period]

// [chains]
TEST_CASE(
    "a chain of five rigid joints bursts; of soft ones five hold to 2 mm, twenty to 1 cm", "[R42]")
{
  CHECK(chain_apart(5, 1, small_world::rigid_joint) > 1);
  CHECK(chain_apart(5, 1) < 0.002);
  CHECK(chain_apart(20, 1) < 0.01);
  CHECK(chain_apart(20, 100) < 0.04); // 100 kg below 19 links of 1 kg
}
// [chains]

TEST_CASE("a joint between two turning boxes keeps their momenta to 1e-12", "[R36]")
{
  using namespace small_world;
  World world;
  add(world, box({0, 0, 0}, {0.1, 0.2, 0.3}, 1));
  add(world, box({1, 0, 0}, {0.3, 0.1, 0.2}, 4));
  world.bodies[0].motion.angular_velocity = {1, 2, 3};
  world.bodies[1].motion.velocity = {-1, 0, 2};
  const auto momenta = [&]
  {
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    for (const RigidBody& body : world.bodies)
    {
      const Vector3<double> momentum = body.motion.velocity / body.inverse_mass;
      const Vector3<double> spin = body.inverse_inertia.inverse() * body.motion.angular_velocity;
      sum.head<3>() += momentum;
      sum.tail<3>() += body.motion.center.cross(momentum) + spin;
    }
    return sum;
  };
  BallJoint joint = ball_joint_at(world, 0, 1, {0.5, 0.1, 0});
  joint.anchor_b.x() += 0.01; // with an error
  const Eigen::Matrix<double, 6, 1> before = momenta();
  prepare_joint(world, joint, 1.0 / 240);
  solve_joint(world, joint, rigid_joint(1.0 / 240));
  CHECK(joint.impulse.norm() > 0.1);
  CHECK((momenta() - before).norm() <= 1e-12);
}

TEST_CASE("a world stepped with an empty list of joints has the bits of one stepped without")
{
  using namespace small_world;
  World with, without;
  for (World* world : {&with, &without})
  {
    add(*world, box({0, -1, 0}, {10, 1, 10}, 0));
    add(*world, box({0, 0.6, 0}, {0.5, 0.5, 0.5}, 1));
    add(*world, sphere({0.3, 2, 0}, 0.4, 1));
  }
  std::vector<BallJoint> none;
  for (int frame = 0; frame < 120; ++frame)
  {
    step_joined(with, none, 1.0 / 60);
    step(without, 1.0 / 60);
  }
  CHECK(with.bodies[2].motion.center == without.bodies[2].motion.center);
  CHECK(with.bodies[1].orientation.coeffs() == without.bodies[1].orientation.coeffs());
}

TEST_CASE("joined bodies pass through each other and stay awake; others fall asleep")
{
  using namespace small_world;
  World world;
  add(world, box({0, -1, 0}, {10, 1, 10}, 0));
  add(world, box({0, 0.5, 0}, {0.5, 0.5, 0.5}, 1));
  add(world, box({0.8, 0.5, 0}, {0.5, 0.5, 0.5}, 1)); // overlaps the first
  add(world, box({5, 0.5, 0}, {0.5, 0.5, 0.5}, 1));
  std::vector<BallJoint> joints{ball_joint_at(world, 1, 2, {0.4, 0.5, 0})};
  for (int frame = 0; frame < 120; ++frame)
  {
    step_joined(world, joints, 1.0 / 60);
  }
  CHECK(world.bodies[2].motion.center.x() == Catch::Approx(0.8).margin(1e-3));
  CHECK_FALSE(is_asleep(world, 1));
  CHECK(is_asleep(world, 3));
}

TEST_CASE("a joint of two fixed bodies, of one with itself, or of one that is not there is refused")
{
  using namespace small_world;
  World world;
  add(world, box({0, 0, 0}, {1, 1, 1}, 0));
  add(world, box({3, 0, 0}, {1, 1, 1}, 0));
  add(world, box({6, 0, 0}, {1, 1, 1}, 1));
  CHECK_THROWS_AS(ball_joint_at(world, 0, 1, {0, 0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(ball_joint_at(world, 2, 2, {0, 0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(ball_joint_at(world, 0, 7, {0, 0, 0}), std::out_of_range);
}

TEST_CASE("a point at the hook itself goes on without a NaN")
{
  const RodPoint next = rod_step<double>({nothing, nothing}, {1}, {0, -9.81, 0}, 1.0 / 60);
  CHECK(next.position.allFinite());
  CHECK(next.velocity.allFinite());
}
