/// \file
/// What holds for the named scenes: bodies touch or are apart, by closed forms.

#include "04_obb_manifolds/box_box/box_box.hpp"
#include "05_resolution/impulse/body.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include "tests/catch.hpp"

#include <set>

using namespace cookbook;

namespace
{

/// Places here are sums of fewer than 20 products of numbers of size 10, each rounded.
constexpr double rounding = 1e-13;

const BoxShape* box_of(const SceneBody& body)
{
  return std::get_if<BoxShape>(&body.shape);
}

Obb<double> obb_of(const SceneBody& body)
{
  return {body.position, body.orientation.toRotationMatrix(), box_of(body)->half_extents};
}

/// The height [m] of a box's lowest corner above the plane y = 0.
double lowest(const SceneBody& body)
{
  const Obb<double> box = obb_of(body);
  return box.center.y() - (box.axes * box.half_extents.asDiagonal()).row(1).cwiseAbs().sum();
}

/// The deepest overlap [m] of any two boxes, of which one can move; −1 where none touch.
double deepest(const Scene& scene)
{
  double depth = -1;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const SceneBody& a = scene.bodies[i];
      const SceneBody& b = scene.bodies[j];
      if (box_of(a) && box_of(b) && a.mass + b.mass > 0)
      {
        const auto manifold = box_box(obb_of(a), obb_of(b));
        depth = std::max(depth, manifold ? manifold->depth : -1);
      }
    }
  }
  return depth;
}

bool is_fair(const SceneBody& body)
{
  const bool fixed = body.mass == 0;
  const bool still = body.velocity.isZero(0) && body.angular_velocity.isZero(0);
  return std::abs(body.orientation.norm() - 1) < 1e-15 && body.mass >= 0 && (still || !fixed) &&
         (fixed || !std::holds_alternative<PlaneShape>(body.shape)) && body.friction >= 0 &&
         body.restitution >= 0 && body.restitution <= 1;
}

/// Whether a name is no scene's, and the answer contains a text.
bool says(const std::string& name, const std::string& text)
{
  try
  {
    named_scene(name);
  }
  catch (const std::invalid_argument& error)
  {
    return std::string(error.what()).find(text) != std::string::npos;
  }
  return false;
}

} // namespace

TEST_CASE("every named scene has bodies with names of their own, fair at the start", "[scenes]")
{
  for (const std::string& name : scene_names())
  {
    const Scene scene = named_scene(name);
    INFO(name);
    CHECK(scene.name == name);
    CHECK((scene.step > 0 && scene.duration > scene.step));
    std::set<std::string> names;
    for (const SceneBody& body : scene.bodies)
    {
      CHECK(names.insert(body.name).second);
      CHECK(is_fair(body));
    }
    CHECK(std::any_of(
        scene.bodies.begin(), scene.bodies.end(),
        [](const SceneBody& body) { return body.mass > 0; }));
  }
}

TEST_CASE("no two boxes of a scene overlap at the start, but those of overlap do", "[scenes]")
{
  for (const std::string& name : scene_names())
  {
    INFO(name);
    const double depth = deepest(named_scene(name));
    CHECK((name == "overlap" ? depth == Catch::Approx(0.25) : depth < rounding));
  }
}

TEST_CASE("a tower's cubes touch exactly, straight, shifted by 3 cm and turned", "[scenes]")
{
  for (const char* const name : {"tower_20", "tower_shifted_20", "tower_turned_20"})
  {
    const Scene scene = named_scene(name);
    INFO(name);
    REQUIRE(scene.bodies.size() == 21);
    for (std::size_t i = 1; i < scene.bodies.size(); ++i)
    {
      CHECK(scene.bodies[i].position.y() == static_cast<double>(i) - 0.5);
      CHECK(std::abs(scene.bodies[i].position.x()) == (std::string(name) == "tower_20" ? 0 : 0.03));
    }
    CHECK(deepest(scene) == Catch::Approx(0).margin(rounding));
  }
  const std::vector<SceneBody> turned = named_scene("tower_turned").bodies;
  const double angle = turned[3].orientation.angularDistance(turned[1].orientation);
  CHECK(angle == Catch::Approx(2 * std::atan(5.0 / 12)));
}

TEST_CASE("a pyramid of ten rows has 55 cubes, and a heavy one on a light one two", "[scenes]")
{
  CHECK(named_scene("pyramid").bodies.size() == 56);
  CHECK(named_scene("pyramid").bodies.back().position.isApprox(Vector3<double>(0, 9.5, 0)));
  CHECK(named_scene("pyramid_heavy_top_300").bodies.back().mass == 300);
  CHECK(named_scene("heavy_on_light").bodies[2].mass == 100);
  CHECK(named_scene("heavy_on_light_10000").bodies[2].mass == 10000);
}

TEST_CASE("cards of a house stand on an edge and lean together, two levels of seven", "[scenes]")
{
  const Scene scene = named_scene("card_house");
  REQUIRE(scene.bodies.size() == 8);
  CHECK(scene.bodies[5].name == "level_1_2_flat");
  for (std::size_t foot = 1; foot <= 4; ++foot)
  {
    CHECK(lowest(scene.bodies[foot]) == Catch::Approx(0).margin(rounding));
  }
  CHECK(lowest(scene.bodies[5]) == Catch::Approx(2 * scene.bodies[1].position.y()));
  CHECK(lowest(scene.bodies[6]) == Catch::Approx(lowest(scene.bodies[5]) + 0.02));
}

TEST_CASE("the block on a slope of 30 degrees stands on it and is turned with it", "[scenes]")
{
  const Scene scene = named_scene("incline");
  const auto& slope = std::get<PlaneShape>(scene.bodies[0].shape);
  const double thirty = std::atan(1.0) * 2 / 3;
  CHECK(slope.normal.isApprox(Vector3<double>(std::sin(thirty), std::cos(thirty), 0), 1e-15));
  const Vector3<double> up = scene.bodies[1].orientation * Vector3<double>(0, 1, 0);
  CHECK(up.isApprox(slope.normal, 1e-15));
  CHECK(slope.normal.dot(scene.bodies[1].position) == Catch::Approx(0.5));
}

TEST_CASE("the top's moments are 1, 2 and 2.6 kg m², and it turns about the middle one", "[scenes]")
{
  const SceneBody top = named_scene("spinning_top").bodies[0];
  CHECK(solid_box(top.mass, box_of(top)->half_extents)
            .moments.isApprox(Vector3<double>(1, 2, 2.6), 1e-15));
  CHECK(top.angular_velocity == Vector3<double>(0.01, 10, 0.01));
}

TEST_CASE(
    "from 70 m/s a frame carries the ball over the wall, and the other one misses by 3 cm",
    "[scenes]")
{
  for (const char* const name : {"thin_wall_100", "thin_wall_1000"})
  {
    const Scene scene = named_scene(name);
    const double stride = scene.bodies[1].velocity.x() * scene.step;
    double x = scene.bodies[1].position.x();
    while (x < -0.06)
    {
      x += stride;
    }
    CHECK(x > 0.06);
    CHECK(scene.bodies[2].position.y() - 0.05 - 1 == Catch::Approx(0.03));
  }
}

TEST_CASE("the first domino turns about its lower edge, which stays where it is", "[scenes]")
{
  const SceneBody first = named_scene("domino").bodies[1];
  const Vector3<double> edge(0.05, -0.5, 0);
  const Vector3<double> speed = first.velocity + first.angular_velocity.cross(edge);
  CHECK(speed.isZero(1e-15));
}

TEST_CASE("piles have as many boxes as asked for, and none touches another", "[scenes]")
{
  CHECK(deepest(named_scene("pile_100")) == -1);
  CHECK(named_scene("pile_2000").bodies.size() == 2001);
  for (const SceneBody& body : named_scene("pile_100").bodies)
  {
    CHECK((body.mass == 0 || lowest(body) > 0));
  }
}

TEST_CASE("a scene that there is not is answered with one that there is", "[scenes]")
{
  CHECK(says("piramid", "did you mean pyramid?"));
  CHECK(says("zebra", "\ntower_10: cubes one on top of the other\n"));
  CHECK(says("tower_0", "the number of scene tower must be 1 to 1000, got 0"));
  CHECK(says("tower_99999999999999999999", "must be 1 to 1000"));
  CHECK(says("bounce_3", "there is no scene \"bounce_3\""));
  CHECK(says("", "there is no scene \"\""));
}

TEST_CASE("a misspelt word is told from a strange one", "[scenes]")
{
  CHECK(letters_apart("kitten", "sitting") == 3);
  CHECK(letters_apart("", "abc") == 3);
  CHECK(meant("half_extent", {"mass", "half_extents"}) == "; did you mean half_extents?");
  CHECK(meant("colour", {"mass", "half_extents"}).empty());
  CHECK(meant("x", {}).empty());
}
