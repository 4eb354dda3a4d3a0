/// \file
/// \brief What holds for lanes moved together.

#include "common/simd/compress.hpp"

#include "tests/catch.hpp"

#include <cstddef>
#include <cstdint>

using namespace cookbook;

TEST_CASE("lanes that are set come first, in their order", "[compress]")
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
