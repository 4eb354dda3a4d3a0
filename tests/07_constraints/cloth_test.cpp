/// \file
/// Cloths: how far they stretch, their symmetry and energy, wind, contacts, odd input, and what is
/// left out.

#include "07_constraints/cloth/cloth.hpp"
#include "07_constraints/cloth/trial/cloth_scenes.hpp"
#include "07_constraints/cloth/trial/live_cloth.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

using namespace cookbook;

namespace
{

/// The held square after some frames.
Cloth sagged_square(int substeps, int iterations, int frames = 240, double damping = 4)
{
  Cloth cloth = held_square();
  StepSettings settings;
  settings.damping = damping;
  settings.substeps = substeps;
  settings.iterations = iterations;
  run_cloth(cloth, frames, settings, {}, {.density = 0});
  return cloth;
}

/// The largest speed of a cloth's particles [m/s].
double fastest(const Cloth& cloth)
{
  double most = 0;
  for (const Vector3<double>& velocity : cloth.particles.velocities)
  {
    most = std::max(most, velocity.norm());
  }
  return most;
}

bool is_finite(const Cloth& cloth)
{
  return std::all_of(
             cloth.particles.positions.begin(), cloth.particles.positions.end(),
             [](const Vector3<double>& x) { return x.allFinite(); }) &&
         std::isfinite(fastest(cloth));
}

/// The highest energy above that at rest [J] that the held square has within two seconds.
double energy_gained(int substeps)
{
  Cloth cloth = held_square();
  StepSettings settings;
  settings.substeps = substeps;
  const double start = energy_of(cloth);
  double most = -std::numeric_limits<double>::infinity();
  for (int frame = 0; frame < 120; ++frame)
  {
    step_cloth(cloth, settings, {}, {.density = 0});
    most = std::max(most, energy_of(cloth) - start);
  }
  return most;
}

} // namespace

// [grid]
TEST_CASE("a grid of 4 by 3 has 17 threads, 12 diagonals and 10 constraints against bending")
{
  const Cloth cloth = make_cloth({.columns = 4, .rows = 3, .mass = 6});
  CHECK(cloth.constraints.size() == 17 + 12 + 10);
  CHECK(cloth.triangles.size() == 12);
  CHECK(cloth.particles.inverse_masses[0] == Catch::Approx(2)); // twelve of half a kilogram
  CHECK(area_of(cloth) == Catch::Approx(1));
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (const DistanceConstraint& one : cloth.constraints)
  {
    pairs.insert(std::minmax(one.a, one.b));
    CHECK(direction_of(cloth.particles, one).length == one.length);
  }
  CHECK(pairs.size() == cloth.constraints.size()); // none twice
}
// [grid]

// [stretch]
TEST_CASE(
    "a held square's threads stretch by 4 % at ten substeps, by 17 % at ten iterations", "[long]")
{
  CHECK(worst_thread(sagged_square(10, 1)) == Catch::Approx(0.040).epsilon(0.02));
  CHECK(worst_thread(sagged_square(1, 10)) == Catch::Approx(0.167).epsilon(0.02));
}
// [stretch]

// [symmetry]
TEST_CASE(
    "a held square stays its own mirror image to 1e-14 m, and its diagonals' to 2 mm", "[long]")
{
  const Cloth cloth = sagged_square(10, 1);
  const auto& x = cloth.particles.positions;
  double mirrored = 0, exchanged = 0;
  for (std::size_t row = 0; row < 16; ++row)
  {
    for (std::size_t column = 0; column < 16; ++column)
    {
      const Vector3<double>& p = x[cloth.at(column, row)];
      const Vector3<double>& left = x[cloth.at(15 - column, row)];
      const Vector3<double>& behind = x[cloth.at(column, 15 - row)];
      const Vector3<double>& turned = x[cloth.at(row, column)];
      mirrored = std::max(mirrored, (p - Vector3<double>(-left.x(), left.y(), left.z())).norm());
      mirrored =
          std::max(mirrored, (p - Vector3<double>(behind.x(), behind.y(), -behind.z())).norm());
      exchanged =
          std::max(exchanged, (p - Vector3<double>(turned.z(), turned.y(), turned.x())).norm());
    }
  }
  CHECK(mirrored <= 1e-14);
  CHECK(exchanged <= 2e-3); // threads across are corrected before those down
  CHECK(exchanged >= 1e-3);
}
// [symmetry]

// [cloth_energy]
TEST_CASE(
    "at 30 substeps a cloth never has more energy than at the start; at one it gains 100 J",
    "[long]")
{
  CHECK(energy_gained(30) <= 0);
  CHECK(energy_gained(1) > 100);
}
// [cloth_energy]

// [R48]
TEST_CASE(
    "wind of 10 m/s presses on a square metre by 60 N, and by half a turn not at all", "[R48]")
{
  // ½ ρ c A u² = ½ · 1.2 · 1 · 100.
  for (const double sign : {-1.0, 1.0})
  {
    Cloth cloth = make_cloth({.down = {0, 1, 0}, .columns = 3, .rows = 3, .mass = 900});
    const double h = 1e-3;
    Vector3<double> momentum(0, 0, 0);
    for (const auto& triangle : cloth.triangles)
    {
      apply_wind(cloth.particles, triangle, {5, 3, 10 * sign}, 1.2, h);
    }
    for (const Vector3<double>& velocity : cloth.particles.velocities)
    {
      momentum += 100 * velocity;
    }
    CHECK(momentum.x() == 0); // what blows along it slides by
    CHECK(momentum.y() == 0);
    CHECK(momentum.z() / h == Catch::Approx(60 * sign).epsilon(1e-4));
  }
}

TEST_CASE("no wind is too strong: a veil of 1 g in 1,000 m/s takes on no more than that", "[R48]")
{
  // The force at the start, for a whole step, would make it 10,000 km/s: ½ ρ u² h / (1 g/m²).
  Cloth cloth = make_cloth({.down = {0, 1, 0}, .mass = 1e-3});
  StepSettings settings;
  settings.gravity = {0, 0, 0};
  for (int frame = 0; frame < 60; ++frame)
  {
    step_cloth(cloth, settings, {}, {.wind = {0, 0, 1000}});
    CHECK(cloth.particles.velocities[cloth.at(8, 8)].z() > 0);
    CHECK(cloth.particles.velocities[cloth.at(8, 8)].z() <= 1001);
  }
  CHECK(cloth.particles.velocities[cloth.at(8, 8)].z() == Catch::Approx(1000).epsilon(0.01));
}

TEST_CASE("a triangle falls by √(2 m g / ρ A) in the end; one without area has no wind", "[R48]")
{
  Particles three;
  three.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
  three.velocities.assign(3, Vector3<double>(0, 0, 0));
  three.inverse_masses.assign(3, 10.0); // .3 kg on half a square metre
  const double h = 1e-3;
  for (int substep = 0; substep < 5000; ++substep)
  {
    apply_gravity(three, {}, h);
    apply_wind(three, {0, 1, 2}, {0, 0, 0}, 1.2, h);
  }
  CHECK(-three.velocities[0].y() == Catch::Approx(std::sqrt(2 * 0.3 * 9.81 / 0.6)).epsilon(0.02));
  Particles heap = three;
  heap.positions.assign(3, Vector3<double>(1, 2, 3));
  apply_wind(heap, {0, 1, 2}, {100, 100, 100}, 1.2, h);
  CHECK(heap.velocities == three.velocities);
}
// [R48]

// [R49]
TEST_CASE(
    "on a slope of 30° a sheet stays where friction is .6, and slides by .4 as a crate", "[R49]")
{
  const double sine = 0.5, cosine = std::sqrt(0.75);
  for (const double friction : {0.6, 0.4})
  {
    CAPTURE(friction);
    Cloth sheet = make_cloth(
        {.corner = {0, 0.01 / cosine, 0}, .across = {cosine, sine, 0}, .columns = 4, .rows = 4});
    Obstacles slope;
    slope.planes = {{{-sine, cosine, 0}, 0}};
    slope.friction = friction;
    StepSettings settings;
    settings.substeps = 10;
    const Vector3<double> start = sheet.particles.positions[5];
    run_cloth(sheet, 60, settings, slope, {.density = 0});
    const double moved = (sheet.particles.positions[5] - start).norm();
    const double pull = 9.81 * std::max(0.0, sine - friction * cosine); // [m/s²]
    CHECK(moved == Catch::Approx(pull / 2).epsilon(0.005).margin(1e-9));
  }
}

TEST_CASE(
    "a cloth rests on a sphere, a capsule, a box, a plane, and no particle is inside",
    "[R49][long]")
{
  std::vector<Obstacles> on(4);
  on[0].spheres = {{{0, 0, 0}, 0.4}};
  on[1].capsules = {{{{-0.3, 0.1, 0}, {0.3, 0.1, 0}}, 0.25}};
  on[2].boxes = {{{0, 0.05, 0}, Matrix3<double>::Identity(), {0.35, 0.3, 0.35}}};
  on[3].planes = {{{0, 1, 0}, 0.2}};
  for (const Obstacles& obstacles : on)
  {
    Cloth cloth = falling_square(14);
    StepSettings settings;
    settings.substeps = 10;
    settings.damping = 4;
    for (int second = 0; second < 5; ++second)
    {
      run_cloth(cloth, 60, settings, obstacles);
      for (const Vector3<double>& x : cloth.particles.positions)
      {
        double away = 1;
        for (const Sphere<double>& sphere : obstacles.spheres)
        {
          away = std::min(away, (x - sphere.center).norm() - sphere.radius);
        }
        for (const Capsule<double>& capsule : obstacles.capsules)
        {
          away = std::min(away, (x - closest_point(capsule.segment, x)).norm() - capsule.radius);
        }
        for (const Obb<double>& box : obstacles.boxes)
        {
          away = std::min(away, signed_distance(box, x));
        }
        for (const Plane<double>& plane : obstacles.planes)
        {
          away = std::min(away, signed_distance(plane, x));
        }
        CHECK(away >= obstacles.thickness - 1e-12);
      }
    }
    CHECK(fastest(cloth) < 1e-3);
  }
}
// [R49]

// [left_out]
TEST_CASE(
    "left out, layers that touch: a folded cloth ends with both of them at one height", "[long]")
{
  Cloth cloth = make_cloth({.down = {0, 0, 0.5}, .columns = 21, .rows = 11, .bend = 100});
  for (std::size_t i = 0; i < cloth.particles.positions.size(); ++i)
  {
    Vector3<double>& x = cloth.particles.positions[i];
    const std::size_t column = i % 21;
    const double up = column <= 10 ? 0.1 : column == 11 ? 0.15 : 0.2;
    x = {column <= 10 ? x.x() : column <= 12 ? 0.5 : 1.1 - x.x(), up, x.z()};
  }
  Obstacles floor;
  floor.planes = {{{0, 1, 0}, 0}};
  StepSettings settings;
  settings.substeps = 10;
  settings.damping = 1;
  run_cloth(cloth, 120, settings, floor);
  const double lower = cloth.particles.positions[cloth.at(4, 5)].y();
  const double upper = cloth.particles.positions[cloth.at(18, 5)].y();
  CHECK(lower == Catch::Approx(0.01).margin(1e-6)); // one thickness; right
  CHECK(upper == Catch::Approx(0.01).margin(1e-6)); // right would be three
}

TEST_CASE("left out, edges: between its particles a cloth lets the corner of a box through")
{
  Cloth cloth = falling_square(4); // threads of half a metre
  Obstacles obstacles;
  obstacles.boxes = {{{0, 0, 0}, Matrix3<double>::Identity(), {0.1, 0.1, 0.1}}};
  StepSettings settings;
  settings.substeps = 10;
  run_cloth(cloth, 120, settings, obstacles);
  CHECK(cloth.particles.positions[5].y() < -1); // it has fallen through
}
// [left_out]

// [cloth_inputs]
TEST_CASE("cloths of a millimetre and of a kilometre sag alike, in their own time")
{
  std::vector<double> sags;
  for (const double size : {1e-3, 1.0, 1e3})
  {
    Cloth cloth = make_cloth(
        {.across = {size, 0, 0}, .down = {0, 0, size}, .columns = 8, .rows = 8, .mass = 1});
    cloth.particles.inverse_masses[0] = cloth.particles.inverse_masses[7] = 0;
    StepSettings settings;
    settings.gravity = {0, -size, 0};
    settings.substeps = 10;
    run_cloth(cloth, 60, settings, {}, {.density = 0});
    sags.push_back(cloth.particles.positions[60].y() / size);
  }
  CHECK(sags[0] == Catch::Approx(sags[1]).epsilon(1e-9));
  CHECK(sags[2] == Catch::Approx(sags[1]).epsilon(1e-9));
}

TEST_CASE("odd cloths stay finite: in one place, a million times heavier, a second a step, inside")
{
  Cloth cloth = falling_square(8);
  Obstacles sphere;
  sphere.spheres = {{{0, 0, 0}, 0.4}};
  Cloth heap = cloth, heavy = cloth, inside = cloth, pinned = cloth;
  heap.particles.positions.assign(64, Vector3<double>(0, 0.5, 0));
  heavy.particles.inverse_masses[27] *= 1e-6;
  inside.particles.positions.assign(64, Vector3<double>(0, 0, 0));
  pinned.particles.inverse_masses.assign(64, 0.0);
  for (Cloth one : {heap, heavy, inside, pinned})
  {
    for (const double step : {1.0 / 60, 1.0})
    {
      StepSettings settings;
      settings.step = step;
      settings.substeps = 5;
      run_cloth(one, 60, settings, sphere);
      CHECK(is_finite(one));
    }
  }
  CHECK(pinned.particles.positions == cloth.particles.positions);
}

TEST_CASE("a cloth of two by two, without weight, keeps its place to the bit")
{
  const Cloth cloth = make_cloth({.columns = 2, .rows = 2});
  Cloth moved = cloth;
  StepSettings settings;
  settings.gravity = {0, 0, 0};
  run_cloth(moved, 60, settings);
  CHECK(moved.particles.positions == cloth.particles.positions);
}

TEST_CASE("cloths, obstacles and wind that make no sense are refused with member and value")
{
  using Catch::Matchers::ContainsSubstring;
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(make_cloth({.columns = 1}), "columns must be between 2 and 10000, got 1");
  CHECK_THROWS_WITH(make_cloth({.mass = -1}), ContainsSubstring("mass must be between"));
  CHECK_THROWS_WITH(make_cloth({.across = {none, 0, 0}}), ContainsSubstring("positions[0].x"));
  CHECK_THROWS_WITH(make_cloth({.shear = -1}), ContainsSubstring("compliance must be between"));
  Cloth cloth = make_cloth({});
  CHECK_THROWS_WITH(
      step_cloth(cloth, {}, {.spheres = {{{0, 0, 0}, -1}}}), "radius must be zero or more, got -1");
  CHECK_THROWS_WITH(
      step_cloth(cloth, {}, {.friction = -1}), "friction must be between 0 and 1e+09, got -1");
  CHECK_THROWS_WITH(
      step_cloth(cloth, {}, {}, {.wind = {0, none, 0}}),
      ContainsSubstring("wind.y must be between"));
  cloth.triangles[3][1] = 256;
  CHECK_THROWS_WITH(
      step_cloth(cloth, {}), ContainsSubstring("triangles[3] must join three of 256 particles"));
}
// [cloth_inputs]

TEST_CASE("a particle that is dragged is there in time, and free when it is let go", "[cloth]")
{
  Cloth cloth = held_square();
  const Vector3<double> at = cloth.particles.positions[136];
  const double inverse_mass = cloth.particles.inverse_masses[136];
  std::optional<DraggedParticle> held =
      take_hold(cloth, {at - Vector3<double>(0, 9, 0), {0, 1, 0}});
  REQUIRE(held.has_value());
  CHECK(held->place == 136);
  held->target.y() += 0.2;
  for (int frame = 0; frame < 5; ++frame) // at 3 m/s it takes four
  {
    pull(cloth, *held, 1.0 / 60);
    step_cloth(cloth, {.substeps = 10});
  }
  CHECK((cloth.particles.positions[136] - held->target).norm() < 1e-12);
  let_go(cloth, held);
  CHECK(!held);
  CHECK(cloth.particles.inverse_masses[136] == inverse_mass);
  CHECK(!take_hold(cloth, {{9, 9, 9}, {0, 1, 0}}));
}
