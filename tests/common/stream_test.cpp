/// \file
/// \brief What holds for copies past the cache.

#include "common/simd/stream.hpp"

#include "tests/catch.hpp"

#include <array>
#include <numeric>

using namespace cookbook;

TEST_CASE("0 to 70 bytes from anywhere to anywhere arrive, and nothing beside them", "[stream]")
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
