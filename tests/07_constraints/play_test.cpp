/// \file
/// The live figure in which a reader throws balls at scenes, drags bodies and opens files.

#include "06_world/game_world/trial/joint_opening.hpp"
#include "06_world/scenes/trial/scene_text.hpp"
#include "07_constraints/joint_trial/trial/live_joints.hpp"
#include "07_constraints/play/trial/play_joints.hpp"
#include "07_constraints/play/trial/play_world.hpp"
#include "tools/live/session.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <string>
#include <vector>

using Catch::Approx;
using namespace cookbook;
using namespace cookbook::play;

namespace
{

using live::Session;

/// What stands beside a name among the numbers.
std::string shown(const Session& session, const std::string& name)
{
  for (const live::Reading& one : session.readings())
  {
    if (one.name == name)
    {
      return one.value;
    }
  }
  return "";
}

const live::File two_crates{"two crates.json", R"({"bodies": [
  {"name": "floor", "shape": "plane", "normal": [0, 1, 0], "offset": 0},
  {"name": "one", "shape": "box", "half_extents": [0.5, 0.5, 0.5], "mass": 1, "position": [0, 0.5, 0]},
  {"name": "two", "shape": "box", "half_extents": [0.5, 0.5, 0.5], "mass": 1, "position": [0, 1.5, 0]}
]})"};

/// A cube of 1 kg that is held at the middle of its front, without gravity.
Play held_cube(const Vector3<double>& target)
{
  Scene scene{.gravity = {0, 0, 0}};
  scene.bodies.push_back(cube_body("cube", {0, 0, 0}));
  Play play(scene, false);
  take_hold(play, {{0, 0, 9}, {0, 0, -1}});
  play.hand.held->target = target;
  return play;
}

} // namespace

TEST_CASE("a held cube is within a millimetre of the pointer after two seconds", "[play]")
{
  Play play = held_cube({2, 1, 0});
  for (int i = 0; i < 120; ++i)
  {
    step(play);
  }
  const RigidBody& cube = play.world.body(0);
  const Vector3<double> held = cube.motion.center + cube.orientation * play.hand.held->anchor;
  CHECK((held - Vector3<double>(2, 1, 0)).norm() < 1e-3);
}

TEST_CASE("the pointer pulls 1 kg by at most 100 N, however far it is away", "[play]")
{
  Play play = held_cube({1e6, 0, 0});
  step(play);
  CHECK(play.world.body(0).motion.velocity.x() == Approx(100.0 / 60));
}

TEST_CASE("a ball thrown at the middle of the wall hits it within a second", "[play]")
{
  Play play(scenes::wall(5), true);
  const Vector3<double> eye(0, 2, 15), aim(0, 1.25, 0);
  throw_ball(play, {eye, (aim - eye).normalized()}, {20, 25});
  const BodyId ball = play.thrown.front();
  Vector3<double> met_at(0, 0, 0);
  for (int i = 0; i < 60 && met_at.isZero(0); ++i)
  {
    step(play);
    for (const Impact& impact : play.world.impacts())
    {
      met_at = play.world.body(ball).motion.center;
      CHECK(impact.speed > 10);
    }
  }
  CHECK(std::abs(met_at.x()) < 0.1);
  CHECK(met_at.y() == Approx(1.25).margin(0.15));
}

TEST_CASE("of 25 balls that are thrown the last 20 stay", "[play]")
{
  Play play(scenes::tower(2), true);
  for (int i = 0; i < 25; ++i)
  {
    throw_ball(play, {{0, 5, 20}, {0, 0, 1}}, {1, 5});
    step(play);
  }
  CHECK(play.thrown.size() == 20);
  CHECK(play.world.scene().bodies[play.world.index(play.thrown.front())].name == "thrown_6");
}

TEST_CASE("another solver wakes what sleeps", "[play]")
{
  Session session(live::figure);
  session.send("set scene 1\nstep 120");
  CHECK(shown(session, "bodies awake") == "0 of 10");
  CHECK(session.resting());
  session.send("set solver 4\nstep 1");
  CHECK(shown(session, "bodies awake") == "10 of 10");
}

TEST_CASE("a scene file is opened, and another choice of scene closes it", "[play]")
{
  Session session(live::figure);
  session.send(live::file_event("scene file", two_crates));
  CHECK(shown(session, "bodies awake") == "2 of 2");
  session.send("set scene 1");
  CHECK(shown(session, "bodies awake") == "10 of 10");
  session.send("reset");
  CHECK(shown(session, "bodies awake") == "10 of 10");
}

TEST_CASE("joints of a scene file are marked where they are, and do not open", "[play]")
{
  const live::File door{"door.json", R"({"bodies": [
    {"name": "post", "shape": "box", "half_extents": [0.1, 1, 0.1], "mass": 0, "position": [0, 1, 0]},
    {"name": "door", "shape": "box", "half_extents": [0.5, 1, 0.1], "mass": 20, "position": [1, 1, 0]}
  ], "joints": [
    {"kind": "hinge", "a": "post", "b": "door", "point": [0.3, 1, 0], "axis": [0, 1, 0]},
    {"kind": "distance", "a": "post", "b": "door", "point_a": [0, 2, 0], "point_b": [1, 2, 0], "least": 0, "most": 3}
  ]})"};
  Play play(scene_in(door.text, door.name), false);
  const std::vector<JointMark> marks = joint_marks(play.world, play.hand.place);
  REQUIRE(marks.size() == 2);
  CHECK(marks[0].anchor_b.isApprox(Vector3<double>(-0.7, 0, 0)));
  CHECK(marks[0].axis_a.value().isApprox(Vector3<double>(0, 1, 0)));
  CHECK(marks[0].together);
  CHECK(!marks[1].together);
  Session session(live::figure);
  CHECK(shown(session, "joints open by").empty());
  session.send(live::file_event("scene file", door) + "\nset solver 0\nstep 60");
  CHECK(std::stod(shown(session, "joints open by")) < 0.01);
}

TEST_CASE("a ton on a chain is dragged by 500 N, and no joint opens by a micrometre", "[play]")
{
  const auto chain = play_joints(live_joints()[0], 1000, solver_named("direct"), 1.0 / 60);
  const Vector3<double> load = chain->world.body(21).motion.center, front(0, 0, 9);
  const auto force = [](const RigidBody&) { return 500.0; };
  REQUIRE(take_hold(chain->world, chain->hand, {load + front, {0, 0, -1}}, force));
  CHECK(chain->hand.held->body == 21);
  chain->hand.held->target.z() += 100;
  double open = 0, pull = 0;
  for (int i = 0; i < 60; ++i)
  {
    step(*chain);
    open = std::max(open, joint_opening(chain->world).length);
    pull = std::max(pull, 60 * joints_of(chain->world, chain->hand).impulses(0)[2]);
  }
  CHECK(open < 1e-6);
  CHECK(pull == Approx(500));
}

TEST_CASE("a ragdoll that has fallen lies with its joints closed to a micrometre", "[play]")
{
  const auto ragdoll = play_joints(live_joints().back(), 1, solver_named("direct"), 1.0 / 60);
  for (int i = 0; i < 240; ++i)
  {
    step(*ragdoll);
  }
  CHECK(ragdoll->world.body(2).motion.center.y() == Approx(0.13).margin(0.01)); // its head
  CHECK(joint_opening(ragdoll->world).length < 1e-6);
}

TEST_CASE("a file that cannot be read leaves everything as it was", "[play]")
{
  Session session(live::figure);
  session.send("set scene 1\nstep 30");
  session.send(live::file_event("scene file", two_crates) + "\nstep 30");
  const std::string numbers = session.numbers(), state = session.state();
  CHECK_THROWS_WITH(
      session.send(live::file_event("scene file", {"bad.json", "{\n  \"bodies\": ["})),
      "bad.json:2: the file ends too early");
  CHECK_THROWS(session.send("file scene_file half%4 x"));
  CHECK(session.numbers() == numbers);
  CHECK(session.state() == state);
  session.send("step 1");
  CHECK(shown(session, "bodies awake") == "2 of 2");
  CHECK(session.step() == 31);
}

TEST_CASE("a link to a state with file, drag and throw shows the same numbers", "[play]")
{
  Session session(live::figure);
  session.send(live::file_event("scene file", two_crates));
  session.send("step 20\npress throw_a_ball\nstep 10\npointer 320 200 down\nstep 3");
  session.send("pointer 400 150 move\nstep 20\npointer 400 150 up\nstep 5");
  Session other(live::figure);
  other.send("restore " + session.state());
  CHECK(other.numbers() == session.numbers());
  CHECK(other.state() == session.state());
}
