/// \file
/// The plain formulas on vectors: by hand, against those for any size, and where they fail.

#include "01_math/angles/angles.hpp"
#include "01_math/plain_vectors/plain_vectors.hpp"
#include "01_math/vectors/vectors.hpp"
#include "tests/catch.hpp"

#include <random>

using namespace cookbook;
using Catch::Approx;

namespace
{

using D = Vector3<double>;
using F = Vector3<float>;

/// Vectors of a room: components from a millimetre to a kilometre, of both signs.
struct Room
{
  std::mt19937 random{57};

  double fraction() { return static_cast<double>(random()) * 0x1p-32; }
  double component()
  {
    const double size = std::pow(10.0, 6 * fraction() - 3);
    return fraction() < 0.5 ? -size : size;
  }
  D vector() { return {component(), component(), component()}; }
};

bool is_close(const D& a, const D& b, double size)
{
  return (a - b).norm() <= 16 * std::numeric_limits<double>::epsilon() * size;
}

} // namespace

TEST_CASE(
    "(2,3,6) is 7 long; (1,2,3) on (2,1,2) is 10/9 of it; reflected it is the rest less that",
    "[M3][M4]")
{
  const D a(1, 2, 3), n(2, 1, 2);
  CHECK(plain::length<double>({2, 3, 6}) == 7);
  CHECK(is_close(plain::normalize<double>({2, 3, 6}), D(2, 3, 6) / 7, 1));
  CHECK(is_close(plain::project(a, n), D(20, 10, 20) / 9, 1));
  CHECK(is_close(plain::reject(a, n), D(-11, 8, 7) / 9, 1));
  CHECK(is_close(plain::reflect(a, n), D(-31, -2, -13) / 9, 1));
}

TEST_CASE("the angle of (1,0,0) and (1,1,0) is π/4, that of opposite vectors π", "[M5]")
{
  const double pi = std::acos(-1.0);
  CHECK(plain::angle<double>({1, 0, 0}, {1, 1, 0}) == Approx(pi / 4));
  CHECK(plain::angle<double>({1, 0, 0}, {-3, 0, 0}) == Approx(pi));
}

TEST_CASE(
    "the zero vector: direction +y, projection zero, reflection unchanged, angle 0", "[M3][M5]")
{
  const D zero(0, 0, 0), a(1, 2, 3);
  CHECK(plain::normalize(zero) == D(0, 1, 0));
  CHECK(plain::project(a, zero) == zero);
  CHECK(plain::reject(a, zero) == a);
  CHECK(plain::reflect(a, zero) == a);
  CHECK(plain::angle(a, zero) == 0);
}

// [interpolation]
TEST_CASE(
    "inverse lerp of 25 from 20 to 40 is 1/4, and lerp leads back; equal ends give 0", "[vectors]")
{
  CHECK(plain::inverse_lerp(20.0, 40.0, 25.0) == 0.25);
  CHECK(plain::lerp<double>({20, 0, 0}, {40, 8, 0}, 0.25) == D(25, 2, 0));
  CHECK(plain::inverse_lerp(3.0, 3.0, 5.0) == 0);
}

TEST_CASE("damping leaves 1/e of the way after 1/rate seconds, in one step or in 144", "[vectors]")
{
  const D start(1, 2, 3), target(5, -1, 0);
  const D right = target + (start - target) * std::exp(-1.0);
  D many = start;
  for (int step = 0; step < 144; ++step)
  {
    many = plain::damp<double>(many, target, 4, 0.25 / 144);
  }
  CHECK((plain::damp<double>(start, target, 4, 0.25) - right).norm() < 1e-14);
  CHECK((many - right).norm() < 1e-13);
  CHECK(plain::damp<double>(start, target, 0, 10) == start);
}
// [interpolation]

// [room_and_beyond]
TEST_CASE(
    "in a room the plain formulas and those for any size agree, for 20,000 pairs", "[M3][M4][M5]")
{
  Room room;
  int apart = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const D a = room.vector(), n = room.vector();
    const double size = a.norm(), t = room.fraction();
    const bool agree = is_close(plain::project(a, n), project(a, n), size) &&
                       is_close(plain::reject(a, n), reject(a, n), size) &&
                       is_close(plain::reflect(a, n), reflect(a, n), size) &&
                       is_close(plain::normalize(a), normalize(a).unit, 1) &&
                       is_close(plain::lerp(a, n, t), lerp(a, n, t), size + n.norm()) &&
                       plain::length(a) == length(a) &&
                       std::abs(plain::angle(a, n) - angle(a, n)) < 1e-15;
    apart += agree ? 0 : 1;
  }
  CHECK(apart == 0);
}

TEST_CASE("beyond a room the plain formulas fail, and those for any size hold", "[M3][M4][M5]")
{
  const D a(1, 2, 3), n(2, 1, 2), huge = a * 1e200, tiny = n * 1e-200;
  CHECK(std::isinf(plain::length(huge)));
  CHECK(length(huge) == Approx(std::sqrt(14.0) * 1e200));
  CHECK(plain::normalize(tiny) == D(0, 1, 0));
  CHECK(is_close(normalize(tiny).unit, n / 3, 1));
  CHECK(plain::project(a, tiny) == D(0, 0, 0));
  CHECK(is_close(project(a, tiny), D(20, 10, 20) / 9, 1));
  CHECK(plain::reject(a, tiny) == a);
  CHECK(is_close(reject(a, tiny), D(-11, 8, 7) / 9, 1));
  CHECK(plain::reflect(a, tiny) == a);
  CHECK(is_close(reflect(a, tiny), D(-31, -2, -13) / 9, 1));

  const D p(1e8 + 1, 1e8, 0), q(1e8, 1e8 - 1, 0); // p × q = (0, 0, -1)
  CHECK(plain::angle(p, q) == 0);
  CHECK(angle(p, q) == Approx(0.5e-16).epsilon(1e-7));

  const F distant(1e8f, 0, 0), x(1, 0, 0);
  CHECK(plain::lerp<float>(distant, x, 1) == F(0, 0, 0));
  CHECK(lerp<float>(distant, x, 1) == x);
}
// [room_and_beyond]
