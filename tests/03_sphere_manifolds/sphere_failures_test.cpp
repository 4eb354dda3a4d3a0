/// \file
/// The table of verdicts: in every case, which methods hold.

#include "03_sphere_manifolds/sphere_failures/trial/sphere_box_failures.hpp"
#include "03_sphere_manifolds/sphere_failures/trial/sphere_failures.hpp"
#include "03_sphere_manifolds/sphere_plane/sphere_plane.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

using namespace cookbook;

namespace
{

/// What is right of shapes whose distance is known exactly, by hand: the sum of radii less the
/// distance of the centres, or of a sphere's radius and its distance to the box's surface.
struct RightDepth
{
  std::string id;
  Rational depth;
};

/// Asserts the depths that the verdicts are passed by, and how far an answer may be from them.
template <class Cases>
void check_right_depths(const Cases& cases, const std::vector<RightDepth>& depths)
{
  REQUIRE(cases.size() == depths.size());
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    INFO(depths[i].id);
    CHECK(cases[i].id == depths[i].id);
    // The box of 100 m has numbers fifty times as large as the others.
    CHECK(cases[i].right.tolerance == (cases[i].id == "D5" ? 1e-5 : 1e-6));
    const Rational off = abs(Rational(cases[i].right.depth) - depths[i].depth);
    CHECK(off <= Rational(cases[i].right.tolerance) / 1000);
  }
}

} // namespace

// [sphere_verdicts]
TEST_CASE(
    "every method for two spheres fails or holds as the table says",
    "[case:C1][case:C2][case:C3][case:C4][case:C6][case:C7][case:C8][case:X01][case:X02]")
{
  check_verdicts(
      sphere_verdicts(), sphere_method_names(),
      {{"C1",
        {"plain_sphere_sphere, float", "relative, float", "sphere_pairs", "sphere_sphere, double"}},
       {"X01",
        {"plain_sphere_sphere, float", "relative, float", "sphere_pairs", "sphere_sphere, double"}},
       {"C2",
        {"plain_sphere_sphere, float", "relative, float", "reciprocal, 2 steps", "sphere_pairs",
         "sphere_sphere, double"}},
       {"C3",
        {"plain_sphere_sphere, float", "relative, float", "reciprocal, 2 steps", "sphere_pairs",
         "sphere_sphere, double"}},
       {"X02",
        {"plain_sphere_sphere, float", "relative, float", "reciprocal, 2 steps", "sphere_pairs",
         "sphere_sphere, double"}},
       {"C4", {"relative, float", "reciprocal, 2 steps", "sphere_pairs", "sphere_sphere, double"}},
       {"C6", {"sphere_sphere, double"}},
       {"C7", {"relative, float", "sphere_sphere, double"}},
       {"C8",
        {"plain_sphere_sphere, float", "relative, float", "sphere_pairs",
         "sphere_sphere, double"}}});
}
// [sphere_verdicts]

// [box_verdicts]
TEST_CASE(
    "every method for a sphere and a box fails or holds as the table says",
    "[case:D1][case:D2][case:D3][case:D4][case:D5][case:D8][case:D9]"
    "[case:X05][case:X06][case:X07][case:X28]")
{
  check_verdicts(
      box_verdicts(), box_method_names(),
      {{"D1", {"plain_sphere_box", "sphere_box"}},
       {"X05", {"plain_sphere_box", "sphere_box"}},
       {"D2", {"plain_sphere_box", "sphere_box"}},
       {"X07", {"plain_sphere_box", "sphere_box"}},
       {"D3", {"as published", "outside formula only", "plain_sphere_box", "sphere_box"}},
       {"X06", {"outside formula only", "plain_sphere_box", "sphere_box"}},
       {"D4", {"as published", "plain_sphere_box", "sphere_box"}},
       {"oriented box, centre on its face but for rounding", {"sphere_box"}},
       {"D5", {"plain_sphere_box", "sphere_box"}},
       {"D9", {"plain_sphere_box", "sphere_box"}},
       {"D8", {"as published", "outside formula only", "plain_sphere_box", "sphere_box"}},
       {"X28", {"as published", "outside formula only", "plain_sphere_box", "sphere_box"}}});
}
// [box_verdicts]

TEST_CASE("the depths in the tables are those of fractions, within 1e-6 m", "[verdict]")
{
  const auto thousandths = [](int count) { return Rational(count, 1000); };
  check_right_depths(
      sphere_cases(), {{"C1", thousandths(100)},
                       {"X01", thousandths(400)},
                       {"C2", thousandths(300)},
                       {"C3", 2},
                       {"X02", 4},
                       {"C4", 2},
                       {"C6", Rational(-1, 100'000)},
                       {"C7", thousandths(1)},
                       {"C8", 0}});
  check_right_depths(
      box_cases(), {{"D1", thousandths(100 + 50)},
                    {"X05", thousandths(100 + 250)},
                    {"D2", thousandths(100 + 500)},
                    {"X07", thousandths(100 + 1000)},
                    {"D3", thousandths(100 - 1)},
                    {"X06", Rational(998, 10'000)},
                    {"D4", 1},
                    {"", thousandths(500)},
                    {"D5", 1},
                    {"D9", thousandths(5 + 10)},
                    {"D8", thousandths(500 - 4000)},
                    {"X28", thousandths(500 - 4000)}});
}

TEST_CASE("a table has a column of right values where a row has one", "[verdict]")
{
  const VerdictRow row{"C1", "what", {{true, "holds"}}, "0.1"};
  CHECK(verdict_table("", {"m"}, {row}).find("<td>0.1</td>") != std::string::npos);
  CHECK(verdict_table("", {"m"}, {{"C1", "what", {{true, "holds"}}}}).find("right") > 1000);
}

TEST_CASE("a verdict says what is wrong: contact, depth, normal, number", "[verdict]")
{
  const Right right{0.5, {1, 0, 0}, 1e-6};
  const Right apart{-0.5, {1, 0, 0}, 1e-6};
  const auto what = [](const std::optional<Found>& answer, const Right& truth)
  { return verdict_of(answer, truth).what; };
  CHECK(verdict_of(Found{{1, 0, 0}, 0.5}, right).holds);
  CHECK(verdict_of(std::nullopt, apart).holds);
  CHECK(what(Found{{2, 0, 0}, 0.5}, right) == "normal not of length 1");
  CHECK(what(std::nullopt, right) == "no contact");
  CHECK(what(Found{{1, 0, 0}, 0.25}, apart) == "contact, though apart");
  CHECK(what(Found{{1, 0, 0}, 0.25}, right) == "depth off by 0.25");
  CHECK(what(Found{{0, 1, 0}, 0.5}, right) == "normal 90° off");
  CHECK(what(Found{{-1, 0, 0}, 0.5}, right) == "normal 180° off");
  CHECK(what(Found{{NAN, 0, 0}, 0.5}, right) == "not a number");
  // The limit is the case's own tolerance, for depth, length and direction alike.
  CHECK(verdict_of(Found{{1, 0, 0}, 0.5 + 0.9e-6}, right).holds);
  CHECK(verdict_of(Found{{1, 0.9e-6, 0}, 0.5}, right).holds);
  CHECK_FALSE(verdict_of(Found{{1, 0, 0}, 0.5 - 1.1e-6}, right).holds);
  CHECK_FALSE(verdict_of(Found{{1, 1.1e-6, 0}, 0.5}, right).holds);
  CHECK_FALSE(verdict_of(Found{{1 + 1.1e-6, 0, 0}, 0.5}, right).holds);
}

// [published_half]
TEST_CASE(
    "where it happens to be right, the published depth is a half that is called a depth",
    "[case:X04]")
{
  // At a distance of exactly one, normalising too early changes nothing: only the half is left.
  const Sphere<float> a{{0, 0, 0}, 0.75f};
  const Sphere<float> b{{1, 0, 0}, 0.75f};
  const Manifold<float> published = sphere_sphere_as_published(a, b).value();
  const Manifold<float> ours = sphere_sphere(a, b).value();
  CHECK(ours.depth == 0.5f);
  CHECK(penetration_distance(ours) == 0.25f);
  CHECK(penetration_distance(published) == 0.25f); // the number the published code returns
}
// [published_half]

// [unsigned]
TEST_CASE("an unsigned distance to the ground makes a sunken ball shallower", "[case:C10]")
{
  const Sphere<double> sphere{{0, -0.3, 0}, 0.5};
  const Plane<double> ground{{0, 1, 0}, 0};
  const double unsigned_depth = sphere.radius - std::abs(signed_distance(ground, sphere.center));
  CHECK(unsigned_depth == Catch::Approx(0.2));
  CHECK(sphere_plane(sphere, ground)->depth == Catch::Approx(0.8));
}
// [unsigned]
