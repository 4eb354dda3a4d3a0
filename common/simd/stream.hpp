#pragma once

/// \file
/// \brief Writing to memory past the cache, for answers that are too many to stay there.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__) && !defined(COOKBOOK_PLAIN)
#include <emmintrin.h>
#endif

namespace cookbook
{

/// Copies bytes past the cache: memory that is only written need not be read first.
///
/// Where the processor has no such stores it is a plain copy. Others see the bytes after
/// end_of_stream().
inline void stream(const void* from, void* to, std::size_t count)
{
  const char* source = static_cast<const char*>(from);
  char* target = static_cast<char*>(to);
#if defined(__SSE2__) && !defined(COOKBOOK_PLAIN)
  const std::size_t past_border = reinterpret_cast<std::uintptr_t>(target) % 16;
  const std::size_t head = std::min(count, (16 - past_border) % 16);
  std::memcpy(target, source, head);
  for (source += head, target += head, count -= head; count >= 16;
       source += 16, target += 16, count -= 16)
  {
    _mm_stream_si128(
        reinterpret_cast<__m128i*>(target),
        _mm_loadu_si128(reinterpret_cast<const __m128i*>(source)));
  }
#endif
  std::memcpy(target, source, count);
}

/// What was streamed is there before anything that follows.
inline void end_of_stream()
{
#if defined(__SSE2__) && !defined(COOKBOOK_PLAIN)
  _mm_sfence();
#endif
}

} // namespace cookbook
