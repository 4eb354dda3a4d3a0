/// \file
/// What pairs of shapes and worlds come to, to the bit: each line ends with one number of all bits
/// of all answers. The same from g++, clang and WebAssembly.

#include "02_primitives/shapes/shapes.hpp"
#include "03_sphere_manifolds/sphere_box/sphere_box.hpp"
#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"
#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/gjk_epa/gjk_epa.hpp"
#include "04_obb_manifolds/plain_box_box/plain_box_box.hpp"
#include "05_resolution/small_world/step_1.hpp"
#include "05_resolution/small_world/step_2.hpp"
#include "05_resolution/small_world/step_3.hpp"
#include "05_resolution/small_world/step_5.hpp"
#include "05_resolution/small_world/step_6.hpp"
#include "05_resolution/small_world/step_7.hpp"
#include "05_resolution/small_world/trial/small_scenes.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"
#include "common/math/exponential.hpp"
#include "common/math/trigonometry.hpp"

#include "tests/take/calls.hpp"

#include <string>

namespace
{

using namespace cookbook;

/// Ends a line.
void print_bits(const std::string& what, const Bits& bits)
{
  std::printf("%-48s %016llx\n", what.c_str(), static_cast<unsigned long long>(bits.sum()));
}

/// Draws pairs, or numbers, and prints what comes of 100,000.
template <class Call>
void print_draws(const std::string& what, const Call& call)
{
  Draw draw;
  Bits bits;
  for (int i = 0; i < 100'000; ++i)
  {
    call(draw, bits);
  }
  print_bits(what, bits);
}

/// Where bodies are, and how they move.
template <class Bodies>
void add_bodies(Bits& bits, const Bodies& bodies)
{
  for (const auto& body : bodies)
  {
    bits(body.motion.center, body.orientation);
    bits(body.motion.velocity, body.motion.angular_velocity);
  }
}

/// Functions, and pairs of shapes of which some lie apart and some are degenerate.
void print_pairs()
{
  print_draws(
      "sine, cosine, arc tangent, exponential",
      [](Draw& draw, Bits& bits)
      {
        const double x = draw.number(-9, 9) * draw.scale(), y = draw.number(-9, 9) * draw.scale();
        bits(sine(x), cosine(x), arc_tangent(y, x), exponential(draw.number(-700, 700)));
      });
  print_draws(
      "sphere, sphere",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale();
        const Sphere<double> a = draw.sphere<Sphere>(scale), b = draw.sphere<Sphere>(scale);
        bits(sphere_sphere(a, b));
      });
  print_draws(
      "sphere, box",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale();
        const Sphere<double> a = draw.sphere<Sphere>(scale);
        bits(sphere_box(a, draw.box<Obb>(scale)));
      });
  print_draws(
      "box, box",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale();
        const Obb<double> a = draw.box<Obb>(scale), b = draw.box<Obb>(scale);
        bits(box_box(a, b));
      });
  print_draws(
      "box, box, plain",
      [](Draw& draw, Bits& bits)
      {
        const Obb<double> a = draw.box<Obb>(), b = draw.box<Obb>();
        bits(plain_box_box(a, b));
      });
  print_draws(
      "box, box by GJK and EPA",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale();
        const Obb<double> a = draw.box<Obb>(scale), b = draw.box<Obb>(scale);
        bits(gjk_epa(a, b));
      });
}

/// A small world after 300 frames.
template <class World>
void print_small_world(const std::string& what, World world)
{
  Bits bits;
  for (int i = 0; i < 300; ++i)
  {
    step(world, small_world::frame);
  }
  add_bodies(bits, world.bodies);
  print_bits("small world, " + what, bits);
}

/// Stacks and shots of one step of the small world.
template <class World>
void print_small_worlds(const std::string& step)
{
  using namespace small_world;
  print_small_world(step + ", a tower of 5", tower<World>(5));
  print_small_world(step + ", a pyramid of 4 rows", pyramid<World>(4));
  print_small_world(step + ", a sphere that bounces", dropped_sphere<World>(1, 0.5));
  World thrown = tower<World>(4);
  small_world::RigidBody ball = sphere({-6, 1.7, 0.2}, 0.3, 5);
  ball.motion.velocity = {12, 3, 0};
  ball.motion.angular_velocity = {1, 2, 30};
  add(thrown, ball);
  print_small_world(step + ", a shot at a tower", thrown);
}

/// A scene of chapter 6 under a solver, after 300 steps.
void print_world(const std::string& scene, const std::string& solver)
{
  GameWorld world(named_scene(scene), solver_named(solver), true);
  Bits bits;
  for (int i = 0; i < 300; ++i)
  {
    world.step();
  }
  add_bodies(bits, world.bodies());
  print_bits(scene + ", " + solver, bits);
}

} // namespace

int main()
{
  print_pairs();
  print_small_worlds<small_world::step_1::World>("step 1");
  print_small_worlds<small_world::step_2::World>("step 2");
  print_small_worlds<small_world::step_3::World>("step 3");
  print_small_worlds<small_world::step_4::World>("step 4");
  print_small_worlds<small_world::step_5::World>("step 5");
  print_small_worlds<small_world::step_6::World>("step 6");
  print_small_worlds<small_world::step_7::World>("step 7");
  print_world("tower_turned_10", "direct");
  print_world("card_house_2", "direct");
  print_world("wall_hit_6", "direct");
  print_world("spinning_top", "direct");
  print_world("bounce", "direct");
  print_world("pile_40", "soft_steps");
  print_world("domino_12", "soft_steps");
  print_world("thin_wall_100", "soft_steps");
  print_world("pit_40", "wide_steps");
  print_world("pyramid_8", "wide_steps");
  print_world("rolling", "sequential_impulses");
  print_world("tower_shifted_6", "sequential_impulses");
  print_world("tower_dropped_5", "cold_impulses");
  print_world("overlap", "position_based");
  print_world("heavy_on_light_10", "position_based");
}
