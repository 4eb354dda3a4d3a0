#pragma once

/// \file
/// \brief Memory that begins with a cache line, so that no register is read from two.

#include <cstddef>
#include <new>

namespace cookbook
{

/// An allocator for lists of numbers that are read as packs.
template <class Number>
struct LineAllocator
{
  using value_type = Number; ///< what it makes room for

  static constexpr std::align_val_t line{64}; ///< the bytes of a line, and of the widest register

  LineAllocator() = default;
  template <class Other>
  LineAllocator(const LineAllocator<Other>&)
  {
  }

  /// Room for so many numbers.
  Number* allocate(std::size_t count)
  {
    return static_cast<Number*>(::operator new(count * sizeof(Number), line));
  }

  /// Gives room back.
  void deallocate(Number* room, std::size_t) { ::operator delete(room, line); }

  friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};

} // namespace cookbook
