/// \file
/// What holds for relative velocity, approach, nature and the separating moves.

#include "03_sphere_manifolds/collision/collision.hpp"
#include "03_sphere_manifolds/manifold/translated.hpp"
#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"

#include "tests/catch.hpp"

#include <utility>

using namespace cookbook;

namespace
{

const Sphere<double> four_at_origin{{0, 0, 0}, 4};
const Sphere<double> five_seven_away{{2, 3, 6}, 5};
constexpr double rounding = 1e-15;

} // namespace

// [S6]
TEST_CASE(
    "1 kg and 3 kg that overlap by 2 part by 1.5 and 0.5, their centre of mass at rest", "[S6]")
{
  const Manifold<double> manifold = sphere_sphere(four_at_origin, five_seven_away).value();
  const SeparatingMoves<double> moves = separating_moves(manifold, 1.0, 1.0 / 3);
  const Vector3<double> normal = Vector3<double>(2, 3, 6) / 7;
  CHECK((moves.a + 1.5 * normal).norm() <= 2 * rounding);
  CHECK((moves.b - 0.5 * normal).norm() <= 2 * rounding);
  CHECK((1 * moves.a + 3 * moves.b).norm() <= 4 * rounding);
}

TEST_CASE("a body without inverse mass stands still, and two of them both do", "[S6]")
{
  const Manifold<double> manifold = sphere_sphere(four_at_origin, five_seven_away).value();
  CHECK(separating_moves(manifold, 0.0, 1.0).a.norm() == 0);
  CHECK(separating_moves(manifold, 0.0, 1.0).b.norm() == Catch::Approx(2).epsilon(rounding));
  CHECK(separating_moves(manifold, 0.0, 0.0).b.norm() == 0);
}
// [S6]

// [S11]
TEST_CASE("at (1,0,0) a body that turns by 2 rad/s about z moves by (0,2,0) there", "[S11]")
{
  const Motion<double> a{{0, 0, 0}, {1, 0, 0}, {0, 0, 2}};
  const Motion<double> b{{2, 0, 0}, {0, 0, 5}, {0, 0, 3}};
  const Vector3<double> point(1, 0, 0);
  CHECK(velocity_at(a, point) == Vector3<double>(1, 2, 0));
  CHECK(velocity_at(b, point) == Vector3<double>(0, -3, 5));
  CHECK(relative_velocity(a, b, point) == Vector3<double>(-1, -5, 5));
}
// [S11]

// [S11_more]
TEST_CASE(
    "along the normal, -0.2 m/s approaches, 0.05 rests and 0.2 separates, within 0.1", "[S11]")
{
  const Vector3<double> normal(0.6, 0.8, 0);
  const Vector3<double> sideways(-8, 6, 5); // crosses the normal
  CHECK(approach<double>(sideways - 0.2 * normal, normal, 0.1) == Approach::approaching);
  CHECK(approach<double>(sideways - 0.05 * normal, normal, 0.1) == Approach::resting);
  CHECK(approach<double>(sideways + 0.05 * normal, normal, 0.1) == Approach::resting);
  CHECK(approach<double>(sideways + 0.2 * normal, normal, 0.1) == Approach::separating);
}

TEST_CASE("a speed of exactly the resting speed rests, whichever way", "[S11]")
{
  const Vector3<double> normal(0, 1, 0);
  CHECK(approach<double>({3, -0.125, 0}, normal, 0.125) == Approach::resting);
  CHECK(approach<double>({3, 0.125, 0}, normal, 0.125) == Approach::resting);
}

TEST_CASE("no manifold is separated, touching collides, half a radius deep penetrates", "[S11]")
{
  const Sphere<double> sphere{{0, 0, 0}, 1};
  const auto nature_at = [&](double distance) {
    return nature(sphere_sphere(sphere, {{distance, 0, 0}, 1}), 0.125);
  };
  CHECK(nature_at(2.5) == Nature::separated);
  CHECK(nature_at(2) == Nature::colliding);
  CHECK(nature_at(1.875) == Nature::colliding); // no more than the tolerance
  CHECK(nature_at(1.5) == Nature::penetrating);
}
// [S11_more]

TEST_CASE("swapping a manifold turns its normal, moving it moves its points", "[S2]")
{
  const auto manifold = sphere_sphere(four_at_origin, five_seven_away);
  CHECK(swapped(manifold)->normal == -manifold->normal);
  CHECK_FALSE(swapped(std::optional<Manifold<double>>{}));
  const Vector3<double> offset(1, 2, 3);
  const Vector3<double> moved = translated(manifold, offset)->points[0].position;
  CHECK(moved == manifold->points[0].position + offset);
}

TEST_CASE("contact points are counted as they are added, and only those are copied", "[S2]")
{
  ContactPoints<double, 8> two;
  CHECK(two.empty());
  two.push_back({{1, 2, 3}, 4, 5});
  two.push_back({{6, 7, 8}, 9, 10});
  CHECK(two.size() == 2);
  CHECK_FALSE(two.empty());
  double depths = 0;
  for (const ContactPoint<double>& point : std::as_const(two))
  {
    depths = 100 * depths + point.depth;
  }
  CHECK(depths == 409); // first the 4, then the 9

  const ContactPoints<double, 8> one({{11, 12, 13}, 14, 15});
  CHECK_FALSE(one.empty());
  two = one;
  CHECK(two.size() == 1);
  CHECK(two[0].position == Vector3<double>(11, 12, 13));
  CHECK(two.begin()[1].depth == 9); // the room for others is left alone
}
