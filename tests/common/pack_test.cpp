/// \file
/// \brief What holds for packs of every width, for lanes moved together, and for copies past the
/// cache.

#include "common/simd/compress.hpp"
#include "common/simd/row.hpp"
#include "common/simd/stream.hpp"

#include "tests/catch.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

using namespace cookbook;

// Packs of eight and sixteen floats are wider than this test's registers, and work all the same.
#define WIDTHS                                                                                     \
  (Pack<float, 1>), (Pack<float, 4>), (Pack<float, 8>), (Pack<float, 16>), (Pack<double, 1>),      \
      (Pack<double, 4>)

namespace
{

template <class Real, std::size_t Width>
constexpr std::size_t width_of(const Pack<Real, Width>*)
{
  return Width;
}

template <class P>
struct Lane
{
  using Real = std::remove_cvref_t<decltype(P()[0])>;
  static constexpr std::size_t width = width_of(static_cast<const P*>(nullptr));

  /// first, first + 1, first + 2 …
  static P counting_from(Real first)
  {
    std::array<Real, width> numbers;
    for (std::size_t i = 0; i < width; ++i)
    {
      numbers[i] = first + static_cast<Real>(i);
    }
    return load_pack<P>(numbers.data());
  }
};

} // namespace

TEMPLATE_TEST_CASE("arithmetic on a pack is arithmetic on its numbers", "[pack]", WIDTHS)
{
  using Real = typename Lane<TestType>::Real;
  const TestType a = Lane<TestType>::counting_from(4); // 4, 5, 6 …
  const TestType b(Real(2));
  for (std::size_t i = 0; i < Lane<TestType>::width; ++i)
  {
    const Real number = static_cast<Real>(4 + i);
    CHECK((a + b)[i] == number + 2);
    CHECK((a - b)[i] == number - 2);
    CHECK((a * b)[i] == number + number);
    CHECK((a / b)[i] == number / 2);
    CHECK((-a)[i] == -number);
    CHECK(sqrt(a * a)[i] == number);
  }
}

TEMPLATE_TEST_CASE("select takes what the mask says, lane by lane", "[pack]", WIDTHS)
{
  using Real = typename Lane<TestType>::Real;
  const TestType a = Lane<TestType>::counting_from(0);
  const TestType capped = select(a < TestType(Real(3)), a, TestType(Real(3)));
  for (std::size_t i = 0; i < Lane<TestType>::width; ++i)
  {
    CHECK(capped[i] == (i < 3 ? static_cast<Real>(i) : Real(3)));
  }
}

TEMPLATE_TEST_CASE("max and min of 0, 1, 2 … and 3 choose in every lane", "[pack]", WIDTHS)
{
  using Real = typename Lane<TestType>::Real;
  const TestType a = Lane<TestType>::counting_from(0);
  const TestType three(Real(3));
  for (std::size_t i = 0; i < Lane<TestType>::width; ++i)
  {
    const Real larger = i < 3 ? Real(3) : static_cast<Real>(i);
    const Real smaller = i < 3 ? static_cast<Real>(i) : Real(3);
    CHECK(max(a, three)[i] == larger);
    CHECK(max(three, a)[i] == larger);
    CHECK(min(a, three)[i] == smaller);
    CHECK(min(three, a)[i] == smaller);
  }
}

TEMPLATE_TEST_CASE("all holds only where every lane does", "[pack]", WIDTHS)
{
  using Real = typename Lane<TestType>::Real;
  const std::size_t count = Lane<TestType>::width;
  const TestType a = Lane<TestType>::counting_from(0);
  CHECK(all(a >= TestType(Real(0))));
  CHECK(all(a <= TestType(static_cast<Real>(count - 1))));
  CHECK_FALSE(all(a < TestType(static_cast<Real>(count - 1))));
  CHECK_FALSE(all(a > TestType(Real(0))));
  CHECK_FALSE(all((a >= TestType(Real(0))) & (a > TestType(Real(0)))));
}

TEMPLATE_TEST_CASE("a NaN compares false in its lane", "[pack]", WIDTHS)
{
  using Real = typename Lane<TestType>::Real;
  const TestType unknown(std::numeric_limits<Real>::quiet_NaN());
  CHECK_FALSE(all(unknown <= unknown));
  CHECK_FALSE(all(unknown >= TestType(Real(0))));
}

TEMPLATE_TEST_CASE("a pack is read and written at any address", "[pack]", WIDTHS)
{
  using Real = typename Lane<TestType>::Real;
  std::array<Real, 40> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = static_cast<Real>(i);
  }
  for (std::size_t from = 0; from < 5; ++from)
  {
    std::array<Real, 40> written{};
    store_pack(load_pack<TestType>(&numbers[from]), &written[from + 1]);
    CHECK(written[from] == 0);
    CHECK(written[from + 1] == numbers[from]);
    CHECK(
        written[from + Lane<TestType>::width] ==
        static_cast<Real>(from + Lane<TestType>::width - 1));
    CHECK(written[from + 1 + Lane<TestType>::width] == 0);
  }
}

TEST_CASE("the same number in every lane keeps the sign of zero", "[pack]")
{
  const Pack<float, 4> zero(-0.0f);
  CHECK(std::signbit(zero[3]));
}

TEST_CASE("vectors of packs have four dot products at once: (1, 2, 3)·(k, 0, 1) = k + 3", "[pack]")
{
  using P = Pack<float, 4>;
  const Vector3<P> a(P(1.0f), P(2.0f), P(3.0f));
  const Vector3<P> b(Lane<P>::counting_from(0), P(0.0f), P(1.0f));
  const P dot = a.dot(b);
  for (std::size_t k = 0; k < 4; ++k)
  {
    CHECK(dot[k] == static_cast<float>(k) + 3);
  }
}

TEMPLATE_TEST_CASE("a mask has a bit for each lane, the first lowest", "[pack]", WIDTHS)
{
  using Real = typename Lane<TestType>::Real;
  constexpr std::size_t count = Lane<TestType>::width;
  const TestType counted = Lane<TestType>::counting_from(0);
  for (std::size_t limit = 0; limit <= count; ++limit)
  {
    CAPTURE(limit);
    CHECK(bits_of(counted < TestType(static_cast<Real>(limit))) == (1u << limit) - 1);
  }
}

TEMPLATE_TEST_CASE("a sign is copied, that of zero too", "[pack]", WIDTHS)
{
  using Real = typename Lane<TestType>::Real;
  const TestType numbers = Lane<TestType>::counting_from(-2);
  for (const Real sign : {Real(3), Real(-3), Real(0), Real(-0.0)})
  {
    const TestType copied = copysign(numbers, TestType(sign)), absolute = abs(numbers);
    for (std::size_t i = 0; i < Lane<TestType>::width; ++i)
    {
      CHECK(copied[i] == std::copysign(numbers[i], sign));
      CHECK(std::signbit(copied[i]) == std::signbit(sign));
      CHECK(absolute[i] == std::abs(numbers[i]));
      CHECK_FALSE(std::signbit(absolute[i]));
    }
  }
}

TEST_CASE("a square of packs is mirrored", "[pack]")
{
  using P = Pack<float, 4>;
  P rows[4];
  for (int i = 0; i < 4; ++i)
  {
    rows[i] = Lane<P>::counting_from(static_cast<float>(10 * i));
  }
  transpose_fours(rows[0], rows[1], rows[2], rows[3]);
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      CHECK(rows[i][j] == static_cast<float>(10 * j + i));
    }
  }
}

TEST_CASE("lanes that are set come first, in their order", "[pack]")
{
  Lanes lanes;
  for (std::size_t i = 0; i < width; ++i)
  {
    lanes.lanes[i] = static_cast<float>(10 + i);
  }
  for (std::uint32_t bits = 0; bits < 1u << width; ++bits)
  {
    const Lanes moved = Compress(bits)(lanes);
    std::size_t place = 0;
    for (std::size_t i = 0; i < width; ++i)
    {
      if ((bits >> i & 1) != 0)
      {
        CHECK(moved[place++] == lanes[i]);
      }
    }
  }
}

TEST_CASE("0 to 70 bytes from anywhere to anywhere arrive, and nothing beside them", "[pack]")
{
  std::array<unsigned char, 96> from;
  std::iota(from.begin(), from.end(), static_cast<unsigned char>(1));
  for (std::size_t count = 0; count <= 70; ++count)
  {
    for (std::size_t offset = 1; offset <= 17; ++offset)
    {
      alignas(16) std::array<unsigned char, 96> to{};
      stream(from.data() + 3, to.data() + offset, count);
      end_of_stream();
      bool right = true;
      for (std::size_t i = 0; i < to.size(); ++i)
      {
        const bool inside = i >= offset && i < offset + count;
        right = right && to[i] == (inside ? from[3 + i - offset] : 0);
      }
      REQUIRE(right);
    }
  }
}
