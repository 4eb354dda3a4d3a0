#include "06_world/game_world/trial/counted_allocations.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace
{

long count = 0;
long bytes = 0;

long size_of(void* point_scratch)
{
  return point_scratch == nullptr ? 0 : static_cast<long>(malloc_usable_size(point_scratch));
}

void* counted(std::size_t size, std::size_t alignment)
{
  ++count;
  const std::size_t blocks = (std::max(size, std::size_t(1)) + alignment - 1) / alignment;
  if (void* const point_scratch = std::aligned_alloc(alignment, blocks * alignment))
  {
    bytes += size_of(point_scratch);
    return point_scratch;
  }
  throw std::bad_alloc();
}

void released(void* point_scratch)
{
  bytes -= size_of(point_scratch);
  std::free(point_scratch);
}

constexpr std::size_t usual = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

} // namespace

long cookbook::counted_allocations()
{
  return count;
}

long cookbook::held_bytes()
{
  return bytes;
}

// Those of arrays, and those that do not throw, call these.
void* operator new(std::size_t size)
{
  return counted(size, usual);
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
  return counted(size, std::max(usual, static_cast<std::size_t>(alignment)));
}

void operator delete(void* point_scratch) noexcept
{
  released(point_scratch);
}

void operator delete(void* point_scratch, std::size_t) noexcept
{
  released(point_scratch);
}

void operator delete(void* point_scratch, std::align_val_t) noexcept
{
  released(point_scratch);
}

void operator delete(void* point_scratch, std::size_t, std::align_val_t) noexcept
{
  released(point_scratch);
}
