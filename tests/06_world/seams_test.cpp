/// \file
/// Flush tiles: what rolls, slides or rests on them behaves as on one slab; what is a real step,
/// end, wall or bend stays one.

#include "06_world/islands/find_islands.hpp"
#include "06_world/islands/island_points.hpp"
#include "06_world/seams/join_flush_faces.hpp"
#include "06_world/seams/trial/seam_scenes.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace cookbook;
using namespace cookbook::seams;

namespace
{

const std::vector<std::string> recommended{"direct", "soft_steps", "wide_steps"};

/// A tile of 1 m: its top at a height [m], its centre at x [m].
SceneBody tile(double x, double height = 0)
{
  return box_body("tile", {0.5, 0.5, 0.5}, {x, height - 0.5, 0}, 0);
}

/// A body after a time [s].
Motion<double> after(const Scene& scene, const std::string& solver, double time)
{
  GameWorld world(scene, solver_named(solver));
  while (world.time() < time)
  {
    world.step();
  }
  return world.bodies().back().motion;
}

/// The runs of spheres and crates of all sizes and speeds, on so many headings, over tiles of three
/// sizes. At 20 m/s they go by a third of a metre in a step, the smallest by 33 of their radii.
std::vector<SeamRun> runs(int headings)
{
  std::vector<SeamRun> all;
  for (const double speed : {0.5, 2.0, 6.0, 20.0})
  {
    for (const double tile : {0.3, 1.0, 2.5})
    {
      for (int i = 0; i < headings; ++i)
      {
        const double heading = 2 * std::numbers::pi * (i + 0.137) / headings;
        const double x = 0.31 * tile * std::sin(7.0 * i), z = 0.29 * tile * std::cos(5.0 * i);
        const double duration = std::min(2.0, 12 / speed);
        for (const double radius : {0.01, 0.05, 0.2, 1.0})
        {
          all.push_back({rolling_sphere(radius, speed, heading, x, z), tile, 0.6, duration});
        }
        for (const double size : {0.05, 0.25, 0.6})
        {
          const Vector3<double> half(size, 0.7 * size, 0.8 * size);
          all.push_back({sliding_crate(half, speed, heading, 0.3 * i, x, z), tile, 0.3, duration});
        }
      }
    }
  }
  return all;
}

/// A sphere on tiles as a plain world has it, and with contacts decided by the surface.
struct TileWorld
{
  Scene scene;
  std::vector<RigidBody> bodies;
  std::vector<WorldContact> contacts, begun;
  Seams seams;
  SolverScratch scratch;
  Islands islands;

  explicit TileWorld(Scene of) : scene(std::move(of))
  {
    for (const SceneBody& body : scene.bodies)
    {
      bodies.push_back(rigid_body(body));
    }
  }

  /// Finds the contacts of the last body, and joins them.
  void find_contacts(bool joined)
  {
    const double margin = contact_margin(scene);
    const auto none_sleeps = [](int) { return false; };
    const auto each_pair = [&](const auto& call)
    {
      const int last = static_cast<int>(bodies.size()) - 1;
      for (int i = 0; i < last; ++i)
      {
        call(std::pair(i, last));
      }
    };
    update_contacts(
        contacts, begun, seams.changes, scene, bodies, each_pair,
        [&](int, int) {
          return ContactMargins{margin, margin};
        },
        none_sleeps);
    if (joined)
    {
      join_flush_faces(seams, scene, bodies, contacts, margin, none_sleeps);
    }
  }

  /// Steps on.
  void step(bool joined, const WorldSolver& solver)
  {
    find_contacts(joined);
    islands.find(bodies, contacts);
    const std::vector<Island> all{islands[0]};
    solver({bodies, contacts, scene.gravity, scratch}, all, scene.step);
    return_points(seams, contacts);
  }
};

/// Whether a run on tiles is that on a slab: its height to .1 mm, its speed to .1 %.
bool is_as_on_slab(const SeamError& error)
{
  return error.height <= 1e-4 && error.speed <= 1e-3;
}

} // namespace

// [tile_by_tile]
TEST_CASE(
    "tile by tile, a sphere sunk by .2 mm meets the next tile's edge; on the surface it does not")
{
  TileWorld world({.bodies = {tile(0), tile(1), ball_body("sphere", 0.05, {0.498, 0.0498, 0})}});
  world.find_contacts(false);
  REQUIRE(world.contacts.size() == 2);
  // From the edge at x = .5, y = 0 to the centre: 2 mm back, 49.8 mm up.
  const Vector3<double> edge = Vector3<double>(-2, 49.8, 0).normalized();
  CHECK((world.contacts[1].normal - edge).norm() < 1e-12);
  world.find_contacts(true);
  return_points(world.seams, world.contacts);
  REQUIRE(world.contacts.size() == 1);
  CHECK(world.contacts[0].normal == Vector3<double>::UnitY());
}

TEST_CASE("on tiles of 30 cm a sphere of 20 cm loses 2 % of .5 m/s in 4 s tile by tile, nothing on "
          "the surface")
{
  const double speed = 0.5;
  const SeamRun run{rolling_sphere(0.2, speed, 0.7, 0, 0), 0.3, 0.6, 4};
  const auto lost = [&](bool joined)
  {
    TileWorld world(on_tiles(run));
    const WorldSolver solver = solver_named("soft_steps");
    for (double time = 0; time < run.duration; time += world.scene.step)
    {
      world.step(joined, solver);
    }
    return 1 - world.bodies.back().motion.velocity.norm() / speed;
  };
  CHECK(lost(false) > 0.02);
  CHECK(std::abs(lost(true)) < 1e-9);
}
// [tile_by_tile]

// [as_on_one_slab]
TEST_CASE("tiles are as one slab on 3 headings: height to .1 mm, speed to .1 %")
{
  for (const std::string& solver : recommended)
  {
    for (const SeamRun& run : runs(3))
    {
      CAPTURE(solver, run.body.name, reach_of(run.body), run.body.velocity.norm(), run.tile);
      CHECK(is_as_on_slab(difference(run, solver)));
    }
  }
}
// [as_on_one_slab]

TEST_CASE("tiles are as one slab on 40 headings: height to .1 mm, speed to .1 %", "[long]")
{
  for (const std::string& solver : recommended)
  {
    for (const SeamRun& run : runs(40))
    {
      CAPTURE(solver, run.body.name, reach_of(run.body), run.body.velocity.norm(), run.tile);
      CHECK(is_as_on_slab(difference(run, solver)));
    }
  }
}

TEST_CASE("turned, sloping, uneven, overlapping, tiny, far away: tiles are as one slab")
{
  for (const std::vector<SeamScene>& scenes : {sphere_scenes(), crate_scenes()})
  {
    for (const SeamScene& scene : scenes)
    {
      for (const std::string& solver : recommended)
      {
        CAPTURE(scene.name, solver);
        const SeamError error = difference(scene.tiles, scene.slab, solver, scene.duration);
        // Also on a slab the direct solver finds no answer for a sphere sunk by 1 µm, and has
        // soft contacts until it does: they give way by .3 mm.
        const bool sunk = solver == "direct" && scene.slab.bodies.back().name == "sphere";
        CHECK(error.height <= (sunk ? 4e-4 : 1e-4));
        CHECK(error.speed <= 1e-3);
      }
    }
  }
}

TEST_CASE(
    "the order in which tiles were added changes no bit of a sphere's run, nor 1 µm of a crate's")
{
  for (const std::string& solver : recommended)
  {
    for (const bool crate : {false, true})
    {
      SeamRun run{rolling_sphere(0.2, 2, 0.7, 0.1, 0.05), 0.5, 0.6, 2};
      if (crate)
      {
        run = {sliding_crate({0.3, 0.2, 0.25}, 4, 0.7, 0.4, 0.1, 0.05), 0.5, 0.3, 2};
      }
      const Scene one = on_tiles(run);
      Scene other = one;
      std::reverse(other.bodies.begin(), other.bodies.end() - 1);
      const SeamError error = difference(one, other, solver, run.duration);
      CAPTURE(solver, crate);
      CHECK(error.place <= (crate ? 1e-6 : 0));
    }
  }
}

// [real_edges]
TEST_CASE("a step of 1 mm stays one: a wheel of 30 cm that comes at .5 m/s climbs it")
{
  for (const std::string& solver : recommended)
  {
    Scene scene{.bodies = {tile(0), tile(1), tile(2, 1e-3), tile(3, 1e-3)}};
    scene.bodies.push_back(rolling_sphere(0.3, 0.5, 0, 1, 0));
    const Motion<double> end = after(scene, solver, 1.8);
    CAPTURE(solver, end.velocity.norm());
    CHECK(end.center.x() > 1.7);
    CHECK(end.center.y() == Catch::Approx(0.301).margin(4e-4)); // soft contacts sink
    CHECK(end.velocity.norm() < 0.985 * 0.5);                   // by its height alone it is 0.972
  }
}

TEST_CASE("what goes over the end of the last tile falls; a box that overhangs by 60 % tips")
{
  for (const std::string& solver : recommended)
  {
    CAPTURE(solver);
    Scene scene{.bodies = {tile(0), tile(1), rolling_sphere(0.2, 2, 0, 1, 0)}};
    CHECK(after(scene, solver, 1).center.y() < -1);
    scene.bodies.back() = box_body("box", {0.5, 0.1, 0.2}, {1.6, 0.1, 0});
    CHECK(after(scene, solver, 1).center.y() < -0.5);
    scene.bodies.back() = box_body("box", {0.5, 0.1, 0.2}, {1.4, 0.1, 0});
    CHECK(after(scene, solver, 1).center.y() == Catch::Approx(0.1).margin(1e-3));
  }
}

TEST_CASE("a wall that stands on the tiles stops a sphere and a crate, also in the corner of two")
{
  for (const std::string& solver : recommended)
  {
    CAPTURE(solver);
    Scene scene = on_tiles({rolling_sphere(0.2, 2, 0.3, 0, 0), 0.5, 0.6, 2});
    SceneBody moving = scene.bodies.back();
    scene.bodies.back() = box_body("wall", {0.25, 0.5, 2}, {1.25, 0.5, 0}, 0);
    scene.bodies.push_back(box_body("wall", {2, 0.5, 0.25}, {0, 0.5, 0.75}, 0));
    for (const bool crate : {false, true})
    {
      moving = crate ? sliding_crate({0.2, 0.2, 0.2}, 4, 0.3, 0, 0, 0) : moving;
      scene.bodies.push_back(moving);
      const Motion<double> end = after(scene, solver, 2);
      CHECK(end.center.x() < 0.801);
      CHECK(end.center.z() < 0.301);
      CHECK(end.center.y() == Catch::Approx(0.2).margin(1e-3));
      scene.bodies.pop_back();
    }
  }
}

TEST_CASE("at 20 m/s, too, a sphere and a crate hit a step of 2 cm, and a wall on the tiles")
{
  for (const std::string& solver : recommended)
  {
    for (const bool crate : {false, true})
    {
      for (const double step : {0.02, 1.0})
      {
        Scene scene{.bodies = {tile(0), tile(1), tile(2), tile(3, step), tile(4, step)}};
        scene.bodies.push_back(
            crate ? sliding_crate({0.05, 0.05, 0.05}, 20, 0, 0, 0, 0)
                  : rolling_sphere(0.05, 20, 0, 0, 0));
        GameWorld world(scene, solver_named(solver));
        double most = 0;
        for (int i = 0; i < 12; ++i)
        {
          world.step();
          most = std::max(most, world.bodies().back().motion.center.x());
        }
        const Motion<double>& end = world.bodies().back().motion;
        CAPTURE(solver, crate, step);
        // It comes to the step at x = 2.5 m, and climbs it or is thrown back.
        const bool thrown_up = end.center.y() > 0.05 + step;
        CHECK((step < 1 ? thrown_up || most < 2.451 : most < 2.451));
        CHECK(end.velocity.x() < 19);
      }
    }
  }
}

TEST_CASE("tiles that bend by 1° stay a bend: a sphere that rolls at 4 m/s turns up with it")
{
  const double angle = std::numbers::pi / 180;
  for (const std::string& solver : recommended)
  {
    Scene scene{.gravity = {0, -9.81, 0}};
    scene.bodies = {box_body("level", {2, 0.5, 1}, {-2, -0.5, 0}, 0)};
    SceneBody slope = box_body("slope", {4, 0.5, 1}, {0, 0, 0}, 0);
    slope.orientation = Quaternion<double>(std::cos(angle / 2), 0, 0, std::sin(angle / 2));
    slope.position = slope.orientation * Vector3<double>(4, -0.5, 0);
    scene.bodies.push_back(slope);
    scene.bodies.push_back(rolling_sphere(0.2, 4, 0, -1, 0));
    const Motion<double> end = after(scene, solver, 1);
    CAPTURE(solver);
    const double above = -std::sin(angle) * end.center.x() + std::cos(angle) * end.center.y();
    CHECK(above == Catch::Approx(0.2).margin(1e-3));
    CHECK(end.velocity.y() / end.velocity.x() == Catch::Approx(std::tan(angle)).margin(1e-3));
  }
}
// [real_edges]

TEST_CASE("from rough tiles to smooth ones friction follows the tile")
{
  for (const std::string& solver : recommended)
  {
    Scene scene{.bodies = {tile(0), tile(1), tile(2), tile(3)}};
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    {
      scene.bodies[i].friction = i < 2 ? 0.5 : 0;
    }
    scene.bodies.push_back(sliding_crate({0.1, 0.1, 0.1}, 4, 0, 0, 0, 0));
    scene.bodies.back().friction = 0.5;
    // Rough until the centre is at 1.5 m, about: v² = 16 − 2 · 0.5 g · 1.5.
    const double expected = std::sqrt(16 - 9.81 * 1.5);
    CAPTURE(solver);
    CHECK(after(scene, solver, 0.9).velocity.norm() == Catch::Approx(expected).margin(0.1));
  }
}
