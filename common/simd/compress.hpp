#pragma once

/// \file
/// \brief The lanes of a register that a mask has set, moved together.

#include "common/simd/lanes.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#if defined(__AVX2__) && !defined(COOKBOOK_PLAIN)
#include <immintrin.h>
#endif

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

#if defined(__AVX2__)
inline constexpr bool compresses_at_once = true; ///< whether Compress is one instruction
#else
inline constexpr bool compresses_at_once = false; ///< whether Compress is one instruction
#endif

/// Moves the lanes whose bits are set to the front, in their order; what follows them is not meant.
class Compress
{
public:
  /// Bit i stands for lane i.
#if defined(COOKBOOK_PLAIN) || !defined(__AVX2__)
  explicit Compress(std::uint32_t bits) : bits_(bits) {}

  Lanes operator()(const Lanes& lanes) const ///< the lanes moved
  {
    Lanes moved = lanes;
    for (std::size_t from = 0, to = 0; from < width; ++from)
    {
      if ((bits_ >> from & 1) != 0)
      {
        moved.lanes[to++] = lanes[from];
      }
    }
    return moved;
  }

private:
  std::uint32_t bits_;
#elif defined(__AVX512F__)
  explicit Compress(std::uint32_t bits) : bits_(static_cast<__mmask16>(bits)) {}

  Lanes operator()(const Lanes& lanes) const ///< the lanes moved
  {
    return Lanes::of(std::bit_cast<Lanes::Lanes>(
        _mm512_maskz_compress_ps(bits_, std::bit_cast<__m512>(lanes.lanes))));
  }

private:
  __mmask16 bits_;
#else
  explicit Compress(std::uint32_t bits) : order_(orders[bits]) {}

  Lanes operator()(const Lanes& lanes) const ///< the lanes moved
  {
    const __m128i bytes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(order_.data()));
    const __m256i order = _mm256_cvtepu8_epi32(bytes);
    return Lanes::of(std::bit_cast<Lanes::Lanes>(
        _mm256_permutevar8x32_ps(std::bit_cast<__m256>(lanes.lanes), order)));
  }

private:
  using Order = std::array<std::uint8_t, width>;

  /// For all bits: which lane comes first, second, …
  static constexpr std::array<Order, 1 << width> orders = []
  {
    std::array<Order, 1 << width> all{};
    for (std::size_t bits = 0; bits < all.size(); ++bits)
    {
      std::size_t count = 0;
      for (std::size_t i = 0; i < width; ++i)
      {
        if ((bits >> i & 1) != 0)
        {
          all[bits][count++] = static_cast<std::uint8_t>(i);
        }
      }
    }
    return all;
  }();

  const Order& order_;
#endif
};

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
