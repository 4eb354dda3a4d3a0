/// \file
/// Heaps in pits: all come to rest and sleep, and none gains energy.

#include "06_world/game_world/game_world.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "06_world/scenes/trial/heap_scenes.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

using namespace cookbook;

namespace
{

/// What a heap is made of.
enum class Kind
{
  spheres,
  boxes,
  both ///< in turn
};

constexpr double body_mass = 2;

/// A pit with four walls.
Scene pit(double half)
{
  Scene scene;
  for (const Vector3<double>& normal :
       {Vector3<double>(0, 1, 0), Vector3<double>(1, 0, 0), Vector3<double>(-1, 0, 0),
        Vector3<double>(0, 0, 1), Vector3<double>(0, 0, -1)})
  {
    const double offset = normal.y() > 0 ? 0 : -half;
    scene.bodies.push_back({.name = "wall", .shape = PlaneShape{normal, offset}});
  }
  return scene;
}

/// Bodies of about 30 cm that fall into a pit, damped a little.
Scene heap(int count, Kind kind)
{
  const double radius = 0.15;
  const int side = std::max(2, static_cast<int>(std::ceil(std::cbrt(count / 1.5))));
  Scene scene = pit(side * radius * 1.35);
  scenes::Mixer mixer;
  const auto shift = [&] { return mixer.between(-5, 5) / 250.0; };
  const auto across = [&](int cell) { return (cell - 0.5 * (side - 1)) * 2.4 * radius; };
  for (int i = 0; i < count; ++i)
  {
    const int layer = i / (side * side);
    const double x = across(i % side) + shift(), z = across(i / side % side) + shift();
    const double of_both = kind == Kind::both ? 0.9 * radius : radius;
    SceneBody body =
        ball_body(numbered("body", i), of_both, {x, 0.3 + 2.5 * radius * layer, z}, body_mass);
    if (kind == Kind::boxes || (kind == Kind::both && i % 2 == 1))
    {
      const double y_half = mixer.between(6, 9) / 75.0, z_half = mixer.between(6, 9) / 75.0;
      body.shape = BoxShape{{0.12, y_half, z_half}};
      const int w = mixer.between(1, 5), a = mixer.between(-3, 3), b = mixer.between(-3, 3);
      body.orientation = whole_turn(w, a, b, mixer.between(-3, 3));
    }
    body.damping = 0.1;
    body.angular_damping = 1;
    scene.bodies.push_back(body);
  }
  return scene;
}

/// How a heap came to rest.
struct Rest
{
  double time = 0;   ///< [s], from the last impact of more than 30 cm/s until all slept; or 15
  double raised = 0; ///< [m], by which the energy regained from a second after it would lift all
};

Rest rest_of(const Scene& scene, const std::string& solver)
{
  GameWorld world(scene, solver_named(solver), true);
  const double weight = static_cast<double>(scene.bodies.size() - 5) * body_mass * 9.81; // N
  double last_impact = 0, lowest = 0;
  Rest rest;
  bool all_asleep = false;
  while (!all_asleep && rest.time < 15)
  {
    world.step();
    const auto is_hard = [](const Impact& impact) { return std::abs(impact.speed) > 0.3; };
    if (std::any_of(world.impacts().begin(), world.impacts().end(), is_hard))
    {
      last_impact = world.time();
      rest.raised = 0;
    }
    rest.time = world.time() - last_impact;
    const double now = energy(world.bodies(), scene.gravity);
    lowest = rest.time < 1 ? now : std::min(lowest, now);
    rest.raised = std::max(rest.raised, (now - lowest) / weight);
    all_asleep = true;
    for (std::size_t i = 5; i < scene.bodies.size(); ++i)
    {
      all_asleep = all_asleep && world.is_asleep(i);
    }
  }
  return rest;
}

void check_rest(int count, Kind kind, const std::string& solver)
{
  CAPTURE(count, static_cast<int>(kind), solver);
  const Rest rest = rest_of(heap(count, kind), solver);
  if (kind != Kind::both) // of 18 mixed heaps two were not all asleep after 15 s
  {
    CHECK(rest.time < 10);
  }
  const bool boxes_directly = kind == Kind::boxes && solver == "direct";
  CHECK(rest.raised < (boxes_directly ? 1e-3 : 1e-4));
}

} // namespace

TEST_CASE(
    "pits of 15 to 100 spheres or boxes sleep within 10 s, and regain less than lifts them .1 mm, "
    "boxes under direct 1 mm; mixed ones too, but for sleep")
{
  const std::string solver = GENERATE(std::string("direct"), "soft_steps", "wide_steps");
  const Kind kind = GENERATE(Kind::spheres, Kind::boxes, Kind::both);
  check_rest(GENERATE(15, 30, 60, 100), kind, solver);
}

TEST_CASE(
    "pits of 200 and 400 spheres or boxes sleep within 10 s, and regain less than lifts them .1 "
    "mm, "
    "boxes under direct 1 mm; mixed ones too, but for sleep",
    "[long]")
{
  const std::string solver = GENERATE(std::string("direct"), "soft_steps", "wide_steps");
  const Kind kind = GENERATE(Kind::spheres, Kind::boxes, Kind::both);
  check_rest(GENERATE(200, 400), kind, solver);
}
