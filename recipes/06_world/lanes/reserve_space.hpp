#pragma once

/// \file
/// \brief Room in lists that are filled anew in every step.

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cookbook
{

/// Room for so many, and for a sixteenth more, eight at least, where there has to be more than
/// there was.
template <class List>
void reserve_space(List& all, std::size_t count)
{
  if (all.capacity() < count)
  {
    all.reserve(count + std::max<std::size_t>(8, count / 16));
  }
}

/// Adds one at the end of a list, in such room.
template <class List, class One>
void append(List& all, One&& one)
{
  reserve_space(all, all.size() + 1);
  all.push_back(std::forward<One>(one));
}

} // namespace cookbook
