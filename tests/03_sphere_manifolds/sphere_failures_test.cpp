/// \file
/// The table of verdicts: in every case, who fails and who survives.

#include "03_sphere_manifolds/sphere_failures/trial/sphere_box_failures.hpp"
#include "03_sphere_manifolds/sphere_failures/trial/sphere_failures.hpp"
#include "03_sphere_manifolds/sphere_plane/sphere_plane.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

namespace
{

void expect(
    const std::string& id, const std::vector<std::string>& methods,
    const std::vector<Verdict>& verdicts, const std::vector<bool>& holds)
{
  REQUIRE(verdicts.size() == methods.size());
  REQUIRE(holds.size() == methods.size());
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    CAPTURE(id, methods[i], verdicts[i].what);
    CHECK(verdicts[i].holds == holds[i]);
  }
}

} // namespace

// [sphere_verdicts]
TEST_CASE(
    "every way to two spheres' manifold fails or survives as the table says",
    "[case:C1][case:C2][case:C3][case:C4][case:C6][case:C7][case:C8][case:X01][case:X02]")
{
  for (const SphereCase& one : sphere_cases())
  {
    const auto verdicts = verdicts_of(sphere_answers(one.a, one.b), one.right);
    expect(one.id, sphere_method_names(), verdicts, one.holds);
  }
}
// [sphere_verdicts]

// [box_verdicts]
TEST_CASE(
    "every way to a sphere and box's manifold fails or survives as the table says",
    "[case:D1][case:D2][case:D3][case:D4][case:D5][case:D8][case:D9]"
    "[case:X05][case:X06][case:X07][case:X28]")
{
  for (const SphereBoxCase& one : box_cases())
  {
    const auto verdicts = verdicts_of(box_answers(one.sphere, one.half), one.right);
    expect(one.id, box_method_names(), verdicts, one.holds);
  }
}
// [box_verdicts]

// [verdicts]
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
}
// [verdicts]

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
  const Sphere<double> ball{{0, -0.3, 0}, 0.5};
  const Plane<double> ground{{0, 1, 0}, 0};
  const double unsigned_depth = ball.radius - std::abs(signed_distance(ground, ball.center));
  CHECK(unsigned_depth == Catch::Approx(0.2));
  CHECK(sphere_plane(ball, ground)->depth == Catch::Approx(0.8));
}
// [unsigned]
