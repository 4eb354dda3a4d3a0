#pragma once

/// \file
/// \brief Asking for memory before it is needed, for the kernel of box_pairs.

#include "04_obb_manifolds/box_pairs/box_pairs.hpp"
#include "common/simd/lanes.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// A block that will be read, if it is const, or written; it is asked for a few lines at a time.
template <class Block>
class Ahead
{
public:
  /// From now on it is this block.
  void begin(Block* block)
  {
    line_ = reinterpret_cast<std::uintptr_t>(block);
    times_left_ = times;
  }

  /// Asks for the next lines.
  void ask()
  {
    if (times_left_ > 0)
    {
      --times_left_;
      for (std::size_t i = 0; i < at_once; ++i, line_ += line)
      {
#if !defined(COOKBOOK_PLAIN)
        __builtin_prefetch(reinterpret_cast<const void*>(line_), !std::is_const_v<Block>);
#endif
      }
    }
  }

private:
  static constexpr std::size_t line = 64; // bytes
  static constexpr std::size_t lines = sizeof(Block) / line;
  static constexpr std::size_t times = 2 * 16 / width; // so often it is asked for in sixteen pairs
  static constexpr std::size_t at_once = (lines + times - 1) / times;

  std::uintptr_t line_ = 0;
  std::size_t times_left_ = 0;
};

/// The blocks that come next.
struct Next
{
  Ahead<const SixteenBoxes> a, b;
  Ahead<SixteenFaceManifolds> faces;
  Ahead<SixteenEdgeManifolds> edges;

  /// Asks for a few lines of each; twice for every register of pairs.
  void ask()
  {
    a.ask();
    b.ask();
    faces.ask();
    edges.ask();
  }
};

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
