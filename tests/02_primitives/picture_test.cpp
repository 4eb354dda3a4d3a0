/// \file
/// What holds for a picture of boxes, spheres and capsules, their shadows and marks.

#include "02_primitives/casts/casts.hpp"
#include "02_primitives/picture/picture.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/random_numbers.hpp"

#include <limits>
#include <map>
#include <numbers>
#include <variant>
#include <vector>

using namespace cookbook;

namespace
{

using Body = std::variant<Obb<double>, Sphere<double>, Capsule<double>>;

/// A light in which all faces keep their colour.
const Light flat{{0, 1, 0}, 1, 0};

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Draws any body.
void draw(
    Picture& picture, const Camera<double>& camera, const Body& body, const Colour& colour,
    const Light& light = flat)
{
  if (const auto* box = std::get_if<Obb<double>>(&body))
  {
    draw_box(picture, camera, *box, colour, light);
  }
  else if (const auto* sphere = std::get_if<Sphere<double>>(&body))
  {
    draw_sphere(picture, camera, *sphere, Matrix3<double>::Identity(), colour, light);
  }
  else
  {
    draw_capsule(picture, camera, std::get<Capsule<double>>(body), colour, light);
  }
}

/// A turn whose matrix is made of fractions.
Matrix3<double> any_turn(Random& random)
{
  const int w = random.whole(1, 5), x = random.whole(-4, 4), y = random.whole(-4, 4);
  return rational_rotation<double>(w, x, y, random.whole(-4, 4));
}

/// A box, a sphere or a capsule in a room of 4 m.
Body any_body(Random& random)
{
  const Vector3<double> at = random.in_cube(2);
  const int kind = random.whole(0, 2);
  if (kind == 0)
  {
    const Matrix3<double> axes = any_turn(random);
    return Obb<double>{at, axes, random.in_box(0.1, 0.8)};
  }
  const double radius = random.between(0.1, 0.8);
  if (kind == 1)
  {
    return Sphere<double>{at, radius};
  }
  return Capsule<double>{{at, at + random.in_cube(1)}, radius / 2};
}

/// The colour of the body with this number; each has its own red.
Colour colour_of(std::size_t number)
{
  return {static_cast<std::uint8_t>(20 + 20 * number), 200, 100};
}

/// The number of the body that has a pixel's colour; −1 for the background.
int body_of(std::uint32_t pixel)
{
  const Colour c = to_colour(pixel);
  // Edges and second shades keep the ratio of red to green.
  return c.g == 0 ? -1 : (2 * c.r * 200 / c.g - 40 + 20) / 40;
}

/// The number of the body that a pixel's ray meets first, and where; −1 if it meets none.
std::pair<int, Vector3<double>> first_body(
    const Camera<double>& camera, const Vector2<double>& pixel, const std::vector<Body>& bodies)
{
  const Ray<double> ray = picking_ray(camera, pixel);
  std::pair<int, Vector3<double>> first{-1, {0, 0, 0}};
  double least = infinite;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    const auto hit = std::visit([&ray](const auto& shape) { return cast(ray, shape); }, bodies[i]);
    if (hit && hit->t < least)
    {
      least = hit->t;
      first = {static_cast<int>(i), hit->point};
    }
  }
  return first;
}

/// Whether the answer at some place within a 64th of a pixel is `wanted`.
template <class Answer>
bool is_close_by(const Vector2<double>& pixel, const Answer& answer, int wanted)
{
  for (int i = 0; i < 9; ++i)
  {
    if (answer(pixel + Vector2<double>(i % 3 - 1, i / 3 - 1) / 64) == wanted)
    {
      return true;
    }
  }
  return false;
}

/// The centre of a pixel.
Vector2<double> centre(const Picture& picture, std::size_t at)
{
  const auto width = static_cast<std::size_t>(picture.width);
  return {static_cast<double>(at % width) + 0.5, static_cast<double>(at / width) + 0.5};
}

Camera<double> any_camera(Random& random, int width, int height)
{
  const double yaw = random.between(-3, 3), pitch = random.between(-1.5, 1.5);
  return orbit_camera({{0, 0, 0}, random.between(5, 9), yaw, pitch, 0.9}, width, height);
}

std::vector<Body> any_scene(Random& random)
{
  std::vector<Body> bodies;
  for (int i = 0; i < 10; ++i)
  {
    bodies.push_back(any_body(random));
  }
  return bodies;
}

/// A camera at (0, 0, 5) with a right angle high; 400 by 400 pixels see 10 m at the origin.
Camera<double> straight_camera()
{
  return {
      look_at<double>({0, 0, 5}, {0, 0, 0}, {0, 1, 0}),
      perspective<double>(std::numbers::pi / 2, 1, 0.1, 100).value(),
      {400, 400}};
}

/// How many pixels are as deep as something that was drawn.
int drawn(const Picture& picture)
{
  return static_cast<int>(
      std::count_if(picture.depth.begin(), picture.depth.end(), [](float d) { return d < 1; }));
}

} // namespace

// [first_hit]
TEST_CASE(
    "each pixel shows the body that its ray meets first, or one met a 64th of a pixel beside",
    "[P24][P25][P26]")
{
  Random random(3);
  int differ = 0, wrong = 0, too_deep = 0, covered_pixels = 0;
  for (int scene = 0; scene < inputs(60, 6); ++scene)
  {
    const std::vector<Body> bodies = any_scene(random);
    const Camera<double> camera = any_camera(random, 80, 60);
    Picture picture = make_picture(80, 60);
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
      draw(picture, camera, bodies[i], colour_of(i));
    }
    const auto first = [&](const Vector2<double>& pixel)
    { return first_body(camera, pixel, bodies).first; };
    for (std::size_t at = 0; at < picture.pixels.size(); ++at)
    {
      const Vector2<double> pixel = centre(picture, at);
      const auto [body, point] = first_body(camera, pixel, bodies);
      const int seen = body_of(picture.pixels[at]);
      covered_pixels += seen >= 0 ? 1 : 0;
      differ += seen != body ? 1 : 0;
      wrong += seen != body && !is_close_by(pixel, first, seen) ? 1 : 0;
      const double depth = static_cast<double>(picture.depth[at]);
      too_deep += seen == body && body >= 0 &&
                          std::abs(to_pixel(camera, point).value().depth - depth) > 1e-6
                      ? 1
                      : 0;
    }
  }
  CHECK(covered_pixels > inputs(40'000, 2'000));
  CHECK(differ < covered_pixels / 500);
  CHECK(wrong == 0);
  CHECK(too_deep == 0);
}
// [first_hit]

// [any_order]
TEST_CASE("bodies drawn in the opposite order make the same picture", "[P25]")
{
  Random random(4);
  for (int scene = 0; scene < inputs(60, 3); ++scene)
  {
    const std::vector<Body> bodies = any_scene(random);
    const Camera<double> camera = any_camera(random, 80, 60);
    Picture one = make_picture(80, 60), other = one;
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
      const std::size_t last = bodies.size() - 1 - i;
      draw(one, camera, bodies[i], colour_of(i));
      draw(other, camera, bodies[last], colour_of(last));
    }
    CHECK(picture_hash(one) == picture_hash(other));
  }
}
// [any_order]

TEST_CASE("a face of 2 m at 5 m covers 80 by 80 pixels, a sphere its disc", "[P24][P26]")
{
  const Camera<double> camera = straight_camera();
  Picture face = make_picture(400, 400), ball = face;
  draw_box(face, camera, {{0, 0, -1}, Matrix3<double>::Identity(), {1, 1, 1}}, {200, 0, 0});
  CHECK(drawn(face) == 80 * 80);
  draw_sphere(ball, camera, {{0, 0, 0}, 1}, Matrix3<double>::Identity(), {200, 0, 0});
  // The cone that touches it has the slope r / sqrt(d² − r²), and 200 pixels are a slope of 1.
  const double disc = std::numbers::pi * 200 * 200 * 1 / (25 - 1);
  CHECK(std::abs(drawn(ball) - disc) < 20);
  // In the middle the sphere begins 4 m ahead, as a ray of the middle pixel finds.
  const std::size_t middle = row_start(ball, 200) + 200;
  const auto point =
      unproject<double>(camera, {centre(ball, middle), static_cast<double>(ball.depth[middle])});
  REQUIRE(point);
  CHECK((*point - Vector3<double>(0.01, -0.01, 1)).norm() < 1e-3);
}

// [shadow_rays]
TEST_CASE("the floor is dark where a ray towards the light meets a box, and nowhere else", "[P27]")
{
  Random random(5);
  const Obb<double> floor = floor_at(-1, 3);
  const Palette palette = light_palette();
  const Light light;
  int dark = 0, wrong = 0;
  for (int scene = 0; scene < inputs(40, 3); ++scene)
  {
    const double yaw = random.between(-3, 3);
    const Camera<double> camera = orbit_camera({{0, -1, 0}, 9, yaw, 0.7, 0.8}, 80, 60);
    Picture picture = make_picture(80, 60);
    draw_ground(picture, camera, floor, palette, 0);
    std::vector<Body> boxes;
    for (int i = 0; i < 4; ++i)
    {
      const Vector3<double> at = random.in_cube(2);
      const Matrix3<double> axes = any_turn(random);
      const Obb<double> box{at, axes, random.in_box(0.1, 0.8)}; // some reach below the floor
      draw_shadow(picture, camera, floor, box, palette.shadow, light);
      boxes.emplace_back(box);
    }
    const auto lit_at = [&](const Vector2<double>& pixel)
    {
      const auto [body, point] = first_body(camera, pixel, {floor});
      const bool top = body == 0 && std::abs(point.y() + 1) < 1e-9;
      const auto shaded = [&, at = point](const Body& box) {
        return cast(Ray<double>{at, light.towards}, std::get<Obb<double>>(box)).has_value();
      };
      return !top ? 2 : std::any_of(boxes.begin(), boxes.end(), shaded) ? 0 : 1;
    };
    const std::uint32_t shadow = to_pixel(mixed(palette.ground, palette.shadow, palette.shadow.a));
    for (std::size_t at = 0; at < picture.pixels.size(); ++at)
    {
      const std::uint32_t pixel = picture.pixels[at];
      const int seen = pixel == shadow ? 0 : pixel == to_pixel(palette.ground) ? 1 : 2;
      dark += seen == 0 ? 1 : 0;
      wrong += is_close_by(centre(picture, at), lit_at, seen) ? 0 : 1;
    }
  }
  CHECK(dark > inputs(6'000, 300));
  CHECK(wrong == 0);
}
// [shadow_rays]

// [P27]
TEST_CASE("seen from above, a cube of 1 m shades 1.05 m² beside it, a sphere 1.25 discs", "[P27]")
{
  // 100 pixels a metre, without perspective.
  const Camera<double> above{
      look_at<double>({0, 5, 0}, {0, 0, 0}, {0, 0, -1}),
      orthographic<double>(6, 6, 0.1, 10).value(),
      {600, 600}};
  const Obb<double> floor = floor_at(0, 3);
  const Colour black{0, 0, 0};
  const Light light; // falls by 0.8 while it moves by 0.48 to the right and 0.36 away
  const auto dark = [&](const auto& body)
  {
    Picture picture = make_picture(600, 600);
    draw_ground(picture, above, floor, light_palette(), 0);
    draw_shadow(picture, above, floor, body, black, light);
    return std::count(picture.pixels.begin(), picture.pixels.end(), to_pixel(black));
  };
  // A square that moves by (0.6, 0.45) covers 1 + 0.6 + 0.45.
  CHECK(
      std::abs(
          dark(Obb<double>{{0, 0.5, 0}, Matrix3<double>::Identity(), {0.5, 0.5, 0.5}}) - 20'500) <
      60);
  // A disc across the light, seen along y, is an ellipse of r by r / 0.8.
  const double ellipse = std::numbers::pi * 2'500 / 0.8;
  CHECK(
      std::abs(static_cast<double>(dark(Sphere<double>{{0, 0.5, 0}, 0.5})) - ellipse) <
      0.01 * ellipse);
  // A capsule along x adds a strip 1 m long; the light slants along it, and a little across.
  const double across = 1 / std::sqrt(1 - 0.48 * 0.48) / 0.8;
  const auto capsule =
      static_cast<double>(dark(Capsule<double>{{{-0.5, 0.5, 0}, {0.5, 0.5, 0}}, 0.5}));
  CHECK(std::abs(capsule - ellipse - 10'000 * (1 - 0.48 * 0.48) * across) < 0.01 * capsule);
}
// [P27]

TEST_CASE("shadows that lie on each other darken the floor once, the grid included", "[P27]")
{
  const Camera<double> camera = orbit_camera({{0, 0, 0}, 6, 0.4, 0.6, 0.8}, 120, 80);
  const Obb<double> floor = floor_at(0, 4),
                    box{{0, 0.5, 0}, Matrix3<double>::Identity(), {1, 0.5, 1}};
  const Palette palette = light_palette();
  Picture once = make_picture(120, 80);
  draw_ground(once, camera, floor, palette);
  const std::uint64_t without = picture_hash(once);
  draw_shadow(once, camera, floor, box, palette.shadow);
  Picture twice = once;
  draw_shadow(twice, camera, floor, box, palette.shadow);
  draw_shadow(twice, camera, floor, Sphere<double>{{0, 0.5, 0}, 0.4}, palette.shadow);
  CHECK(picture_hash(once) != without);
  CHECK(picture_hash(twice) == picture_hash(once));
}

TEST_CASE("a floor that reaches behind the camera covers all that is below the horizon", "[P24]")
{
  Picture picture = make_picture(400, 400);
  draw_ground(picture, straight_camera(), floor_at(-1, 60), light_palette(), 0);
  // Its edge is 65 m ahead and 1 m lower, 200 / 65 = 3.08 pixels below row 200.
  CHECK(drawn(picture) == 400 * (400 - 203));
  CHECK(picture.depth[row_start(picture, 202)] == 1);
  CHECK(picture.depth[row_start(picture, 203)] < 1);
}

// [hostile]
TEST_CASE(
    "what is behind the camera, without a size or not finite leaves the picture as it was", "[P24]")
{
  const Camera<double> camera = straight_camera();
  const Matrix3<double> upright = Matrix3<double>::Identity();
  Picture picture = make_picture(40, 40);
  clear(picture, light_palette());
  const std::uint64_t before = picture_hash(picture);
  const Colour red{200, 0, 0};
  const std::vector<Vector3<double>> nowhere{
      {0, 0, 8},        {0, 900, 0},          {1e300, 0, 0},
      {infinite, 0, 0}, {0, not_a_number, 0}, {0, 0, -1e300}};
  for (const Vector3<double>& at : nowhere)
  {
    draw_box(picture, camera, {at, upright, {1, 1, 1}}, red);
    draw_sphere(picture, camera, {at, 1}, upright, red);
    draw_capsule(picture, camera, {{at, at}, 1}, red);
    draw_triangle(picture, camera, {at, at, at}, red);
    draw_dot(picture, camera, at, red);
    draw_segment(picture, camera, {at, at}, red);
    draw_shadow(picture, camera, floor_at(-1, 2), Sphere<double>{at, 0.1}, red);
  }
  draw_box(picture, camera, {{0, 0, 4.95}, upright, {0.01, 0.01, 0.01}}, red); // nearer than 0.1 m
  draw_sphere(picture, camera, {{0, 0, 4.95}, 0.01}, upright, red);
  draw_box(picture, camera, {{0, 0, 0}, upright, {0, 0, 0}}, red);
  draw_box(picture, camera, {{0, 0, 0}, upright, {not_a_number, 1, 1}}, red);
  draw_sphere(picture, camera, {{0, 0, 0}, 0}, upright, red);
  draw_sphere(picture, camera, {{0, 0, 0}, -1}, upright, red);
  draw_sphere(picture, camera, {{0, 0, 0}, not_a_number}, upright, red);
  draw_ground(picture, camera, floor_at(9, 20), light_palette()); // from below
  CHECK(picture_hash(picture) == before);
}

TEST_CASE("around the camera, and in pictures of no size, everything can be drawn", "[P24]")
{
  const Camera<double> camera = straight_camera();
  const Matrix3<double> turned = rational_rotation<double>(3, 1, 2, 1);
  for (const int size : {-5, 0, 1, 2, 33})
  {
    Picture picture = make_picture(size, size / 2, 2);
    clear(picture, light_palette());
    draw_ground(picture, camera, floor_at(-1, 1e6), light_palette(), 1e-3);
    draw_box(picture, camera, {{0, 0, 5}, turned, {1, 2, 3}}, {200, 0, 0});
    draw_box(picture, camera, {{0, -1e6, 0}, turned, {1e6, 1e6, 1e6}}, {200, 0, 0});
    draw_sphere(picture, camera, {{0, 0, 5.5}, 1}, turned, {200, 0, 0});
    draw_arrow(picture, camera, {0, 0, 9}, {0, 0.1, -20}, {0, 0, 0}, 1e9);
    draw_segment(picture, camera, {{-1e9, 0, 4}, {1e9, 0, 4}}, {0, 0, 0}, 3, Cover::none);
    draw_dot(picture, camera, {0, 0, 0}, {0, 0, 0}, 1e9);
    CHECK(
        static_cast<int>(shown(picture).pixels.size()) ==
        std::max(size, 0) * std::max(size / 2, 0));
    CHECK(std::all_of(
        picture.depth.begin(), picture.depth.end(), [](float d) { return d >= -1.01F && d <= 1; }));
  }
}
// [hostile]

TEST_CASE(
    "a line 4 pixels wide covers 4 rows, over everything or hidden by what is nearer", "[P24]")
{
  const Camera<double> camera = straight_camera();
  const Segment<double> line{{-1, 0, 0}, {1, 0, 0}}; // 80 pixels long, at row 200
  Picture picture = make_picture(400, 400);
  draw_segment(picture, camera, line, {9, 9, 9}, 4);
  CHECK(drawn(picture) == 80 * 4);
  draw_box(
      picture, camera, {{0, 0, 1}, Matrix3<double>::Identity(), {3, 3, 0.5}}, {200, 0, 0}, flat);
  const std::uint64_t hidden = picture_hash(picture);
  draw_segment(picture, camera, line, {9, 9, 9}, 4);
  CHECK(picture_hash(picture) == hidden);
  draw_segment(picture, camera, line, {9, 9, 9}, 4, Cover::none);
  CHECK(std::count(picture.pixels.begin(), picture.pixels.end(), to_pixel({9, 9, 9})) == 80 * 4);
}

TEST_CASE("an orbit's target is in the middle; a point is dragged to where the pointer is", "[P18]")
{
  Orbit orbit{{1, 2, 3}, 5, 0, 0, 0.8};
  CHECK(
      (orbit_camera(orbit, 640, 400).pose.translation() - Vector3<double>(1, 2, 8)).norm() < 1e-12);
  turn(orbit, -150, 0); // a quarter turn to the left
  CHECK(
      (orbit_camera(orbit, 640, 400).pose.translation() - Vector3<double>(6, 2, 3)).norm() < 1e-12);
  turn(orbit, 40, 1e6);
  CHECK(orbit.pitch == 1.55);
  zoom(orbit, 1e-9);
  CHECK(orbit.distance == 0.01);
  orbit.distance = 5;
  const Camera<double> camera = orbit_camera(orbit, 640, 400);
  CHECK((to_pixel(camera, orbit.target)->pixel - Vector2<double>(320, 200)).norm() < 1e-9);
  const Vector3<double> grabbed(1.3, 2.2, 2.9);
  const Vector2<double> pixel = to_pixel(camera, grabbed)->pixel;
  CHECK((drag_point(camera, pixel, grabbed).value() - grabbed).norm() < 1e-12);
  const Vector2<double> other = pixel + Vector2<double>(50, -20);
  const Vector3<double> moved = drag_point(camera, other, grabbed).value();
  CHECK((to_pixel(camera, moved)->pixel - other).norm() < 1e-9);
  CHECK(std::abs(camera.pose.linear().col(2).dot(moved - grabbed)) < 1e-12);
  CHECK_FALSE(drag_point(camera, pixel, camera.pose * Vector3<double>(0, 0, 1)));
}

TEST_CASE("four drawn pixels become their mean, rounded; a PPM file has three bytes each", "[P24]")
{
  Picture picture = make_picture(1, 2, 2);
  CHECK(picture.pixels.size() == 8);
  picture.pixels = {to_pixel({0, 0, 100}), to_pixel({255, 0, 100}), to_pixel({255, 1, 100}),
                    to_pixel({0, 1, 102}), to_pixel({9, 9, 9}),     to_pixel({9, 9, 9}),
                    to_pixel({9, 9, 9}),   to_pixel({9, 9, 9})};
  const Picture small = shown(picture);
  // 510 / 4 = 127.5, 2 / 4 = 0.5 and 402 / 4 = 100.5
  CHECK(small.pixels == std::vector<std::uint32_t>{to_pixel({128, 1, 101}), to_pixel({9, 9, 9})});
  CHECK(to_ppm(picture) == "P6\n1 2\n255\n\x80\x01\x65\x09\x09\x09");
  const std::array<std::uint8_t, 4> bytes =
      std::bit_cast<std::array<std::uint8_t, 4>>(small.pixels[0]);
  CHECK(bytes == std::array<std::uint8_t, 4>{128, 1, 101, 255});
}
