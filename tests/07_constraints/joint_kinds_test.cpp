/// \file
/// The rows of all kinds of joints: they say how fast the errors change, leave momentum alone, and
/// are numbers whatever the frames; and the angles of frames.

#include "06_world/contacts/start_body.hpp"
#include "06_world/game_world/game_world.hpp"
#include "06_world/game_world/trial/joint_opening.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "06_world/sequential_impulses/sequential_impulses.hpp"
#include "07_constraints/ball_limits/ball_limits.hpp"
#include "07_constraints/distance/distance.hpp"
#include "07_constraints/hinge/hinge.hpp"
#include "07_constraints/mouse/mouse.hpp"
#include "07_constraints/slider/slider.hpp"
#include "07_constraints/weld/weld.hpp"
#include "07_constraints/wheel/wheel.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/random_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <vector>

using namespace cookbook;

namespace
{

const double pi = std::numbers::pi;

/// The turn by an angle [rad] about a direction.
Quaternion<double> turn(double angle, const Vector3<double>& about)
{
  return Quaternion<double>(Eigen::AngleAxisd(angle, about.normalized()));
}

/// A number from −most to most.
double number(Random& random, double most)
{
  return random.in_cube(most).x();
}

/// Bodies, frames and a drive to make joints of.
struct Drawn
{
  RigidBody a, b;
  JointFrame frame_a, frame_b;
  JointDrive drive;
  double length, angle;
};

/// Any; `round` ones have axes along those of their bodies, anchors at one point, half turns.
Drawn drawn(Random& random, bool round)
{
  const auto body = [&](double mass)
  {
    RigidBody made = rigid_body({.name = {}, .shape = BoxShape{{0.1, 0.2, 0.4}}, .mass = mass});
    made.motion = {random.in_cube(2), random.in_cube(3), random.in_cube(5)};
    made.orientation =
        round ? turn(pi / 2 * random.whole(0, 4), Vector3<double>::Unit(random.whole(0, 2)))
              : turn(number(random, 3), random.direction());
    update_axes(made);
    return made;
  };
  const auto frame = [&] {
    return round ? JointFrame{} : JointFrame{random.in_cube(1), axes_about(random.direction())};
  };
  Drawn made{body(2),          body(3), frame(), frame(), {}, std::abs(number(random, 2)),
             number(random, 9)};
  if (round)
  {
    made.b.motion.center = made.a.motion.center;
  }
  made.drive = {
      .lower = -0.5,
      .upper = 0.7,
      .motor_speed = 2,
      .motor_force = 5,
      .stiffness = 50,
      .damping = 2};
  return made;
}

/// The rows of each kind of joint of what was drawn, kind by kind; `bodies` in its place.
std::vector<JointRows> rows_of(const Drawn& by, const RigidBody& a, const RigidBody& b)
{
  std::vector<JointRows> all(8);
  const double step = 1.0 / 240;
  const auto& [anchor_a, axes_a] = by.frame_a;
  const auto& [anchor_b, axes_b] = by.frame_b;
  joint_rows(WeldJoint{0, 1, by.frame_a, by.frame_b}, a, b, step, all[0]);
  joint_rows(
      HingeJoint{0, 1, by.frame_a, by.frame_b, by.drive, false, by.angle}, a, b, step, all[1]);
  joint_rows(SliderJoint{0, 1, by.frame_a, by.frame_b, by.drive}, a, b, step, all[2]);
  joint_rows(
      ConeTwistJoint{0, 1, by.frame_a, by.frame_b, 1, by.drive, false, by.angle}, a, b, step,
      all[3]);
  joint_rows(
      WheelJoint{0, 1, by.frame_a, by.frame_b, by.drive, by.drive, 0.3, false, by.angle}, a, b,
      step, all[4]);
  joint_rows(DistanceJoint{0, 1, anchor_a, anchor_b, by.length, by.length}, a, b, step, all[5]);
  joint_rows(DistanceJoint{0, 1, anchor_a, anchor_b, 0, by.length}, a, b, step, all[6]);
  joint_rows(MouseJoint{0, 1, anchor_a, anchor_b}, a, b, step, all[7]);
  return all;
}

/// A body once it has moved with its velocities for a time [s], before or after.
RigidBody moved(RigidBody body, double time)
{
  body.motion.center += time * body.motion.velocity;
  turn_by(body, time * body.motion.angular_velocity);
  return body;
}

/// How near the errors of frames are to a jump: both axes opposite, half a turn, one point.
bool near_jump(const Drawn& by)
{
  const FramePose pose = frame_pose(by.a, by.b, by.frame_a, by.frame_b);
  const FramePose steered = frame_pose(
      by.a, by.b, {by.frame_a.anchor, by.frame_a.axes * turn(0.3, {0, 1, 0})}, by.frame_b);
  const double swing = pose.a.col(0).dot(pose.b.col(0));
  return std::min(swing, steered.a.col(0).dot(steered.b.col(0))) < -0.98 || swing > 0.999 ||
         std::abs(pose.turned.w()) < 0.1 || pose.apart.norm() < 0.05;
}

} // namespace

// [joint_jacobians]
TEST_CASE(
    "J v is the derivative of C to 1e-6 for every row of every kind, on 10,000 random frames",
    "[R54][R55][R56][R58][R59][R60][R61]")
{
  Random random(54);
  double most = 0;
  for (int i = 0; i < inputs(10'000, 200); ++i)
  {
    const Drawn by = drawn(random, false);
    if (near_jump(by))
    {
      continue;
    }
    const double time = 1e-6;
    const std::vector<JointRows> now = rows_of(by, by.a, by.b);
    const std::vector<JointRows> before = rows_of(by, moved(by.a, -time), moved(by.b, -time));
    const std::vector<JointRows> after = rows_of(by, moved(by.a, time), moved(by.b, time));
    for (std::size_t kind = 0; kind < now.size(); ++kind)
    {
      for (std::size_t k = 0; k < now[kind].size(); ++k)
      {
        const ConstraintRow& row = now[kind][k];
        const double change = (after[kind][k].error - before[kind][k].error) / (2 * time);
        const double speed = row.motor ? 0 : row_speed(row, by.a.motion, by.b.motion);
        most = std::max(most, std::abs(speed - change));
      }
    }
  }
  CHECK(most <= 1e-6);
}
// [joint_jacobians]

TEST_CASE(
    "no row of any kind gives two bodies linear or angular momentum, nor is one not a number, on "
    "20,000 frames, of which half are degenerate",
    "[R54][R55][R56][R58][R59][R60][R61]")
{
  Random random(55);
  double linear = 0, angular = 0;
  bool numbers = true;
  for (int i = 0; i < inputs(20'000, 200); ++i)
  {
    const Drawn by = drawn(random, i % 2 == 0);
    for (const JointRows& rows : rows_of(by, by.a, by.b))
    {
      for (const ConstraintRow& row : rows.all())
      {
        const Vector3<double> on_a = row.a.head<3>(), on_b = row.b.head<3>();
        const Vector3<double> turned = row.a.tail<3>() + row.b.tail<3>() +
                                       by.a.motion.center.cross(on_a) +
                                       by.b.motion.center.cross(on_b);
        linear = std::max(linear, (on_a + on_b).norm());
        angular = std::max(angular, turned.norm() / (1 + row.a.norm() + row.b.norm()));
        numbers = numbers && row.a.allFinite() && row.b.allFinite() && std::isfinite(row.error) &&
                  std::isfinite(row.turning) && std::isfinite(row.pulls) && row.keeps <= 1;
      }
    }
  }
  CHECK(linear == 0);
  CHECK(angular <= 1e-14);
  CHECK(numbers);
}

TEST_CASE("axes about a line turn x onto it; about -x by half a turn about y", "[R54]")
{
  CHECK(axes_about({1, 0, 0}).coeffs() == Quaternion<double>(1, 0, 0, 0).coeffs());
  CHECK(axes_about({-2, 0, 0}).coeffs() == Quaternion<double>(0, 0, 1, 0).coeffs());
  Random random(56);
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3<double> axis =
        i % 2 == 0 ? random.direction() : Vector3<double>(-1, number(random, 1e-7), 1e-9);
    const Vector3<double> x = axes_about(axis) * Vector3<double>::UnitX();
    CHECK((x - axis.normalized()).norm() <= 1e-15);
  }
  const Quaternion<double> both = axes_about({0, 0, 3}, {1, 1, 5});
  CHECK((both * Vector3<double>::UnitX() - Vector3<double>(0, 0, 1)).norm() <= 1e-15);
  CHECK((both * Vector3<double>::UnitY() - Vector3<double>(1, 1, 0).normalized()).norm() <= 1e-15);
}

TEST_CASE("an axis of zero, not finite, or along the first is refused; so is a frame that is none")
{
  CHECK_THROWS_WITH(axes_about({0, 0, 0}), "joint: axis is zero");
  CHECK_THROWS_AS(axes_about({0, 1 / 0.0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(axes_about({0, 1, 0}, {0, -2, 0}), std::invalid_argument);
  JointFrame none;
  none.axes.coeffs().setZero();
  CHECK_THROWS_WITH(
      check_joint(WeldJoint{0, 1, {}, none}),
      "joint: frame_b.axes have the length 0.000000, not 1");
  JointDrive drive{.lower = 1, .upper = 0};
  CHECK_THROWS_WITH(
      check_joint(HingeJoint{0, 1, {}, {}, drive}),
      "joint: drive.lower is 1.000000; it must be no more than upper");
  CHECK_THROWS_AS(check_joint(SliderJoint{0, 1, {}, {}, {.damping = -1}}), std::invalid_argument);
  CHECK_THROWS_AS(
      check_joint(DistanceJoint{0, 1, {0, 0, 0}, {0, 0, 0}, 2, 1}), std::invalid_argument);
  CHECK_THROWS_AS(check_joint(ConeTwistJoint{0, 1, {}, {}, 4}), std::invalid_argument);
  CHECK_THROWS_AS(check_joint(MouseJoint{0, 1, {0, 0, 0}, {0, 0, 0}, -1}), std::invalid_argument);
}

// [twist]
TEST_CASE(
    "the twist of B is right-handed about A's axis, and counts on beyond half a turn", "[R56]")
{
  RigidBody a = rigid_body({.name = {}, .shape = BoxShape{{1, 1, 1}}, .mass = 1}), b = a;
  const JointFrame frame{{0, 0, 0}, axes_about({0, 1, 0})};
  HingeJoint hinge{0, 1, frame, frame};
  for (double angle = 0; angle <= 20; angle += 3)
  {
    b.orientation = turn(angle, {0, 1, 0});
    follow_joint(hinge, a, b);
    CHECK(hinge.angle == Catch::Approx(angle).margin(1e-12));
  }
  b.orientation = turn(pi, {1, 0, 0}); // B's axis lies opposite to A's: no twist
  CHECK(std::abs(twist_of(frame_pose(a, b, frame, frame))) <= 1e-12);
}
// [twist]

// [limit_alone]
TEST_CASE(
    "a limit that feels how a door turns about its centre leaves 7.4 of 10 rad/s, one that "
    "feels it about the hinge none",
    "[R57]")
{
  const RigidBody frame = rigid_body({.name = {}, .shape = BoxShape{{1, 1, 1}}});
  const double m = 12, r = 0.5, i = m / 12 * (1 + 0.04); // a door of 1 m by 20 cm
  RigidBody door = rigid_body({.name = {}, .shape = BoxShape{{0.5, 1, 0.1}}, .mass = m});
  door.motion = {{r, 0, 0}, {0, 0, -10 * r}, {0, 10, 0}};
  const JointFrame axis{{0, 0, 0}, axes_about({0, 1, 0})};
  const HingeJoint hinge{0, 1, axis, {{-r, 0, 0}, axis.axes}, {.upper = 0}};
  JointRows rows;
  joint_rows(hinge, frame, door, 1.0 / 60, rows);
  REQUIRE(rows.size() == 6);
  for (const bool alone : {true, false})
  {
    RigidBody a = frame, b = door;
    const Eigen::LDLT<RigidMatrix> factor(rigid_inverse_mass(rows, a, b));
    JointImpulses impulses{};
    if (alone)
    {
      push_along(b, rows[5].b, -row_mass(rows[5], a, b) * row_speed(rows[5], a.motion, b.motion));
    }
    else
    {
      solve_row(rows, 5, factor, a, b, rigid<double>(), 1.0 / 60, impulses);
    }
    solve_rigid(rows, factor, a, b, rigid<double>(), 0, impulses);
    const double left = alone ? 10 * m * r * r / (i + m * r * r) : 0;
    CHECK(b.motion.angular_velocity.y() == Catch::Approx(left).margin(1e-12));
  }
}
// [limit_alone]

/// How far [m] the joints of three arms, one below the other, come apart in 4 s under sequential
/// impulses of 64 passes. `joint_at(world, above, point)` joins a body and the next; the lowest arm
/// begins with a spin that no joint lets it keep.
template <class JointAt>
double nudged_arms_open(const JointAt& joint_at)
{
  Scene scene{.bodies = {box_body("post", {0.1, 0.1, 0.1}, {0, 0, 0}, 0)}};
  for (int i = 0; i < 3; ++i)
  {
    scene.bodies.push_back(box_body("arm", {0.05, 0.15, 0.05}, {0, -0.15 - 0.3 * i, 0}, 2));
    scene.ignored.emplace_back(i, i + 1);
  }
  scene.bodies.back().angular_velocity = {0, 0, 0.001};
  const SequentialSettings how{.iterations = 64};
  GameWorld world(
      scene, one_by_one([how](IslandView w, const Island& island, double h)
                        { sequential_impulses(w, island, h, how); }));
  JointSet<decltype(joint_at(world, BodyId(), Vector3<double>()))> joints;
  for (int i = 0; i < 3; ++i)
  {
    joints.add(joint_at(world, static_cast<BodyId>(i), Vector3<double>(0, -0.3 * i, 0)));
  }
  world.add(joints);
  double open = 0;
  for (int frame = 0; frame < 240; ++frame)
  {
    world.step();
    open = std::max(open, joint_opening(world).length);
  }
  return open;
}

TEST_CASE(
    "three hinges or sliders in a row, nudged: 64 passes hold them to a micrometre", "[R54][R56]")
{
  // By gravity's speed before the solve they burst within 121 frames.
  CHECK(
      nudged_arms_open(
          [](GameWorld& world, BodyId above, const Vector3<double>& point) {
            return hinge_at(world, above, above + 1, point, {1, 0, 0});
          }) < 1e-6);
  CHECK(
      nudged_arms_open(
          [](GameWorld& world, BodyId above, const Vector3<double>& point)
          {
            SliderJoint slider = slider_at(world, above, above + 1, point, {1, 0, 0});
            slider.drive.lower = -1;
            slider.drive.upper = 1;
            return slider;
          }) < 1e-6);
}
