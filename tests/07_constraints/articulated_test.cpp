/// \file
/// Trees of links: Lagrange's equation, spatial vectors, the articulated-body algorithm, and what
/// it answers to trees that are none.

#include "05_resolution/integrators/integrators.hpp"
#include "05_resolution/integrators/trial/pendulum.hpp"
#include "07_constraints/articulated/articulated.hpp"
#include "07_constraints/articulated/double_pendulum.hpp"
#include "07_constraints/articulated/hanging_chain.hpp"
#include "07_constraints/articulated/trial/articulated_scenes.hpp"
#include "07_constraints/articulated/trial/dense_tree.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace cookbook;

namespace
{

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// A chain of two boxes on hinges, and the same as a double pendulum.
struct TwoLinks
{
  std::vector<Link> links;
  DoublePendulum plain;
};

TwoLinks two_links(NumberDraw<double>& draw)
{
  HangingChain chain{.links = 2, .mass = draw.between(0.1, 5)};
  chain.half_extents = {draw.between(0.01, 0.3), draw.between(0.1, 1), 0.05};
  TwoLinks two{chain_links(chain), {}};
  two.links[1].solid = solid_box<double>(draw.between(0.1, 5), chain.half_extents);
  const double half = chain.half_extents.y();
  const auto swinging = [&](const Link& link) -> SwingingLink {
    return {link.solid.mass, link.solid.moments.z(), half, 2 * half};
  };
  two.plain = {swinging(two.links[0]), swinging(two.links[1])};
  return two;
}

/// What is wrong with links, by the message; empty if nothing is.
std::string refused(const std::vector<Link>& links)
{
  try
  {
    ArticulatedBody tree(links);
    return "";
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

/// The time [s] of a swing of a tree of one hinge, by 1,000 steps of RK4 a second.
double period_of_swing(ArticulatedBody& tree, double amplitude)
{
  TreeState state = zero_state(tree.links());
  state.positions[0] = amplitude;
  double first = 0, last = 0, time = 0;
  int crossings = 0;
  for (int i = 0; i < 5000; ++i)
  {
    const double before = state.positions[0];
    rk4_step(tree, state, 0.001);
    time += 0.001;
    if ((before > 0) != (state.positions[0] > 0))
    {
      last = time - 0.001 * state.positions[0] / (state.positions[0] - before);
      first = ++crossings == 1 ? last : first;
    }
  }
  return 2 * (last - first) / (crossings - 1);
}

} // namespace

// [R50]
TEST_CASE("two points on equal rods swing together at √(2 - √2) and apart at √(2 + √2)", "[R50]")
{
  const DoublePendulum pendulum{{1, 0, 1, 1}, {1, 0, 1, 1}, 1};
  for (const double sign : {-1.0, 1.0})
  {
    const Vector2<double> mode(1e-6, -sign * std::sqrt(2) * 1e-6), still(0, 0);
    const Vector2<double> right = -(2 + sign * std::sqrt(2)) * mode;
    CHECK((angular_accelerations(pendulum, mode, still) - right).norm() <= 1e-15);
  }
}

TEST_CASE("a double pendulum keeps its energy to 1e-6 for 60 s of RK4 at 1,000 Hz", "[R50]")
{
  const DoublePendulum pendulum{{1, 0.02, 0.25, 0.5}, {1, 0.02, 0.25, 0.5}};
  const auto accelerations = [&](const Vector2<double>& angles, const Vector2<double>& speeds)
  { return angular_accelerations(pendulum, angles, speeds); };
  PhasePoint<Vector2<double>> at{{2, 2}, {0, 0}};
  const double start = energy(pendulum, at.position, at.velocity);
  const double swings_with = start - energy(pendulum, {0, 0}, {0, 0});
  double off = 0;
  for (int i = 0; i < 60'000; ++i)
  {
    at = rk4(at, 0.001, accelerations);
    off = std::max(off, std::abs(energy(pendulum, at.position, at.velocity) - start));
  }
  CHECK(off <= 1e-6 * swings_with);
  CHECK(off > 0);
}
// [R50]

TEST_CASE(
    "a link on a pivot at its centre does not bend: the swing has the elliptic period", "[R50]")
{
  const DoublePendulum pendulum{{2, 0.1, 0.5, 1}, {3, 0.4, 0, 1}};
  const auto accelerations = [&](const Vector2<double>& angles, const Vector2<double>& speeds)
  { return angular_accelerations(pendulum, angles, speeds); };
  // Moment .1 + 2 · .5² + 3 · 1² = 3.6 kg m², and 2 · .5 + 3 · 1 = 4 kg m: 0.9 m of a point.
  const double period = pendulum_period<double>({9.81, 0.9}, 1.5);
  PhasePoint<Vector2<double>> at{{1.5, 0.3}, {0, 0}};
  for (int i = 0; i < 4000; ++i)
  {
    at = rk4(at, period / 4000, accelerations);
  }
  CHECK(std::abs(at.position.x() - 1.5) <= 1e-10);
  CHECK(at.position.y() == 0.3);
}

// [R51]
TEST_CASE("power and energy are the same at any point of a rigid body, to 1e-13", "[R51]")
{
  NumberDraw<double> draw(7);
  for (int i = 0; i < inputs(10'000, 500); ++i)
  {
    const auto drawn = [&]
    {
      const Vector3<double> turning = draw.in_cube(2);
      return spatial(turning, draw.in_cube(2));
    };
    const SpatialVector motion = drawn(), force = drawn();
    const Vector3<double> arm = draw.in_cube(2), moments = draw.in_box(0.1, 2);
    const SpatialMatrix inertia =
        rigid_inertia(draw.between(0.1, 5), moments, drawn_turn(draw).toRotationMatrix());
    const SpatialVector there = shifted_motion(motion, arm);
    const double power = force.dot(there), here = shifted_force(force, arm).dot(motion);
    CHECK(std::abs(power - here) <= 1e-13 * (1 + std::abs(power)));
    const double twice_energy = there.dot(inertia * there);
    const double felt_here = motion.dot(shifted_inertia(inertia, arm) * motion);
    CHECK(std::abs(twice_energy - felt_here) <= 1e-13 * twice_energy);
  }
}
// [R51]

TEST_CASE("3 kg at an arm of (0, 2, 0) add 12 kg m² about x and z, and 6 kg m of coupling", "[R51]")
{
  const SpatialMatrix felt =
      shifted_inertia(rigid_inertia(3, {1, 1, 1}, Matrix3<double>::Identity()), {0, 2, 0});
  SpatialMatrix right = SpatialMatrix::Zero();
  right.diagonal() << 13, 1, 13, 3, 3, 3;
  right(0, 5) = right(5, 0) = 6; // a push along z turns it about x
  right(2, 3) = right(3, 2) = -6;
  CHECK(felt == right);
}

// [R52]
TEST_CASE("two links on hinges accelerate as Lagrange's equation says, to 1e-12", "[R52][R50]")
{
  NumberDraw<double> draw(1);
  for (int i = 0; i < inputs(10'000, 500); ++i)
  {
    const TwoLinks two = two_links(draw);
    ArticulatedBody tree(two.links);
    const double a = draw.between(-3, 3), b = draw.between(-3, 3);
    const double v = draw.between(-5, 5), w = draw.between(-5, 5);
    const Eigen::VectorXd faster =
        tree.accelerations({Vector2<double>(a, b - a), Vector2<double>(v, w - v)});
    const Vector2<double> right = angular_accelerations(two.plain, {a, b}, {v, w});
    CHECK(std::abs(faster[0] - right.x()) <= 1e-12 * right.norm());
    CHECK(std::abs(faster[0] + faster[1] - right.y()) <= 1e-12 * right.norm());
  }
}

TEST_CASE("trees with joints of all types accelerate as the dense mass matrix says: 1e-11", "[R52]")
{
  NumberDraw<double> draw(2);
  int most = 0;
  for (int i = 0; i < inputs(300, 30); ++i)
  {
    const std::vector<Link> links = drawn_links(draw, 1 + i % 12);
    ArticulatedBody tree(links);
    const TreeState state = drawn_state(draw, links);
    tree.drive = 5 * drawn_state(draw, links).velocities;
    for (SpatialVector& load : tree.loads)
    {
      const Vector3<double> moment = draw.in_cube(5);
      load = spatial(moment, draw.in_cube(5));
    }
    const Eigen::VectorXd faster = tree.accelerations(state);
    if (faster.size() > 0)
    {
      const Eigen::VectorXd right = dense_accelerations(tree, state);
      CHECK((faster - right).norm() <= 1e-11 * right.norm());
    }
    const std::vector<DenseLink> moving = dense_motion(links, state, faster);
    for (std::size_t k = 0; k < links.size(); ++k)
    {
      const MovingLink& link = tree.moving(static_cast<int>(k));
      const double tolerance = 1e-11 * (1 + moving[k].acceleration.norm());
      CHECK((link.velocity - moving[k].velocity).norm() <= tolerance);
      CHECK((link.acceleration - moving[k].acceleration).norm() <= tolerance);
    }
    most = std::max(most, static_cast<int>(faster.size()));
  }
  CHECK(most >= 20);
}
// [R52]

// [out_of_the_plane]
TEST_CASE(
    "a second hinge turned by 90°: the plain double pendulum is off by half, the tree by 1e-12")
{
  NumberDraw<double> draw(3);
  TwoLinks two = two_links(draw);
  two.links[1].axis = {1, 0, 0};
  ArticulatedBody tree(two.links);
  const TreeState state{Vector2<double>(0.5, 0.7), Vector2<double>(1, 2)};
  const Eigen::VectorXd faster = tree.accelerations(state);
  const Eigen::VectorXd right = dense_accelerations(tree, state);
  CHECK((faster - right).norm() <= 1e-12 * right.norm());
  const Vector2<double> plain = angular_accelerations(two.plain, {0.5, 1.2}, {1, 3});
  CHECK((Vector2<double>(plain.x(), plain.y() - plain.x()) - right).norm() > 0.5 * right.norm());
}
// [out_of_the_plane]

// [period]
TEST_CASE("a box on a hinge swings by 28°, 86° and 143° in the elliptic integral's time, to 1e-7")
{
  const HangingChain rod{.links = 1, .mass = 3, .half_extents = {0.05, 0.5, 0.02}};
  ArticulatedBody tree(chain_links(rod));
  const double moment = tree.links()[0].solid.moments.z() + 3 * 0.5 * 0.5;
  for (const double amplitude : {0.5, 1.5, 2.5})
  {
    const double right = pendulum_period<double>({9.81, moment / (3 * 0.5)}, amplitude);
    CHECK(period_of_swing(tree, amplitude) == Catch::Approx(right).epsilon(1e-7));
  }
}
// [period]

TEST_CASE("1 kg on a slider with a spring of 40 N/m and a damper of 4 N s/m: the closed form")
{
  Link link{.joint = JointType::slider, .solid = solid_box<double>(1, {1, 1, 1})};
  link.axis = {1, 0, 0};
  link.stiffness = 40;
  link.damping = 4;
  link.rest = 0.5;
  ArticulatedBody tree({link});
  TreeState state = zero_state(tree.links());
  for (int i = 0; i < 1000; ++i)
  {
    rk4_step(tree, state, 0.001);
  }
  // x = rest (1 - e^(-2t) (cos 6t + sin 6t / 3)), for 40 - 2² = 6².
  const double right = 0.5 * (1 - std::exp(-2) * (std::cos(6) + std::sin(6) / 3));
  CHECK(std::abs(state.positions[0] - right) <= 1e-11);
}

TEST_CASE("a motor of 3 N m on a wheel of 2 kg m² about its centre turns it at 1.5 rad/s²")
{
  Link wheel;
  wheel.solid = {1, {1, 1, 2}};
  ArticulatedBody tree({wheel});
  tree.drive[0] = 3;
  CHECK(tree.accelerations(zero_state(tree.links()))[0] == 1.5);
}

// [hanging_rest]
TEST_CASE("chains of 1 to 50 links with 1,000 kg at the end hang at rest to 1e-9 rad/s²")
{
  for (const int count : {1, 2, 20, 50})
  {
    for (const JointType joint : {JointType::hinge, JointType::ball})
    {
      const HangingChain chain{.links = count, .load = 1000, .joint = joint};
      ArticulatedBody tree(chain_links(chain));
      CHECK(tree.accelerations(zero_state(tree.links())).cwiseAbs().maxCoeff() <= 1e-9);
    }
  }
}
// [hanging_rest]

TEST_CASE("on ball joints a chain moves in its plane as on hinges, to 1e-9 after 1 s")
{
  const HangingChain hinged{.links = 5};
  HangingChain balls = hinged;
  balls.joint = JointType::ball;
  ArticulatedBody on_hinges(chain_links(hinged)), on_balls(chain_links(balls));
  TreeState flat = zero_state(on_hinges.links()), round = zero_state(on_balls.links());
  for (int i = 0; i < 5; ++i)
  {
    flat.velocities[i] = round.velocities[3 * i + 2] = 1 - 0.4 * i;
  }
  for (int i = 0; i < 1000; ++i)
  {
    rk4_step(on_hinges, flat, 0.001);
    rk4_step(on_balls, round, 0.001);
  }
  const LinkBody one = link_bodies(on_hinges, flat)[4], other = link_bodies(on_balls, round)[4];
  CHECK((one.motion.center - other.motion.center).norm() <= 1e-9);
  CHECK((one.motion.velocity - other.motion.velocity).norm() <= 1e-9);
}

// [link_bodies_test]
TEST_CASE("two links of 2 m, the first to the right, the second down: centres, spin, velocities")
{
  const HangingChain chain{.links = 2, .half_extents = {0.1, 1, 0.1}, .hook = {5, 7, 0}};
  ArticulatedBody tree(chain_links(chain));
  const double quarter = std::acos(0.0);
  const std::vector<LinkBody> bodies =
      link_bodies(tree, {Vector2<double>(quarter, -quarter), Vector2<double>(3, -1)});
  CHECK((bodies[0].motion.center - Vector3<double>(6, 7, 0)).norm() <= 1e-15);
  CHECK((bodies[1].motion.center - Vector3<double>(7, 6, 0)).norm() <= 1e-15);
  CHECK((bodies[0].motion.velocity - Vector3<double>(0, 3, 0)).norm() <= 1e-14);
  // The joint at (7, 7) rises at 6 m/s; 2 rad/s carry what is 1 m below it to the right.
  CHECK((bodies[1].motion.velocity - Vector3<double>(2, 6, 0)).norm() <= 1e-14);
  CHECK(bodies[1].motion.angular_velocity == Vector3<double>(0, 0, 2));
  CHECK(bodies[1].orientation.angularDistance(Quaternion<double>::Identity()) <= 1e-15);
}
// [link_bodies_test]

// [no_resistance]
TEST_CASE("a point on a ball joint circles as a conical pendulum; about its rod nothing turns it")
{
  Link point{.joint = JointType::ball, .solid = {2, {0, 0, 0}}};
  const double angle = 0.6, cosine = std::cos(angle), sine = std::sin(angle);
  point.anchor_child = {-sine, cosine, 0}; // on a rod of 1 m, at an angle from straight down
  ArticulatedBody tree({point});
  TreeState state = zero_state(tree.links());
  state.velocities[1] = std::sqrt(9.81 / cosine);
  tree.accelerations(state);
  const Vector3<double> inwards = tree.moving(0).acceleration.tail<3>();
  CHECK((inwards - Vector3<double>(-9.81 * sine / cosine, 0, 0)).norm() <= 1e-13);
}

TEST_CASE("links without mass: two hinges of a universal joint, and a tree of nothing else")
{
  Link cross{.joint = JointType::hinge, .axis = {1, 0, 0}};
  Link rod{.parent = 0, .joint = JointType::hinge, .solid = solid_box<double>(2, {0.1, 1, 0.1})};
  rod.anchor_child = {0, 1, 0};
  ArticulatedBody universal({cross, rod});
  const TreeState state{Vector2<double>(0.3, 0.5), Vector2<double>(1, 2)};
  const Eigen::VectorXd right = dense_accelerations(universal, state);
  CHECK((universal.accelerations(state) - right).norm() <= 1e-12 * right.norm());

  Link nothing = rod;
  nothing.solid = {0, {0, 0, 0}};
  ArticulatedBody light({cross, nothing});
  light.drive.setOnes();
  CHECK(light.accelerations(state) == Eigen::VectorXd(Vector2<double>(0, 0)));
}

TEST_CASE("of two hinges on one axis without mass between them the outer one accelerates alone")
{
  NumberDraw<double> draw(6);
  for (int i = 0; i < 1000; ++i)
  {
    Link ring, disc{.parent = 0, .solid = {3, draw.in_box(1, 1.9)}};
    ring.axis = disc.axis = (draw.in_cube(1) + Vector3<double>(0, 0, 1.5)).normalized();
    ArticulatedBody tree({ring, disc});
    tree.drive[1] = 4;
    const double turned = draw.between(-3, 3);
    const Eigen::VectorXd faster =
        tree.accelerations({Vector2<double>(turned, 0), Vector2<double>(0, 0)});
    const double moment = disc.axis.dot(disc.solid.moments.cwiseProduct(disc.axis));
    REQUIRE(faster[0] == 0); // its resistance is what rounding left
    REQUIRE(faster[1] == Catch::Approx(4 / moment).epsilon(1e-13));
  }
}

TEST_CASE("a free point without moments falls at 9.81 m/s², wherever it is held, and spins by none")
{
  NumberDraw<double> draw(8);
  for (int i = 0; i < 1000; ++i)
  {
    Link point{.joint = JointType::free, .solid = {2, {0, 0, 0}}};
    point.anchor_child = i == 0 ? Vector3<double>(0, 0, 0) : draw.in_cube(1);
    ArticulatedBody tree({point});
    REQUIRE(tree.accelerations(zero_state(tree.links())).cwiseAbs().maxCoeff() <= 1000);
    const Vector3<double> falls = tree.moving(0).acceleration.tail<3>();
    REQUIRE((falls - Vector3<double>(0, -9.81, 0)).norm() <= 1e-12);
  }
}
// [no_resistance]

// [refused]
TEST_CASE("no trees: a cycle, a parent behind its link, numbers that are none; each named")
{
  const Link whole{.solid = solid_box<double>(1, {1, 1, 1})};
  const auto with = [&](auto change)
  {
    std::vector<Link> links{whole, whole};
    links[1].parent = 0;
    change(links[1]);
    return refused(links);
  };
  CHECK(with([](Link&) {}) == "");
  CHECK(
      with([](Link& link) { link.parent = 1; }) ==
      "links[1].parent must be -1 or the place of a link before it, got 1");
  CHECK(with([](Link& link) { link.parent = -2; }).find("links[1].parent") == 0);
  Link first = whole, second = whole;
  first.parent = 1; // and the second the first's: a cycle
  second.parent = 0;
  CHECK(refused({first, second}).find("links[0].parent") == 0);
  CHECK(
      with([](Link& link) { link.solid.mass = -1; }) ==
      "links[1].solid.mass must be finite and not negative, got -1");
  CHECK(
      with([](Link& link) { link.solid.moments.y() = not_a_number; })
          .find("links[1].solid.moments.y") == 0);
  CHECK(with([](Link& link) { link.axis = {0, 0, 0}; }).find("links[1].axis") == 0);
  CHECK(with([](Link& link) { link.frame.w() = not_a_number; }).find("links[1].frame") == 0);
  CHECK(
      with([](Link& link) { link.anchor_child.x() = HUGE_VAL; }).find("links[1].anchor_child") ==
      0);
  const auto sprung_ball = [](Link& link)
  {
    link.joint = JointType::ball;
    link.stiffness = 1;
  };
  CHECK(with(sprung_ball).find("links[1].stiffness") == 0);
  CHECK_THROWS_AS(chain_links({.links = -1}), std::invalid_argument);
}

TEST_CASE("steps refuse what is not finite, or overflows, and leave the state as it was")
{
  ArticulatedBody tree(chain_links({.links = 2}));
  for (const TreeStep step : {semi_implicit_step, rk4_step})
  {
    TreeState state = zero_state(tree.links());
    state.velocities[1] = not_a_number;
    CHECK_THROWS_WITH(step(tree, state, 0.01), "velocities[1] must be finite, got nan");
    state.velocities[1] = 1e200;
    CHECK_THROWS_AS(step(tree, state, 0.01), std::overflow_error);
    CHECK(state.velocities[1] == 1e200);
    CHECK(state.positions[1] == 0);
    state.velocities[1] = 0;
    CHECK_THROWS_AS(step(tree, state, not_a_number), std::invalid_argument);
    tree.drive[0] = not_a_number;
    CHECK_THROWS_WITH(step(tree, state, 0.01), "drive[0] must be finite, got nan");
    tree.drive[0] = 0;
    state.positions.resize(3);
    CHECK_THROWS_WITH(step(tree, state, 0.01), "positions.size() must be 2, got 3");
  }
}
// [refused]

// [random_frames]
TEST_CASE("10,000 frames of random trees, some without mass: all numbers are finite")
{
  NumberDraw<double> draw(4);
  int frames = 0, overflows = 0;
  while (frames < inputs(10'000, 500))
  {
    std::vector<Link> links = drawn_links(draw, static_cast<int>(draw.between(1, 10)));
    for (Link& link : links)
    {
      const double mass = draw.between(0, 4) < 1 ? 0 : std::exp(draw.between(-15, 10));
      link.solid = solid_box<double>(mass, draw.in_box(0, 1));
      link.solid.moments *= draw.between(0, 4) < 1 ? 0 : 1;
    }
    ArticulatedBody tree(links);
    TreeState state = drawn_state(draw, links);
    for (int i = 0; i < 50; ++i, ++frames)
    {
      tree.drive = drawn_state(draw, links).velocities;
      const TreeState before = state;
      try
      {
        semi_implicit_step(tree, state, 1 / 60.0);
      }
      catch (const std::overflow_error&) // a link of 1e-7 kg is whirled by one of 1e4
      {
        ++overflows;
        CHECK(state.velocities == before.velocities);
        break;
      }
      REQUIRE(state.positions.allFinite());
      REQUIRE(state.velocities.allFinite());
    }
  }
  CHECK(overflows < frames / 20);
}
// [random_frames]
