/// \file
/// Many contacts at a time: each lane does to the bit what one contact alone would, whatever the
/// processor's registers hold, and scenes come out as one by one.

#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "06_world/contact_graph/trial/contact_graph_scenes.hpp"
#include "06_world/contacts/start_body.hpp"
#include "06_world/direct_solver/trial/direct_solver_scenes.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/wide_passes/wide_passes.hpp"
#include "06_world/wide_solver/trial/wide_solver_runs.hpp"
#include "06_world/wide_solver/wide_solver.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace
{

using namespace cookbook;

WorldRun widely(const std::string& scene, int substeps, double duration)
{
  return run_world(
      named_scene(scene),
      {.solver = "wide_steps", .substeps = substeps, .duration = duration, .keeps_frames = true});
}

GameWorld wide_world(const Scene& scene, int substeps = 4)
{
  return GameWorld(scene, solver_named("wide_steps", substeps));
}

using Four = Pack<float, 4>;

/// One lane of a vector.
template <int Size>
Vector<float, Size> lane_of(const Vector<Four, Size>& v, std::size_t lane)
{
  Vector<float, Size> one;
  for (int i = 0; i < Size; ++i)
  {
    one[i] = v[i][lane];
  }
  return one;
}

/// Sets one lane of a vector or matrix.
template <int Rows, int Columns>
void set_lane(
    Eigen::Matrix<Four, Rows, Columns>& to, std::size_t lane,
    const Eigen::Matrix<float, Rows, Columns>& from)
{
  for (int i = 0; i < Rows * Columns; ++i)
  {
    to(i).lanes[lane] = from(i);
  }
}

/// Two bodies and a contact point between them.
struct OneContact
{
  Body<float> a, b;
  ContactConstraint<float> at;
};

/// Four of them, one in each lane.
struct FourContacts
{
  WideContact<Four> of;
  ContactConstraint<Four> at;
};

/// A body with a mass of about 1 kg; one in eight cannot move.
Body<float> drawn_body(BoxDraw& draw)
{
  const bool fixed = draw.whole(8) == 0;
  const Vector3<double> moments = Vector3<double>(0.1, 0.1, 0.1) + draw.vector(0, 1).cwiseAbs2();
  const Matrix3<double> inertia = world_inverse_inertia<double>(moments, draw.rotation());
  const double mass = fixed ? 0 : draw.between(0.5, 4);
  const Matrix3<double> felt = fixed ? Matrix3<double>::Zero() : inertia;
  const Vector3<float> speed = draw.vector(-2, 2).cast<float>();
  const Vector3<float> turning = draw.vector(-2, 2).cast<float>();
  return {{Vector3<float>::Zero(), speed, turning}, static_cast<float>(mass), felt.cast<float>()};
}

OneContact drawn_contact(BoxDraw& draw)
{
  const Body<float> a = drawn_body(draw), b = drawn_body(draw);
  const Vector3<double> normal = draw.direction();
  const Vector3<double> arm_a = draw.vector(-1, 1), arm_b = draw.vector(-1, 1);
  const Vector3<float> along = normal.cast<float>();
  const Arms<float> arms{arm_a.cast<float>(), arm_b.cast<float>()};
  ContactConstraint<float> at{along, surface_axes(along),        arms, 0, 0, 0, 0, {0, 0},
                              0,     {Matrix2<float>::Zero(), 0}};
  at.coefficient = static_cast<float>(draw.between(0, 1));
  at.separation = static_cast<float>(draw.between(-0.05, 0.05));
  at.impulse = draw.whole(2) == 0 ? 0.0f : static_cast<float>(draw.between(0, 2));
  at.friction = at.surface.along(at.impulse / 4 * normal.unitOrthogonal().cast<float>());
  return {a, b, at};
}

void set_lane(Body<Four>& to, std::size_t lane, const Body<float>& from)
{
  set_lane(to.motion.velocity, lane, from.motion.velocity);
  set_lane(to.motion.angular_velocity, lane, from.motion.angular_velocity);
  to.inverse_mass.lanes[lane] = from.inverse_mass;
  set_lane(to.inverse_inertia, lane, from.inverse_inertia);
}

void set_lane(FourContacts& to, std::size_t lane, const OneContact& from)
{
  set_lane(to.of.a, lane, from.a);
  set_lane(to.of.b, lane, from.b);
  set_lane(to.at.normal, lane, from.at.normal);
  set_lane(to.at.surface.u, lane, from.at.surface.u);
  set_lane(to.at.surface.w, lane, from.at.surface.w);
  set_lane(to.at.arms.a, lane, from.at.arms.a);
  set_lane(to.at.arms.b, lane, from.at.arms.b);
  set_lane(to.at.friction, lane, from.at.friction);
  to.at.coefficient.lanes[lane] = from.at.coefficient;
  to.at.separation.lanes[lane] = from.at.separation;
  to.at.impulse.lanes[lane] = from.at.impulse;
}

/// True if two numbers have the same bits.
template <int Size>
bool same(const Vector<float, Size>& a, const Vector<float, Size>& b)
{
  const auto alike = [](float x, float y)
  { return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y); };
  return std::equal(a.begin(), a.end(), b.begin(), alike);
}

} // namespace

// [lanes]
TEST_CASE("each lane does to the bit what one contact alone does: masses, pushes, friction")
{
  BoxDraw draw(1);
  const Softness<float> spring = softness(30.0f, 5.0f, 1.0f / 240);
  const Softness<Four> wide_spring{spring.bias_rate, spring.mass_scale, spring.impulse_scale};
  const float substep = 1.0f / 240;
  for (int i = 0; i < inputs(20'000, 500); ++i)
  {
    std::vector<OneContact> ones;
    FourContacts wide;
    for (std::size_t lane = 0; lane < 4; ++lane)
    {
      OneContact& one = ones.emplace_back(drawn_contact(draw));
      set_lane(wide, lane, one);
      compute_masses<float>(one.at, one.a, one.b);
      warm_start<float>(one.a, one.b, one.at);
      solve_contact<float>(one.a, one.b, one.at, spring, substep, 1.0f);
      solve_contact<float>(one.a, one.b, one.at, rigid<float>(), substep, 1.0f);
    }
    auto& [of, at] = wide;
    compute_masses<Four>(at, of.a, of.b);
    warm_start<Four>(of.a, of.b, at);
    solve_contact<Four>(of.a, of.b, at, wide_spring, substep, 1.0f);
    solve_contact<Four>(of.a, of.b, at, rigid<Four>(), substep, 1.0f);
    for (std::size_t lane = 0; lane < 4; ++lane)
    {
      CAPTURE(i, lane);
      const OneContact& one = ones[lane];
      REQUIRE(same(lane_of(of.a.motion.velocity, lane), one.a.motion.velocity));
      REQUIRE(same(lane_of(of.a.motion.angular_velocity, lane), one.a.motion.angular_velocity));
      REQUIRE(same(lane_of(of.b.motion.velocity, lane), one.b.motion.velocity));
      REQUIRE(same(lane_of(of.b.motion.angular_velocity, lane), one.b.motion.angular_velocity));
      REQUIRE(same(lane_of(at.friction, lane), one.at.friction));
      REQUIRE(at.impulse[lane] == one.at.impulse);
    }
  }
}
// [lanes]

// [turn_in_lanes]
TEST_CASE("bodies turn in lanes of every width as one alone does: uneven ones to rounding", "[R24]")
{
  BoxDraw draw(7);
  for (const InstructionSet set : instruction_sets())
  {
    const WidePasses passes = wide_passes(set);
    WideRotations turns(passes);
    for (int count = 0; count <= 17; ++count) // none, lanes left over, more than one pack
    {
      std::vector<RigidBody> bodies;
      std::vector<int> numbers;
      for (int i = 0; i < count; ++i)
      {
        SceneBody drawn = cube_body("box", {0, 0, 0});
        const double x = draw.between(0.2, 1), y = draw.between(0.2, 1);
        const double z = draw.between(0.2, 1);
        drawn.shape = i % 7 == 3 ? BoxShape{{x, x, x}} : BoxShape{{x, y, z}};
        const double fast = i % 5 == 0 ? 50 : 1; // some turn too far for lanes
        const double wx = draw.between(-1, 1), wy = draw.between(-1, 1);
        drawn.angular_velocity = fast * Vector3<double>(wx, wy, draw.between(-1, 1));
        bodies.push_back(rigid_body(drawn));
        numbers.push_back(i);
      }
      std::vector<RigidBody> alone = bodies;
      turns.rotate(bodies, numbers, 1.0 / 240);
      for (std::size_t i = 0; i < bodies.size(); ++i)
      {
        integrate_rotation(alone[i], 1.0 / 240);
        const double spin = alone[i].motion.angular_velocity.norm();
        CAPTURE(count, i);
        const double allowed =
            has_equal_moments(alone[i]) ? 1e-7 * spin / 240 : 1e-15; // see WideTurns
        CHECK((bodies[i].orientation.coeffs() - alone[i].orientation.coeffs()).norm() <= allowed);
        CHECK(
            (bodies[i].motion.angular_velocity - alone[i].motion.angular_velocity).norm() <=
            4e-15 * spin);
      }
    }
  }
}
// [turn_in_lanes]

// [instruction_sets]
TEST_CASE("whatever the width of the registers, a scene comes out to the bit", "[long]")
{
  REQUIRE(wide_passes(InstructionSet::portable).lanes == 4);
  for (const char* const name : {"tower_5", "pile_60", "wall_hit_5", "pit_60"})
  {
    std::vector<GameWorld> worlds;
    for (const InstructionSet set : instruction_sets())
    {
      worlds.push_back(wide_world(named_scene(name), wide_passes(set), {}));
    }
    for (int step = 0; step < 180; ++step)
    {
      for (GameWorld& world : worlds)
      {
        world.step();
        for (std::size_t i = 0; i < world.bodies().size(); ++i)
        {
          CAPTURE(name, step, i);
          const RigidBody& here = world.bodies()[i];
          const RigidBody& there = worlds[0].bodies()[i];
          REQUIRE(here.motion.center == there.motion.center);
          REQUIRE(here.axes == there.axes);
          REQUIRE(here.motion.velocity == there.motion.velocity);
          REQUIRE(here.motion.angular_velocity == there.motion.angular_velocity);
        }
      }
    }
  }
}
// [instruction_sets]

// [scenes_wide]
TEST_CASE("a cube on wide soft contacts sinks by g / ω², to float's digits", "[R14]")
{
  for (const int substeps : {2, 4, 8})
  {
    const double frequency = 2 * std::numbers::pi * 0.125 * 60.0 * substeps;
    const double sink = 9.81 / (frequency * frequency);
    CHECK(widely("tower_1", substeps, 3).overlap == Catch::Approx(sink).epsilon(1e-4));
  }
}

TEST_CASE("a tower of five carries what statics says, many contacts at a time", "[R9][long]")
{
  const std::vector<double> carries = warm_start_impulse(named_scene("tower_5"), "wide_steps", 600);
  for (std::size_t cube = 1; cube <= 5; ++cube)
  {
    CHECK(carries[cube] == Catch::Approx((6.0 - double(cube)) * 9.81 / 60).epsilon(1e-4));
  }
}

TEST_CASE(
    "one after the other and many at once: a cube to 10 µm, a slide of 8 m to .5 mm, stacks "
    "to 2 mm",
    "[long]")
{
  const std::vector<double> allowed{1e-5, 2e-3, 2e-3, 5e-4};
  for (std::size_t i = 0; i < allowed.size(); ++i)
  {
    const TwoRuns runs = two_runs(compared_scenes[i], 8, 5);
    const std::vector<double> separation = farthest_apart(runs);
    CAPTURE(compared_scenes[i]);
    CHECK(*std::max_element(separation.begin(), separation.end()) < allowed[i]);
    CHECK(runs.wide.sink == Catch::Approx(runs.one_by_one.sink).epsilon(0.25));
  }
}

/// Arms that turn: those that are kept are taken anew a step sooner or later, by a rounding.
/// Corners are sharp: at a worn one it matters which point presses.
constexpr SoftSettings turning_arms{.substeps = 8, .anchor_lag = 0, .torsional_radius = 0};

/// Soft steps in double that go through the contacts colour by colour.
void colored_soft_steps(IslandView world, const Island& island, double step)
{
  std::vector<std::pair<int, int>> pairs;
  for (const int number : island.contacts)
  {
    pairs.push_back(pair_of(world.contacts[index_of(number)]));
  }
  ContactGraph graph;
  graph.color(
      world.bodies.size(), pairs, [&](int i) { return !is_fixed(world.bodies[index_of(i)]); });
  std::vector<int> ordered;
  for (int color = 0; color < graph.colors(); ++color)
  {
    for (const int pair : graph[color])
    {
      ordered.push_back(island.contacts[index_of(pair)]);
    }
  }
  soft_steps(world, {island.bodies, ordered}, step, turning_arms);
}

TEST_CASE(
    "one after the other in the order of the colours gives stacks as many at once, to a micrometre",
    "[long]")
{
  for (const char* const name : {"pyramid", "tower_5"})
  {
    GameWorld one(named_scene(name), colored_soft_steps);
    GameWorld wide = wide_world(named_scene(name), widest_passes(), turning_arms);
    while (one.time() < 5)
    {
      one.step();
      wide.step();
    }
    for (std::size_t i = 0; i < one.bodies().size(); ++i)
    {
      CAPTURE(name, i);
      CHECK((one.bodies()[i].motion.center - wide.bodies()[i].motion.center).norm() < 1e-6);
    }
  }
}
// [scenes_wide]

// [free_step]
TEST_CASE("what no contact pushes flies on to the last bit as one by one")
{
  // All fall upwards; the ball passes over the cube so closely that they are in contact, and never
  // touch.
  Scene scene{.bodies = {ground(), cube_body("cube", {0, 0.5, 0})}};
  scene.gravity = {0, 9.81, 0};
  scene.bodies.push_back(ball_body("ball", 0.5, {-1, 1.502, 0.1}));
  scene.bodies[2].velocity = {1.1, 0, 0.3};
  scene.bodies[2].angular_velocity = {0.7, 0.1, 0.2};
  GameWorld one(scene, solver_named("soft_steps")), wide = wide_world(scene);
  int steps_in_contact = 0;
  for (int i = 0; i < 120; ++i)
  {
    one.step();
    wide.step();
    const auto passes = [](const WorldContact& contact)
    { return contact.a == 1 && contact.b == 2; };
    steps_in_contact += std::any_of(wide.contacts().begin(), wide.contacts().end(), passes) ? 1 : 0;
  }
  CHECK(steps_in_contact > 10);
  CHECK(wide.bodies()[2].motion.center == one.bodies()[2].motion.center);
  CHECK(wide.bodies()[2].motion.velocity == one.bodies()[2].motion.velocity);
  CHECK(wide.bodies()[2].motion.velocity.x() == 1.1);
}
// [free_step]

TEST_CASE(
    "a motion is taken back if any of its numbers has changed, and keeps its digits if none has")
{
  const Vector3<double> third = Vector3<double>::Constant(1.0 / 3);
  for (int changed = -1; changed < 3; ++changed)
  {
    RigidBody body = rigid_body(ball_body("ball", 0.5, {0, 0, 0}));
    body.motion.velocity = body.motion.angular_velocity = third;
    LaneBody lane;
    put_motion(body, lane);
    if (changed >= 0)
    {
      lane.velocity[changed] = 2;
    }
    take_motion(lane, body);
    CAPTURE(changed);
    CHECK((body.motion.velocity == third) == (changed < 0));
    CHECK((changed < 0 || body.motion.velocity[changed] == 2));
    CHECK(body.motion.angular_velocity == third);
  }
}

// [islands_together]
/// Bodies on the ground: bricks that turn slowly, one on the other; a brick that turns fast; a cube
/// that turns so fast in an overlap that it is not pushed out; and one too heavy for floats.
std::vector<SceneBody> four_kinds()
{
  std::vector<SceneBody> all;
  const auto add = [&](const Vector3<double>& half, double x, double y, double mass) -> SceneBody& {
    return all.emplace_back(box_body(numbered("box", int(all.size())), half, {x, y, 0}, mass));
  };
  const Vector3<double> brick(0.5, 0.25, 0.3), cube(0.5, 0.5, 0.5);
  for (const double y : {0.25, 0.75, 1.25})
  {
    add(brick, 0.1 * y, y, 1).angular_velocity = {0, 0.5, 0};
  }
  add(brick, 10, 0.25, 1).angular_velocity = {1, 20, 0};
  add(cube, 20, 0.4, 1).angular_velocity = {0, 90, 3};
  add(cube, 30, 0.5, 1e17);
  add(cube, 30, 1.5, 1);
  return all;
}

TEST_CASE("islands that are solved together do to the bit what each does alone")
{
  const std::vector<SceneBody> all = four_kinds();
  const std::size_t starts[] = {0, 3, 4, 5, all.size()};
  Scene scene{.bodies = {ground()}};
  scene.bodies.insert(scene.bodies.end(), all.begin(), all.end());
  GameWorld together = wide_world(scene);
  std::vector<GameWorld> alone;
  for (int group = 0; group < 4; ++group)
  {
    Scene update_separations{.bodies = {ground()}};
    update_separations.bodies.insert(
        update_separations.bodies.end(), &all[starts[group]], &all[starts[group + 1] - 1] + 1);
    alone.push_back(wide_world(update_separations));
  }
  for (int step = 0; step < 180; ++step)
  {
    together.step();
    for (std::size_t group = 0; group < 4; ++group)
    {
      alone[group].step();
      for (std::size_t i = starts[group]; i < starts[group + 1]; ++i)
      {
        const RigidBody& here = together.bodies()[i + 1];
        const RigidBody& there = alone[group].bodies()[i - starts[group] + 1];
        CAPTURE(step, group, i);
        REQUIRE(here.motion.center == there.motion.center);
        REQUIRE(here.axes == there.axes);
        REQUIRE(here.motion.velocity == there.motion.velocity);
        REQUIRE(here.motion.angular_velocity == there.motion.angular_velocity);
      }
    }
  }
}
// [islands_together]

// [without_colors]
TEST_CASE("two contacts with a ball in common, solved at once, lose a push")
{
  // Three balls of 1 kg in a row: contacts of the first with the second, and of the second with the
  // third, which is hit from both sides.
  std::vector<LaneBody> spheres(4);
  for (std::size_t i = 0; i < 3; ++i)
  {
    spheres[i].inverse_masses[0] = 1;
  }
  const int a[]{0, 1, 3, 3}, b[]{1, 2, 3, 3};
  const Four zero(0);
  const Vector3<Four> none(zero, zero, zero);
  Body<Four> bodies_a, bodies_b;
  ContactConstraint<Four> at{none,    {none, none}, {none, none}, zero, zero,
                             Four(1), zero,         {zero, zero}, zero, {}};
  for (const std::size_t lane : {0u, 1u})
  {
    at.normal.x().lanes[lane] = 1;
  }
  for (auto [numbers, body] : {std::pair(a, &bodies_a), std::pair(b, &bodies_b)})
  {
    gather_body(spheres.data(), numbers, *body);
  }
  warm_start<Four>(bodies_a, bodies_b, at);
  scatter_motion(bodies_a, spheres.data(), a);
  scatter_motion(bodies_b, spheres.data(), b);
  CHECK(spheres[0].velocity[0] == -1);
  CHECK(spheres[1].velocity[0] != 0); // one of its two pushes is gone
  CHECK(spheres[2].velocity[0] == 1);
}
// [without_colors]

TEST_CASE("a million metres from the origin a tower stands as at the origin, to 5 µm", "[long]")
{
  Scene at_origin = named_scene("tower_3"), distant = at_origin;
  const Vector3<double> away(1 << 20, 0, -(1 << 20));
  for (SceneBody& body : distant.bodies)
  {
    body.position += body.mass > 0 ? away : Vector3<double>(0, 0, 0);
  }
  GameWorld a = wide_world(at_origin), b = wide_world(distant);
  for (int i = 0; i < 300; ++i)
  {
    a.step();
    b.step();
  }
  for (std::size_t i = 1; i < a.bodies().size(); ++i)
  {
    CHECK((b.bodies()[i].motion.center - away - a.bodies()[i].motion.center).norm() < 5e-6);
  }
}

/// How far the top of a tower of four cubes of a size [m] has come down after 5 s, in sizes.
double sink_of_four(double size)
{
  Scene scene = named_scene("tower_4");
  for (SceneBody& body : scene.bodies)
  {
    body.position *= size;
    if (body.mass > 0)
    {
      body.shape = BoxShape{Vector3<double>::Constant(0.5 * size)};
      body.mass = size * size * size;
    }
  }
  scene.gravity *= size;
  GameWorld world = wide_world(scene, widest_passes(), {.substeps = 8, .correction_speed = size});
  while (world.time() < 5)
  {
    world.step();
  }
  return 3.5 - world.bodies()[4].motion.center.y() / size;
}

TEST_CASE(
    "towers of cubes a thousand times smaller and larger sink by as many thousandths of a cube",
    "[long]")
{
  const double sink = sink_of_four(1);
  CHECK((sink > 5e-4 && sink < 1.5e-3));
  CHECK(sink_of_four(1.0 / 1024) == Catch::Approx(sink).epsilon(1e-6));
  CHECK(sink_of_four(1024) == Catch::Approx(sink).epsilon(1e-6));
}

TEST_CASE(
    "a table top on a hundred legs is carried: contacts of one body come one by one", "[R9][long]")
{
  GameWorld world = wide_world(named_scene("table_on_100"), 8);
  while (world.time() < 5)
  {
    world.step();
  }
  double up = 0;
  for (const WorldContact& contact : world.contacts())
  {
    for (const WorldPoint& point : contact.points)
    {
      up += contact.b == 101 || contact.a == 101 ? point.impulse : 0;
    }
  }
  CHECK(up == Catch::Approx(10 * 9.81 / 60).epsilon(1e-3));
  CHECK(std::abs(world.bodies()[101].motion.velocity.norm()) < 1e-3);
}

TEST_CASE(
    "a lane with one point beside one with more: a ball on a tower is carried, and no more", "[R9]")
{
  // The ball's contact has the colour of the ground's with the lowest cube.
  Scene scene = named_scene("tower_2");
  scene.bodies.push_back(ball_body("ball", 0.5, {0, 2.5, 0}, 2));
  GameWorld world = wide_world(scene, 8);
  while (world.time() < 5)
  {
    world.step();
  }
  REQUIRE(world.contacts().size() == 3);
  for (const WorldContact& contact : world.contacts())
  {
    double carries = 0;
    for (const WorldPoint& point : contact.points)
    {
      carries += point.impulse;
    }
    CHECK((contact.points.size() == 1) == (contact.b == 3));
    CHECK(carries == Catch::Approx((5.0 - contact.b) * 9.81 / 60).epsilon(1e-4));
  }
}

TEST_CASE("masses and speeds beyond float's squares: to the bit as one by one, and never NaN")
{
  for (const double mass : {1e-38, 1e-30, 1e20, 1e46})
  {
    Scene scene = named_scene("tower_2");
    scene.bodies[2].mass = mass;
    scene.bodies[2].velocity = {1, 0, 0};
    GameWorld one(scene, solver_named("soft_steps")), wide = wide_world(scene);
    for (int i = 0; i < 60; ++i)
    {
      one.step();
      wide.step();
    }
    CAPTURE(mass);
    CHECK(wide.bodies()[2].motion.center == one.bodies()[2].motion.center);
  }
  Scene scene = named_scene("tower_3");
  scene.bodies[3].velocity = {0, -1e200, 0};
  GameWorld wide = wide_world(scene);
  for (int i = 0; i < 60; ++i)
  {
    wide.step();
  }
  CHECK(is_finite(wide.bodies()[1]));
  CHECK(wide.bodies()[0].motion.velocity == Vector3<double>(0, 0, 0));
}

TEST_CASE("a heap, dominoes and a wall that is hit never gain energy, nor break", "[R4][long]")
{
  for (const char* const name : {"pile_60", "domino", "wall_hit_5", "pit_60", "cubes_64"})
  {
    CAPTURE(name);
    const WorldRun run = run_world(named_scene(name), {.solver = "wide_steps", .duration = 6});
    CHECK(run.energy_most <= run.energy_start * (1 + 1e-6));
    CHECK(run.energy_end < run.energy_start);
  }
}

TEST_CASE("no push of a contact changes what two bodies have together, to float's digits", "[R3]")
{
  Scene scene{.bodies = {cube_body("a", {-0.6, 0, 0}), cube_body("b", {0.6, 0.3, 0.2}, 3)}};
  scene.gravity = {0, 0, 0};
  scene.bodies[0].velocity = {2, 0.5, 0};
  scene.bodies[1].angular_velocity = {1, 2, 3};
  GameWorld world = wide_world(scene);
  for (int i = 0; i < 120; ++i)
  {
    world.step();
  }
  Vector3<double> momentum = Vector3<double>::Zero();
  for (const RigidBody& body : world.bodies())
  {
    momentum += body.motion.velocity / body.inverse_mass;
  }
  CHECK(std::abs(world.bodies()[1].motion.velocity.x()) > 0.1); // they have met
  CHECK((momentum - Vector3<double>(2, 0.5, 0)).norm() < 1e-5);
}

TEST_CASE("a copy of a wide world goes on to the bit", "[long]")
{
  GameWorld world = wide_world(named_scene("pile_30"));
  for (int i = 0; i < 100; ++i)
  {
    world.step();
  }
  GameWorld copy = world;
  for (int i = 0; i < 60; ++i)
  {
    world.step();
    copy.step();
  }
  for (std::size_t i = 0; i < world.bodies().size(); ++i)
  {
    CHECK(world.bodies()[i].motion.center == copy.bodies()[i].motion.center);
    CHECK(world.bodies()[i].motion.angular_velocity == copy.bodies()[i].motion.angular_velocity);
  }
}
