/// \file
/// Joints in scene files: every kind as the code makes it, under every solver, and every error with
/// its line.

#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/joint_opening.hpp"
#include "06_world/scenes/trial/scene_json_file.hpp"
#include "06_world/scenes/trial/scene_text.hpp"
#include "07_constraints/joints/joints.hpp"
#include "07_constraints/joints/trial/door.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <limits>
#include <string>

using namespace cookbook;

namespace
{

/// A post, a door on it, a ball beside, and what stands in "joints", from line 6 on.
Scene joined_scene(const std::string& joints)
{
  return scene_in(
      "{\"bodies\": [\n"
      "{\"name\": \"post\", \"shape\": \"box\", \"half_extents\": [0.05, 1, 0.05], \"mass\": 0},\n"
      "{\"name\": \"door\", \"shape\": \"box\", \"half_extents\": [0.5, 1, 0.02], \"mass\": 20, "
      "\"position\": [0.5, 0, 0], \"velocity\": [0, 0, -5], \"angular_velocity\": [0, 10, 0]},\n"
      "{\"name\": \"ball\", \"shape\": \"sphere\", \"radius\": 0.1, \"mass\": 1, "
      "\"position\": [2, 0, 1], \"orientation\": [0.6, 0, 0.8, 0]}],\n"
      "\"joints\": [\n" +
          joints + "]}",
      "door.json");
}

/// A world of such a scene.
GameWorld joined_world(const std::string& joints, const std::string& solver = "direct")
{
  return GameWorld(joined_scene(joints), solver_named(solver));
}

/// What such a scene is answered with.
std::string answer_to_joints(const std::string& joints)
{
  try
  {
    joined_scene(joints);
  }
  catch (const SceneError& error)
  {
    return error.what();
  }
  return "";
}

const std::string on_post = R"("a": "post", "b": "door", "point": [0, 0, 0])";
const std::string hinge_text = R"({"kind": "hinge", "axis": [0, 1, 0], )" + on_post;

bool same(const JointFrame& a, const JointFrame& b)
{
  return a.anchor == b.anchor && a.axes.coeffs() == b.axes.coeffs();
}

bool same(const JointDrive& a, const JointDrive& b)
{
  return a.lower == b.lower && a.upper == b.upper && a.motor_speed == b.motor_speed &&
         a.motor_force == b.motor_force && a.stiffness == b.stiffness && a.damping == b.damping &&
         a.rest == b.rest;
}

const std::string drive_text =
    R"({"lower": -1, "upper": 2, "motor_speed": 3, "motor_force": 4, "stiffness": 5, "damping": 6, "rest": 7})";
const JointDrive driven{-1, 2, 3, 4, 5, 6, 7};

/// The first joint of a world's only set.
template <class Kind>
const Kind& only_joint(GameWorld& world)
{
  REQUIRE(world.constraint_sets() == 1);
  REQUIRE(world.constraints<JointSet<Kind>>(0).size() == 1);
  return world.constraints<JointSet<Kind>>(0)[0];
}

} // namespace

// [file_door]
TEST_CASE("a door from a file moves as the door of the code, to the bit, under each solver")
{
  const std::string hinge = R"({"kind": "hinge", "a": "post", "b": "door", "point": [0, 0, 0],
    "axis": [0, 1, 0], "drive": {"lower": -1.5, "upper": 1.5}})";
  for (const std::string& solver : solver_names())
  {
    CAPTURE(solver);
    GameWorld read = joined_world(hinge, solver), made = door_world(solver);
    for (int step = 0; step < 30; ++step)
    {
      read.step();
      made.step();
    }
    CHECK(read.body(1).motion.center == made.body(1).motion.center);
    CHECK(joint_opening(read).length < 0.02);
  }
}
// [file_door]

TEST_CASE("hinges, sliders and welds are read as hinge_at, slider_at and weld_at make them")
{
  GameWorld hinge = joined_world(hinge_text + ", \"drive\": " + drive_text + "}");
  const HingeJoint right = hinge_at(hinge, 0, 1, {0, 0, 0}, {0, 1, 0});
  CHECK(same(only_joint<HingeJoint>(hinge).frame_a, right.frame_a));
  CHECK(same(only_joint<HingeJoint>(hinge).frame_b, right.frame_b));
  CHECK(same(only_joint<HingeJoint>(hinge).drive, driven));
  CHECK_FALSE(only_joint<HingeJoint>(hinge).collides);

  GameWorld slider = joined_world(
      R"({"kind": "slider", "a": "door", "b": "ball", "point": [1, 0, 1], "axis": [0.6, 0.8, 0],
        "collides": true, "drive": )" +
      drive_text + "}");
  const SliderJoint line = slider_at(slider, 1, 2, {1, 0, 1}, {0.6, 0.8, 0});
  CHECK(same(only_joint<SliderJoint>(slider).frame_b, line.frame_b));
  CHECK(same(only_joint<SliderJoint>(slider).drive, driven));
  CHECK(only_joint<SliderJoint>(slider).collides);

  GameWorld weld = joined_world("{\"kind\": \"weld\", " + on_post + "}");
  CHECK(same(only_joint<WeldJoint>(weld).frame_b, weld_at(weld, 0, 1, {0, 0, 0}).frame_b));
}

TEST_CASE("a ball is a ball joint, and with an axis one with a cone and limits of its twist")
{
  GameWorld plain = joined_world("{\"kind\": \"ball\", " + on_post + "}");
  CHECK(only_joint<BallJoint>(plain).anchor_b == Vector3<double>(-0.5, 0, 0));
  GameWorld limited = joined_world(
      R"({"kind": "ball", "axis": [1, 0, 0], "cone": 0.5, "twist": {"lower": -0.1, "upper": 0.2}, )" +
      on_post + "}");
  const ConeTwistJoint& joint = only_joint<ConeTwistJoint>(limited);
  CHECK(joint.cone == 0.5);
  CHECK(joint.twist.lower == -0.1);
  CHECK(joint.twist.upper == 0.2);
  CHECK(same(joint.frame_a, cone_twist_at(limited, 0, 1, {0, 0, 0}, {1, 0, 0}).frame_a));
}

TEST_CASE("a distance is a rod as long as its ends are apart, or bounds; a rope has no least")
{
  const std::string ends =
      R"({"kind": "distance", "a": "post", "b": "ball", "point_a": [0, 0, 1], "point_b": [2, 0, 1])";
  GameWorld rod = joined_world(ends + "}");
  CHECK(only_joint<DistanceJoint>(rod).least == 2);
  CHECK(only_joint<DistanceJoint>(rod).most == 2);
  GameWorld rope = joined_world(ends + ", \"most\": 3}");
  CHECK(only_joint<DistanceJoint>(rope).least == 0);
  CHECK(only_joint<DistanceJoint>(rope).most == 3);
  GameWorld strut = joined_world(ends + ", \"least\": 1}");
  CHECK(only_joint<DistanceJoint>(strut).most == std::numeric_limits<double>::infinity());
}

TEST_CASE("a wheel sits at its body's centre, and a mouse joint drags a point to its target")
{
  GameWorld wheel = joined_world(
      R"({"kind": "wheel", "a": "door", "b": "ball", "axle": [0, 0, 1], "up": [0, 1, 0],
        "steering": 0.25, "suspension": {"stiffness": 9}, "spin": )" +
      drive_text + "}");
  const WheelJoint& joint = only_joint<WheelJoint>(wheel);
  CHECK(same(joint.frame_b, wheel_at(wheel, 1, 2, {0, 0, 1}, {0, 1, 0}).frame_b));
  CHECK(joint.steering == 0.25);
  CHECK(joint.suspension.stiffness == 9);
  CHECK(same(joint.spin, driven));

  GameWorld mouse = joined_world(
      R"({"kind": "mouse", "a": "world", "b": "ball", "point": [2, 0, 1], "target": [3, 1, 1],
        "max_force": 50, "frequency": 2, "damping_ratio": 0.5})");
  const MouseJoint& dragged = only_joint<MouseJoint>(mouse);
  CHECK(dragged.target == Vector3<double>(3, 1, 1));
  CHECK(dragged.max_force == 50);
  CHECK(dragged.frequency == 2);
  CHECK(dragged.damping_ratio == 0.5);
}

TEST_CASE("a joint with a strength breaks, and one of the world leaves collisions as they are")
{
  GameWorld weak = joined_world(
      R"({"kind": "ball", "a": "world", "b": "ball", "point": [2, 0, 1], "strength": 9},
      {"kind": "ball", "a": "ball", "b": "door", "point": [2, 0, 1]})");
  weak.step();
  CHECK(weak.constraints<BallJoints>(0).is_broken(0)); // by the ball's weight, 9.81 N, and the door
  CHECK_FALSE(weak.constraints<BallJoints>(0).is_broken(1));
  CHECK(weak.constraints<BallJoints>(0)[0].a == 0); // the post, which is fixed
  CHECK(weak.constraints<BallJoints>(0)[0].collides);
}

TEST_CASE("joints that name no kind, no body, or one body twice are refused by line")
{
  CHECK(
      answer_to_joints("\n{\"kind\": \"hing\", " + on_post + "}") ==
      "door.json:7: kind of joint number 1 must be one of ball, hinge, slider, weld, distance, "
      "wheel, mouse, got \"hing\"; did you mean hinge?");
  CHECK(answer_to_joints("{}") == "door.json:6: joint number 1 needs a member \"kind\"");
  CHECK(
      answer_to_joints("7") == "door.json:6: joint number 1 must be an object in { }, got the "
                               "number 7");
  CHECK(
      answer_to_joints(R"({"kind": "weld", "name": "lock",
      "a": "post", "b": "dor", "point": [0, 0, 0]})") ==
      "door.json:7: b of weld \"lock\" must be the name of a body, or \"world\", got \"dor\"; did "
      "you mean door?");
  CHECK(
      answer_to_joints(R"({"kind": "weld", "a": "door", "b": "door", "point": [0, 0, 0]})") ==
      "door.json:6: b of weld joint number 1 must be another body than a, got \"door\" twice");
  CHECK(
      answer_to_joints(R"({"kind": "weld", "a": "post", "b": "world", "point": [0, 0, 0]})") ==
      "door.json:6: b of weld joint number 1 must be another body than a, got the world twice");
  CHECK(
      answer_to_joints(hinge_text + ", \"cone\": 1}") ==
      "door.json:6: hinge joint number 1 has no member \"cone\"");
  CHECK(
      answer_to_joints(
          R"({"kind": "ball", "a": "world", "b": "door", "point": [0, 0, 0], "collides": true})") ==
      "door.json:6: ball joint number 1 is held by the world, which never collides");
  const std::string two = R"({"bodies": [
{"name": "one", "shape": "sphere", "radius": 1, "motion": "MOTION"},
{"name": "other", "shape": "sphere", "radius": 1, "motion": "kinematic"}],
"joints": [{"kind": "ball", "a": "A", "b": "other", "point": [0, 0, 0]}]})";
  const auto with = [&](const std::string& motion, const std::string& a)
  {
    std::string text = two;
    text.replace(text.find("MOTION"), 6, motion);
    text.replace(text.find("\"A\"") + 1, 1, a);
    return text;
  };
  CHECK_THROWS_WITH(
      scene_in(with("fixed", "world"), "s"),
      "s:4: ball joint number 1 needs a body that is dynamic, as a or b");
  CHECK_THROWS_WITH(
      scene_in(with("kinematic", "world"), "s"),
      "s:4: \"world\" needs a body that is fixed, such as a plane; the scene has none");
}

TEST_CASE("limits, axes and lengths of joints that make no sense are refused by line")
{
  CHECK(
      answer_to_joints(hinge_text + ", \"drive\": {\n\"upper\": 1,\n\"lower\": 2}}") ==
      "door.json:8: lower of drive of hinge joint number 1 must be no more than upper, 1, got 2");
  CHECK(
      answer_to_joints(hinge_text + ", \"drive\": {\"upper\": 1e999}}") ==
      "door.json:6: 1e999 is beyond the range of double");
  CHECK(
      answer_to_joints(hinge_text + ", \"drive\": {\"stiffness\": -1}}") ==
      "door.json:6: stiffness of drive of hinge joint number 1 must be 0 to 1e+30, got -1");
  CHECK(
      answer_to_joints(hinge_text + ", \"drive\": {\"motor_speed\": 1}}") ==
      "door.json:6: drive of hinge joint number 1 needs a member \"motor_force\"");
  CHECK(
      answer_to_joints(hinge_text + ", \"drive\": {\"rest\": 1}}") ==
      "door.json:6: drive of hinge joint number 1 needs a member \"stiffness\"");
  CHECK(
      answer_to_joints(hinge_text + ", \"drive\": {\"motor\": 1}}") ==
      "door.json:6: drive of hinge joint number 1 has no member \"motor\"");
  CHECK(
      answer_to_joints(hinge_text + ", \"strength\": -1}") ==
      "door.json:6: strength of hinge joint number 1 must be 0 to 1e+30, got -1");
  CHECK(
      answer_to_joints(hinge_text + ", \"collides\": 1}") ==
      "door.json:6: collides of hinge joint number 1 must be true or false, got the number 1");
  CHECK(
      answer_to_joints("{\"kind\": \"slider\", \"axis\": [0, 0, 0], " + on_post + "}") ==
      "door.json:6: axis of slider joint number 1 must be of length 1, got length 0");
  CHECK(
      answer_to_joints("{\"kind\": \"ball\", \"cone\": 0.5, " + on_post + "}") ==
      "door.json:6: ball joint number 1 needs a member \"axis\"");
  CHECK(
      answer_to_joints("{\"kind\": \"ball\", \"axis\": [1, 0, 0], \"cone\": 4, " + on_post + "}") ==
      "door.json:6: cone of ball joint number 1 must be 0 to 3.141592653589793, got 4");
  CHECK(
      answer_to_joints(R"({"kind": "wheel", "a": "door", "b": "ball",
      "axle": [0, 1, 0], "up": [0, 1, 0]})") ==
      "door.json:6: wheel joint number 1: joint: second axis lies along the first, or is zero");
  const std::string ends = R"({"kind": "distance", "a": "post", "b": "door",)";
  CHECK(
      answer_to_joints(
          ends + R"("point_a": [0, 0, 0], "point_b": [1, 0, 0], "least": 2, "most": 1})") ==
      "door.json:6: least of distance joint number 1 must be no more than most, 1, got 2");
  CHECK(
      answer_to_joints(ends + R"("point_a": [0, 0, 0], "point_b": [0, 0, 0]})") ==
      "door.json:6: distance joint number 1: joint: most is zero; a ball joint holds two points "
      "together");
}

TEST_CASE("a scene with joints of bodies that it lacks makes no world, and is not written as JSON")
{
  Scene scene = joined_scene(hinge_text + "}");
  CHECK_THROWS_WITH(scene_json(scene), "a scene with joints cannot be written as JSON");
  scene.bodies.pop_back();
  CHECK_NOTHROW(GameWorld(scene, solver_named("direct")));
  scene.bodies.pop_back();
  CHECK_THROWS_WITH(GameWorld(scene, solver_named("direct")), "scene: hinges: there is no body 1");
  scene.constraints = {nullptr};
  CHECK_THROWS_WITH(GameWorld(scene, solver_named("direct")), "scene: one of constraints is null");
}
