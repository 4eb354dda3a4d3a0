/// \file
/// What holds for a triangle in a picture, as the formulas stand, and the case that they fail.

#include "02_primitives/picture/raster.hpp"
#include "02_primitives/plain_picture/plain_picture.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/random_numbers.hpp"

#include <vector>

using namespace cookbook;

namespace
{

constexpr Colour white{255, 255, 255};

/// How many pixels are not black.
int painted(const Picture& picture)
{
  int count = 0;
  for (const std::uint32_t pixel : picture.pixels)
  {
    count += pixel != to_pixel({0, 0, 0}) ? 1 : 0;
  }
  return count;
}

/// The corners in the order in which they turn clockwise as seen.
ScreenPolygon polygon_of(const std::vector<Vector3<double>>& corners)
{
  const bool clockwise =
      edge_function<double>(corners[0].head<2>(), corners[1].head<2>(), corners[2].head<2>()) > 0;
  ScreenPolygon polygon;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    polygon.add(corners[clockwise ? i : corners.size() - 1 - i]);
  }
  return polygon;
}

/// A triangle whose corners are multiples of `step` pixels, in and around 32 by 24 pixels.
std::vector<Vector3<double>> random_triangle(Random& random, double step)
{
  std::vector<Vector3<double>> corners;
  const int steps = static_cast<int>(1 / step);
  for (int i = 0; i < 3; ++i)
  {
    const double x = random.whole(-8 * steps, 40 * steps) * step;
    const double y = random.whole(-8 * steps, 32 * steps) * step;
    corners.emplace_back(x, y, random.between(-1, 1));
  }
  return corners;
}

} // namespace

// [P24]
TEST_CASE("a right triangle with legs of 4 and 3 pixels covers rows of 3, 2 and 1 pixels", "[P24]")
{
  Picture picture = make_picture(8, 5);
  fill_triangle(picture, {1, 1, 0}, {5, 1, 0}, {1, 4, 0}, white);
  // Its slope passes x = 5 - 4/3 (y - 1): 4.33, 3 and 1.67 at the middles of the rows.
  const std::vector<int> right_ends{0, 4, 3, 2, 0};
  for (int y = 0; y < 5; ++y)
  {
    for (int x = 0; x < 8; ++x)
    {
      const bool inside = x >= 1 && x < right_ends[static_cast<std::size_t>(y)];
      const std::size_t i = row_start(picture, y) + static_cast<std::size_t>(x);
      CHECK((picture.pixels[i] == to_pixel(white)) == inside);
    }
  }
  CHECK(edge_function<double>({1, 1}, {5, 1}, {1, 4}) == 12); // twice the area
}
// [P24]

// [P25]
TEST_CASE("depth 0 at the left corners and 1 at the right one grows by 1/8 a pixel", "[P25]")
{
  Picture picture = make_picture(10, 9);
  fill_triangle(picture, {1, 0.5, 0}, {9, 4.5, 1}, {1, 8.5, 0}, white);
  for (int x = 1; x < 9; ++x)
  {
    const float depth = picture.depth[row_start(picture, 4) + static_cast<std::size_t>(x)];
    CHECK(static_cast<double>(depth) == (x - 0.5) / 8);
  }
}

TEST_CASE("of two triangles that cross, each pixel shows the nearer one, in any order", "[P25]")
{
  const Colour blue{0, 0, 255}, red{255, 0, 0};
  Picture one = make_picture(40, 12), other = one;
  const Vector3<double> a(2, 1, 0), b(38, 6, 1), c(2, 11, 0), d(38, 1, 0), e(38, 11, 0), f(2, 6, 1);
  fill_triangle(one, a, b, c, blue);
  fill_triangle(one, d, e, f, red);
  fill_triangle(other, d, e, f, red);
  fill_triangle(other, a, b, c, blue);
  CHECK(one.pixels == other.pixels);
  // Depths are equal in the middle, at x = 20.
  CHECK(one.pixels[row_start(one, 6) + 19] == to_pixel(blue));
  CHECK(one.pixels[row_start(one, 6) + 20] == to_pixel(red));
}
// [P25]

// [common_edge]
TEST_CASE(
    "of two triangles with a common edge both own the pixels on it; as polygons one does", "[P24]")
{
  // A square of 4 by 4 pixels, whose diagonal passes the centres of four pixels.
  const Vector3<double> a(0, 0, 0), b(4, 0, 0), c(4, 4, 0), d(0, 4, 0);
  Picture one = make_picture(4, 4), other = one;
  fill_triangle(one, a, b, c, white);
  fill_triangle(other, a, c, d, white);
  CHECK(painted(one) + painted(other) == 16 + 4); // wrong: translucent ones are mixed twice
  Picture first = make_picture(4, 4), second = first;
  fill_polygon(first, polygon_of({a, b, c}), {}, {white});
  fill_polygon(second, polygon_of({a, c, d}), {}, {white});
  CHECK(painted(first) + painted(second) == 16);
}
// [common_edge]

// [same_pixels]
TEST_CASE(
    "plain triangles and polygons cover the same pixels, except those whose centre is on an edge",
    "[P24][P25]")
{
  Random random(1);
  for (int i = 0; i < inputs(4'000, 200); ++i)
  {
    const std::vector<Vector3<double>> t = random_triangle(random, i % 2 == 0 ? 1.0 / 256 : 0.5);
    const Vector2<double> a = t[0].head<2>(), b = t[1].head<2>(), c = t[2].head<2>();
    Picture plain = make_picture(32, 24), fast = plain;
    fill_triangle(plain, t[0], t[1], t[2], white);
    const ScreenPolygon polygon = polygon_of(t);
    fill_polygon(fast, polygon, depth_plane(polygon), {white});
    int wrong = 0, too_deep = 0;
    for (std::size_t at = 0; at < plain.pixels.size(); ++at)
    {
      const Vector2<double> p(
          static_cast<double>(at % 32) + 0.5, static_cast<double>(at / 32) + 0.5);
      const bool on_edge =
          edge_function(a, b, p) == 0 || edge_function(b, c, p) == 0 || edge_function(c, a, p) == 0;
      const bool both = plain.pixels[at] == fast.pixels[at];
      wrong += both || (on_edge && plain.pixels[at] == to_pixel(white)) ? 0 : 1;
      too_deep += both && std::abs(plain.depth[at] - fast.depth[at]) > 1e-6F ? 1 : 0;
    }
    CHECK(wrong == 0);
    CHECK(too_deep == 0);
  }
}
// [same_pixels]

// [fan]
TEST_CASE("triangles around a corner cover each pixel of their polygon exactly once", "[P24]")
{
  Random random(2);
  for (int i = 0; i < inputs(2'000, 100); ++i)
  {
    // Corners on a lattice of half pixels, so that edges pass through centres all the time.
    const auto point = [&random](int x, int y) -> Vector3<double>
    {
      const double dx = random.whole(-8, 8) / 2.0, dy = random.whole(-8, 8) / 2.0;
      return {x + dx, y + dy, 0};
    };
    const Vector3<double> middle = point(16, 12);
    const std::vector<Vector3<double>> corners{
        point(1, 1), point(31, 1), point(31, 23), point(1, 23)};
    Picture whole = make_picture(32, 24);
    fill_polygon(whole, polygon_of(corners), {}, {white});
    int sum = 0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      Picture part = make_picture(32, 24);
      fill_polygon(part, polygon_of({middle, corners[k], corners[(k + 1) % 4]}), {}, {white});
      sum += painted(part);
      fill_polygon(whole, polygon_of({middle, corners[k], corners[(k + 1) % 4]}), {}, {white});
    }
    CHECK(sum == painted(whole)); // none twice, none beside the polygon, none missing
  }
}
// [fan]
