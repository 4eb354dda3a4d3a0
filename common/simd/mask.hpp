#pragma once

/// \file
/// \brief Masks: what comparisons of several numbers at once give.

#include "common/simd/number.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(COOKBOOK_PLAIN)
#elif defined(__AVX512F__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h> // a tenth of the other, in every file
#endif

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// The bytes of the widest register that each processor has for which this is compiled.
#if defined(__AVX512F__)
inline constexpr std::size_t register_size = 64;
#elif defined(__AVX__)
inline constexpr std::size_t register_size = 32;
#else
inline constexpr std::size_t register_size = 16;
#endif

/// A bit for each lane of a mask, that of the first lane lowest: one instruction where there is
/// one.
template <class Mask>
std::uint32_t bits_of(const Mask& mask)
{
  constexpr std::size_t lane = sizeof(mask.lanes[0]), width = sizeof(mask.lanes) / lane;
  std::uint32_t bits = 0;
#if defined(__AVX512F__) && !defined(COOKBOOK_PLAIN)
  if constexpr (width == 16 && lane == 4)
  {
    return _mm512_cmplt_epi32_mask(std::bit_cast<__m512i>(mask.lanes), _mm512_setzero_si512());
  }
#endif
#if defined(__SSE2__) && !defined(COOKBOOK_PLAIN)
  if constexpr (sizeof(mask.lanes) >= sizeof(__m128))
  {
    for (std::size_t i = 0; i < width; i += sizeof(__m128) / lane)
    {
      __m128 part;
      std::memcpy(&part, reinterpret_cast<const char*>(&mask.lanes) + i * lane, sizeof part);
      const int set = lane == 4 ? _mm_movemask_ps(part) : _mm_movemask_pd(_mm_castps_pd(part));
      bits |= static_cast<std::uint32_t>(set) << i;
    }
    return bits;
  }
#endif
  for (std::size_t i = 0; i < width; ++i)
  {
    bits |= mask.lanes[i] != 0 ? 1u << i : 0u;
  }
  return bits;
}

/// Whether a mask is set in every lane.
template <class Mask>
bool all(const Mask& mask)
{
  constexpr std::size_t width = sizeof(mask.lanes) / sizeof(mask.lanes[0]);
  return bits_of(mask) == (1u << width) - 1;
}

/// Whether a mask is set in any lane.
template <class Mask>
bool any(const Mask& mask)
{
  return bits_of(mask) != 0;
}

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
