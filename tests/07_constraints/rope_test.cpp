/// \file
/// Ropes: where springs explode, what each method makes of a cable, a swing and a load, and odd
/// input.

#include "07_constraints/rope/rope.hpp"
#include "07_constraints/rope/trial/rope_scenes.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

using namespace cookbook;

namespace
{

const double right_angle = std::numbers::pi / 2;

/// What is left of the energy of a swing after a number of frames.
double energy_left(const RopeMethod& method, double angle, int frames)
{
  return swing_energies(method, angle, frames).back();
}

/// The most energy that a swing has had.
double most_energy(const RopeMethod& method, double angle, int frames)
{
  const std::vector<double> energies = swing_energies(method, angle, frames);
  return *std::max_element(energies.begin(), energies.end());
}

/// All methods with what they hold well with, and springs of 10,000 N/m.
const std::vector<RopeMethod> all_methods{
    mass_spring(1e4, 20), implicit_euler_of(1e4, 2), xpbd(20, 1), direct_current(10, 2),
    direct_previous(10, 2)};

/// A rope after some frames.
Rope after_frames(Rope rope, const RopeMethod& method, int frames, StepSettings settings = {})
{
  for (DistanceConstraint& link : rope.links)
  {
    link.compliance = method.compliance;
  }
  settings.substeps = method.substeps;
  settings.iterations = method.iterations;
  for (int frame = 0; frame < frames; ++frame)
  {
    method.step(rope, settings);
  }
  return rope;
}

bool is_finite(const Rope& rope)
{
  bool finite = true;
  for (std::size_t i = 0; i < rope.particles.positions.size(); ++i)
  {
    finite = finite && rope.particles.positions[i].allFinite();
    finite = finite && rope.particles.velocities[i].allFinite();
  }
  return finite;
}

} // namespace

// [R44]
TEST_CASE("a rope of springs explodes above h √(k/m) = 1, and not below", "[R44]")
{
  // 1/60 s, particles of .25 kg: 1e4 N/m needs 3.33 substeps, 1e6 N/m 33.3.
  CHECK(std::isinf(most_energy(mass_spring(1e4, 3), right_angle / 2, 120)));
  CHECK(most_energy(mass_spring(1e4, 4), right_angle / 2, 120) <= 1.01);
  CHECK(std::isinf(most_energy(mass_spring(1e6, 33), right_angle / 2, 120)));
  CHECK(most_energy(mass_spring(1e6, 34), right_angle / 2, 120) <= 1.01);
}
// [R44]

// [R45]
TEST_CASE("implicit springs of 1e3 to 1e6 N/m hold at one substep, and lose what swings", "[R45]")
{
  for (const double stiffness : {1e3, 1e4, 1e5, 1e6})
  {
    CAPTURE(stiffness);
    CHECK(most_energy(implicit_euler_of(stiffness), right_angle / 2, 300) <= 1);
  }
  CHECK(energy_left(implicit_euler_of(1e4), right_angle / 2, 600) < 0.55);
  CHECK(energy_left(implicit_euler_of(1e6), right_angle / 2, 600) < 0.3);
}

TEST_CASE("a load of 1 t on implicit springs stretches each by T/k, to 1e-6 of that", "[R45]")
{
  // 20 links of 1e6 N/m; link i carries the load and 20 - i particles of 50 g.
  double right = 0;
  for (int i = 1; i <= 20; ++i)
  {
    right += (1000 + 0.05 * (20 - i)) * 9.81 / 1e6;
  }
  CHECK(stretch_under(implicit_euler_of(1e6), 1000) == Catch::Approx(right).epsilon(1e-6));
}

TEST_CASE("the Jacobian of a spring is how its force changes, to seven digits", "[R45]")
{
  Rope rope = make_rope({1, 2, 3}, {1.3, 2.5, 3.1}, 1, 1, 1e-3);
  rope.links[0].length = 0.4; // it is pulled
  const Matrix3<double> jacobian = spring_jacobian(rope.particles, rope.links[0]);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double step = 1e-5;
    Particles up = rope.particles, down = rope.particles;
    up.positions[1][axis] += step;
    down.positions[1][axis] -= step;
    const Vector3<double> change =
        (spring_force(up, rope.links[0]) - spring_force(down, rope.links[0])) / (2 * step);
    CHECK((change - jacobian.col(axis)).norm() <= 1e-7 * jacobian.norm());
  }
}

TEST_CASE("one linear solve is not enough for springs of 1e8 N/m: a swing gains energy", "[R45]")
{
  CHECK(most_energy(implicit_euler_of(1e8), right_angle / 2, 300) > 1.3);
}
// [R45]

// [R46]
TEST_CASE("a hanging rope is too long by h² Σ T/m by XPBD, over substeps squared", "[R46][long]")
{
  // 20 links of 50 g, 1 kg below: all links but the last are torn open by the next one's pull.
  double sum = 0;
  for (int i = 2; i <= 20; ++i)
  {
    sum += (1 + 0.05 * (20 - i)) * 9.81 / 0.05;
  }
  for (const int substeps : {10, 20, 40})
  {
    CAPTURE(substeps);
    const double h = 1.0 / 60 / substeps;
    CHECK(stretch_under(xpbd(substeps, 1), 1) == Catch::Approx(h * h * sum).epsilon(0.02));
  }
}

TEST_CASE(
    "over iterations the error falls once, over substeps twice as fast in digits", "[R46][long]")
{
  CHECK(sag_error(xpbd(1, 100)) == Catch::Approx(sag_error(xpbd(1, 10)) / 10).epsilon(0.1));
  CHECK(sag_error(xpbd(30, 1)) == Catch::Approx(sag_error(xpbd(10, 1)) / 9).epsilon(0.02));
}

TEST_CASE("a link of 1 mm/N that holds 1 kg is 9.81 mm longer, whatever the iterations", "[R46]")
{
  for (const int iterations : {1, 2, 50})
  {
    Rope rope = make_rope({0, 0, 0}, {0, -1, 0}, 1, 1, 1e-3);
    rope.particles.inverse_masses[0] = 0;
    StepSettings settings;
    settings.damping = 20;
    settings.iterations = iterations;
    for (int frame = 0; frame < 600; ++frame)
    {
      step_xpbd(rope.particles, rope.links, settings);
    }
    CHECK(-1 - rope.particles.positions[1].y() == Catch::Approx(9.81e-3).epsilon(1e-6));
  }
}
// [R46]

// [R47]
TEST_CASE("a cable of 40 links, solved directly, sags by 2.65526 m, to .1 µm", "[R47]")
{
  CHECK(sag_of_catenary(10, 8) == Catch::Approx(2.65438).epsilon(2e-6));
  CHECK(sag_of_chain(40, 10, 8) == Catch::Approx(2.65526).epsilon(2e-6));
  CHECK(sag_of_chain(4000, 10, 8) == Catch::Approx(sag_of_catenary(10, 8)).epsilon(1e-7));
  CHECK(std::abs(sag_error(direct_previous(1, 2))) <= 1e-7);
}

TEST_CASE("impulses along the links as they are now leave an error of h²", "[R47]")
{
  const double one = sag_error(direct_current(1, 2)), four = sag_error(direct_current(4, 2));
  CHECK(one == Catch::Approx(0.69e-3).epsilon(0.02));
  CHECK(four == Catch::Approx(one / 16).epsilon(0.05));
}

TEST_CASE("two solves keep the links of a swing of 45° to 1e-6 m", "[R47]")
{
  Rope rope = swing(right_angle / 2);
  double worst = 0;
  run_rope(
      rope, direct_previous(1, 2), 300, 0,
      [&](const Rope& now) { worst = std::max(worst, worst_stretch(now)); });
  CHECK(worst <= 1e-6);
}

TEST_CASE("solved directly, too, a link of 1 mm/N that holds 1 kg is 9.81 mm longer", "[R47]")
{
  Rope rope = make_rope({0, 0, 0}, {0, -1, 0}, 1, 1, 1e-3);
  rope.particles.inverse_masses[0] = 0;
  for (int frame = 0; frame < 600; ++frame)
  {
    step_direct(rope.particles, rope.links, {.damping = 20, .iterations = 2});
  }
  CHECK(-1 - rope.particles.positions[1].y() == Catch::Approx(9.81e-3).epsilon(1e-6));
}
// [R47]

// [rope_energy]
TEST_CASE(
    "previous directions keep .99 of a swing's energy, current ones and XPBD about half", "[long]")
{
  CHECK(energy_left(direct_previous(1, 2), right_angle / 2, 600) > 0.99);
  CHECK(energy_left(direct_current(1, 2), right_angle / 2, 600) < 0.55);
  CHECK(energy_left(xpbd(1, 100), right_angle / 2, 600) < 0.55);
  CHECK(energy_left(xpbd(100, 1), right_angle / 2, 600) > 0.99);
}

TEST_CASE("from 90° previous directions explode at one substep and keep .999 at ten")
{
  CHECK(most_energy(direct_previous(1, 2), right_angle, 600) > 100);
  CHECK(energy_left(direct_previous(10, 2), right_angle, 600) == Catch::Approx(1).epsilon(1e-3));
  CHECK(most_energy(direct_current(1, 2), right_angle, 600) <= 1);
}
// [rope_energy]

// [tension_limit]
TEST_CASE(
    "under 1 t h has to be below √(m L / T): 13 substeps fail, 24 hold, if it is nudged", "[long]")
{
  // √(.05 kg × .25 m / 9,810 N) = 1.13 ms, 14.8 substeps of a frame.
  CHECK(std::abs(stretch_under(direct_previous(13, 2), 1000, 0.5)) > 1);
  CHECK(stretch_under(direct_current(12, 2), 1000, 0.5) > 0.01);
  CHECK(std::abs(stretch_under(direct_current(16, 2), 1000, 0.5)) < 1e-4);
  CHECK(std::abs(stretch_under(direct_previous(24, 2), 1000, 0.5)) < 1e-4);
  CHECK(std::abs(stretch_under(direct_previous(1, 2), 1000)) < 1e-4); // straight, nothing is seen
}
// [tension_limit]

// [rope_inputs]
TEST_CASE("ropes of any size: a millimetre falls as a kilometre does, in its own time")
{
  for (const RopeMethod& method : {xpbd(20, 1), direct_previous(10, 2)})
  {
    CAPTURE(method.name);
    std::vector<double> ends;
    for (const double size : {1e-3, 1.0, 1e3})
    {
      Rope rope = make_rope({0, 0, 0}, {size, 0, 0}, 10, 1);
      rope.particles.inverse_masses[0] = 0;
      StepSettings settings;
      settings.gravity = {0, -size, 0};
      ends.push_back(after_frames(rope, method, 60, settings).particles.positions[10].y() / size);
    }
    CHECK(ends[0] == Catch::Approx(ends[1]).epsilon(1e-6));
    CHECK(ends[2] == Catch::Approx(ends[1]).epsilon(1e-6));
  }
}

TEST_CASE("odd ropes stay finite: slack, taut, folded, in one place, all pinned, without weight")
{
  Rope taut = make_rope({0, 0, 0}, {5, 0, 0}, 20, 5);
  taut.particles.inverse_masses.front() = taut.particles.inverse_masses.back() = 0;
  Rope folded = taut, too_short = taut, closer = taut, pinned = taut, heap = taut, heavy = taut;
  folded.particles.positions.back().x() = 0;
  closer.particles.positions.back().x() = 2;
  too_short.particles.positions.back().x() = 5.5;
  pinned.particles.inverse_masses.assign(21, 0.0);
  heap.particles.positions.assign(21, Vector3<double>(1, 1, 1));
  heavy.particles.inverse_masses[10] = 4e-6;
  for (const RopeMethod& method : {implicit_euler_of(1e4, 2), xpbd(20, 1)})
  {
    CAPTURE(method.name);
    for (const Rope& rope : {taut, folded, too_short, closer, pinned, heap, heavy})
    {
      CHECK(is_finite(after_frames(rope, method, 60)));
    }
  }
  for (const RopeMethod& method : {direct_current(10, 2), direct_previous(10, 2)})
  {
    CAPTURE(method.name);
    CHECK(after_frames(pinned, method, 60).particles.positions == pinned.particles.positions);
  }
}

TEST_CASE("taut at exactly its length and weightless, a rope keeps its place to the bit")
{
  Rope taut = make_rope({0, 0, 0}, {5, 0, 0}, 20, 5);
  taut.particles.inverse_masses.front() = taut.particles.inverse_masses.back() = 0;
  StepSettings settings;
  settings.gravity = {0, 0, 0};
  for (const RopeMethod& method : all_methods)
  {
    const Rope rope = after_frames(taut, method, 60, settings);
    for (std::size_t i = 0; i <= 20; ++i)
    {
      CHECK((rope.particles.positions[i] - taut.particles.positions[i]).norm() <= 1e-12);
    }
  }
}

TEST_CASE("one link in free fall falls as a stone does; a pinned one stays, and one of two turns")
{
  const Rope link = make_rope({0, 0, 0}, {1, 0, 0}, 1, 1);
  for (const RopeMethod& method : all_methods)
  {
    CAPTURE(method.name);
    const double h = 1.0 / 60 / method.substeps, stone = -9.81 * 1 * (1 + h) / 2;
    CHECK(after_frames(link, method, 60).particles.positions[0].y() == Catch::Approx(stone));
    CHECK(after_frames(link, method, 60).particles.positions[1].y() == Catch::Approx(stone));
    Rope pinned = link;
    pinned.particles.inverse_masses = {0, 0};
    CHECK(after_frames(pinned, method, 60).particles.positions[1] == Vector3<double>(1, 0, 0));
  }
}

TEST_CASE("two particles in one place separate along +y, B on top")
{
  Rope rope = make_rope({0, 0, 0}, {1, 0, 0}, 1, 1);
  rope.particles.positions[1] = {0, 0, 0};
  StepSettings weightless;
  weightless.gravity = {0, 0, 0};
  step_xpbd(rope.particles, rope.links, weightless);
  CHECK(rope.particles.positions[0] == Vector3<double>(0, -0.5, 0));
  CHECK(rope.particles.positions[1] == Vector3<double>(0, 0.5, 0));
}

TEST_CASE("a link that turns by a right angle within a step keeps its length")
{
  Rope rope = make_rope({0, 0, 0}, {1, 0, 0}, 1, 1);
  rope.particles.inverse_masses[0] = 0;
  rope.particles.velocities[1] = {-60, 60, 0}; // from (1, 0) to (0, 1)
  StepSettings weightless;
  weightless.gravity = {0, 0, 0};
  step_direct(rope.particles, rope.links, weightless);
  CHECK((rope.particles.positions[1] - Vector3<double>(0, 1, 0)).norm() <= 1e-12);
}

TEST_CASE("a pinned particle with a velocity carries its rope along")
{
  for (const RopeMethod& method : all_methods)
  {
    CAPTURE(method.name);
    Rope rope = make_rope({0, 0, 0}, {0, -1, 0}, 5, 1);
    rope.particles.inverse_masses[0] = 0;
    rope.particles.velocities[0] = {1, 0, 0};
    rope = after_frames(rope, method, 120);
    CHECK(rope.particles.positions[0].x() == Catch::Approx(2));
    CHECK(std::abs(rope.particles.positions[5].x() - 2) < 0.6);
  }
}
// [rope_inputs]

// [rope_refusals]
TEST_CASE("bad numbers are refused with member and value, and nothing moves")
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  Rope good = make_rope({0, 0, 0}, {1, 0, 0}, 3, 1, 1e-4);
  const auto refuses = [&](const Rope& rope, const StepSettings& settings, const std::string& words)
  {
    Rope copy = rope;
    CHECK_THROWS_WITH(
        step_xpbd(copy.particles, copy.links, settings), Catch::Matchers::ContainsSubstring(words));
    CHECK(copy.particles.positions.front() == good.particles.positions.front());
  };
  Rope bad = good;
  bad.particles.positions[2].y() = none;
  refuses(bad, {}, "positions[2].y must be between -1e+09 and 1e+09, got nan");
  bad = good;
  bad.particles.velocities[1].z() = 1e10;
  refuses(bad, {}, "velocities[1].z must be between -1e+09 and 1e+09, got 1e+10");
  bad = good;
  bad.particles.inverse_masses[1] = -1;
  refuses(bad, {}, "inverse_masses[1] must be between 1e-09 and 1e+09, got -1");
  bad = good;
  bad.particles.velocities.pop_back();
  refuses(bad, {}, "velocities and inverse_masses must be as many as positions, 4, got 3 and 4");
  bad = good;
  bad.links[2].b = 4;
  refuses(bad, {}, "constraints[2] must join two of 4 particles, got 2 and 4");
  bad = good;
  bad.links[1].length = -0.5;
  refuses(bad, {}, "constraints[1].length must be between 0 and 1e+09, got -0.5");
  refuses(good, {.step = 0}, "step must be between 1e-06 and 1, got 0");
  refuses(good, {.gravity = {0, none, 0}}, "gravity.y must be between -1e+09 and 1e+09, got nan");
  refuses(good, {.substeps = 0}, "substeps must be between 1 and 1e+06, got 0");
}

TEST_CASE("a rope of no links, of no mass or of no number is refused")
{
  CHECK_THROWS_WITH(
      make_rope({0, 0, 0}, {1, 0, 0}, 0, 1), "links must be between 1 and 1e+06, got 0");
  CHECK_THROWS_WITH(
      make_rope({0, 0, 0}, {1, 0, 0}, 2, 0), "mass must be between 1e-09 and 1e+09, got 0");
  CHECK_THROWS_WITH(
      make_rope({0, 0, 0}, {1, std::numeric_limits<double>::infinity(), 0}, 2, 1),
      Catch::Matchers::ContainsSubstring("positions[0].y must be between"));
}

TEST_CASE("a net is no rope, and what does not give is no spring")
{
  Rope net = make_rope({0, 0, 0}, {1, 0, 0}, 3, 1, 1e-4);
  net.links[2].a = 0;
  CHECK_THROWS_WITH(
      step_direct(net.particles, net.links, {}),
      "constraints[2] must join particles 2 and 3 of a rope, got 0 and 3");
  Rope rigid = make_rope({0, 0, 0}, {1, 0, 0}, 3, 1);
  CHECK_THROWS_WITH(
      step_mass_spring(rigid.particles, rigid.links, {}),
      "constraints[0].compliance must be between 1e-12 and 1e+09, got 0");
}
// [rope_refusals]
