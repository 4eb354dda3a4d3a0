/// \file
/// Contacts that are none: tiles laid flush, edges that are passed, ledges that carry.

#include "06_world/contacts/ghost_contact.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

using namespace cookbook;

namespace
{

const Obb<double> cube{{0, 0.5, 0}, Matrix3<double>::Identity(), {0.5, 0.5, 0.5}};

/// A tile of 1 m, its top at a height [m], its left side at x = 0.51: 1 cm from the cube's.
Obb<double> tile(double height)
{
  return {{1.01, height - 0.5, 0}, Matrix3<double>::Identity(), {0.5, 0.5, 0.5}};
}

const Vector3<double> right(1, 0, 0);
const double eighth = std::sqrt(0.5); // the sine and the cosine of 45°

/// A turn of 45° about an axis.
Matrix3<double> eighth_turn(const Vector3<double>& axis)
{
  return Eigen::AngleAxis<double>(std::numbers::pi / 4, axis).toRotationMatrix();
}

/// What becomes of the speed of a body that moves over tiles.
struct Slide
{
  double lost = 0;   ///< [1], of its speed, at the end
  double upward = 0; ///< [m/s], the most, up or down
};

/// Slides the scene's cube, or a ball, over the tiles, from places 13 mm apart, at several speeds.
Slide worst_slide(const std::string& solver, bool sphere)
{
  Slide worst;
  for (const double speed : {0.3, 1.0, 3.0, 7.0})
  {
    for (int place = 0; place < 5; ++place)
    {
      Scene scene = scenes::tiles();
      SceneBody& body = scene.bodies.back();
      body.position.x() += 0.4 + 0.013 * place;
      body.velocity.x() = speed;
      if (sphere)
      {
        body.shape = SphereShape{0.5};
      }
      GameWorld world(scene, solver_named(solver));
      while (world.time() < std::min(4.0, 7.5 / speed))
      {
        world.step();
        worst.upward = std::max(worst.upward, std::abs(world.bodies().back().motion.velocity.y()));
      }
      const double left = world.bodies().back().motion.velocity.x() / speed;
      worst.lost = std::max(worst.lost, std::abs(left - 1));
    }
  }
  return worst;
}

} // namespace

// [ghost_contact]
TEST_CASE("the side of a tile laid flush is a ghost, that of a step of 1 cm is not", "[case:S22]")
{
  CHECK(is_ghost(cube, tile(0), right, 0.01, 0.005));
  CHECK(is_ghost(cube, tile(0.004), right, 0.01, 0.005));
  CHECK_FALSE(is_ghost(cube, tile(0.01), right, 0.01, 0.005));
  // Overlapping along the normal as well: only what is thinner than half a millimetre.
  CHECK(is_ghost(cube, tile(0.0004), right, -1e-6, 0.005));
  CHECK_FALSE(is_ghost(cube, tile(0.0006), right, -1e-6, 0.005));
}

TEST_CASE(
    "a oriented box whose edge meets a face 2 mm beside the face's end is no ghost", "[case:S22]")
{
  // Along its own axis, 45° off the normal, it overlaps by next to nothing; along the face by much.
  const Obb<double> diamond{
      {0.5 + 2 * 0.5 * eighth + 0.001, 0.998, 0}, eighth_turn({0, 0, 1}), {0.5, 0.5, 0.5}};
  CHECK_FALSE(is_ghost(cube, diamond, right, 0.001, 0.005));
  CHECK_FALSE(is_ghost(diamond, cube, -right, 0.001, 0.005));
}

TEST_CASE("a box that lies on its edge, as high as a tile's top, is a ghost by the tile's axes")
{
  const Obb<double> rolled{{-0.01, eighth - 0.001, 0}, eighth_turn({1, 0, 0}), {0.5, 0.5, 0.5}};
  CHECK(is_ghost(rolled, tile(0), right, 0.02, 0.005));
  CHECK(is_ghost(tile(0), rolled, -right, 0.02, 0.005));
}

TEST_CASE("thin boxes that meet over their whole width are no ghosts", "[case:S22]")
{
  const Vector3<double> thin(0.5, 0.001, 0.5);
  const Obb<double> left{{0, 0, 0}, Matrix3<double>::Identity(), thin};
  CHECK_FALSE(is_ghost(left, {{1.01, 0, 0}, left.axes, thin}, right, 0.01, 0.005));
  CHECK(is_ghost(left, {{1.01, 0.0015, 0}, left.axes, thin}, right, 0.01, 0.005));
}

TEST_CASE("a ball near an edge is a ghost until it touches; above a face it is none", "[case:S22]")
{
  const Sphere<double> sphere{{0, 1.5, 0}, 0.5};
  CHECK_FALSE(is_ghost(sphere, cube, {0, -1, 0}, 0.01, 0.005));
  CHECK(is_ghost(sphere, cube, Vector3<double>(0.6, -0.8, 0), 0.01, 0.005));
  CHECK_FALSE(is_ghost(sphere, cube, Vector3<double>(0.6, -0.8, 0), 0, 0.005));
}

TEST_CASE(
    "a cube slides over flush tiles and a ball rolls, wherever a step ends", "[case:S22][long]")
{
  for (const char* const solver : {"direct", "sequential_impulses", "position_based", "soft_steps"})
  {
    CAPTURE(solver);
    const Slide of_cube = worst_slide(solver, false);
    CHECK(of_cube.lost <= 0.01);
    CHECK(of_cube.upward <= 0.001);
    const Slide of_ball = worst_slide(solver, true);
    CHECK(of_ball.lost <= 0.01);
    CHECK(of_ball.upward <= 0.001);
  }
}
// [ghost_contact]

TEST_CASE("a cube stays on a ledge of 2 mm that holds its edge", "[case:S22]")
{
  // Two cubes carry a beam by its ends; at one of them 2 mm are all it lies on.
  Scene scene = scenes::standing();
  scene.bodies.push_back(box_body("left", {0.5, 0.5, 0.5}, {-1.498, 0.5, 0}, 0));
  scene.bodies.push_back(box_body("right", {0.5, 0.5, 0.5}, {1, 0.5, 0}, 0));
  scene.bodies.push_back(box_body("beam", {1, 0.1, 0.5}, {0, 1.1, 0}));
  GameWorld world(scene, solver_named("direct"));
  for (int i = 0; i < 300; ++i)
  {
    world.step();
  }
  CHECK((world.bodies().back().motion.center - scene.bodies.back().position).norm() < 1e-5);
}
