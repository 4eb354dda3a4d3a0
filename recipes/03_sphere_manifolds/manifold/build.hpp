#pragma once

/// \file
/// \brief A result that is built where it is to stay.

#include <type_traits>

namespace cookbook
{

/// Turns into what its function returns, where that is to stand: a manifold in an optional is
/// built in place instead of being copied there.
template <class Function>
struct Build
{
  Function function; ///< returns the value

  explicit Build(Function f) : function(f) {}                            ///< to be called later
  operator std::invoke_result_t<Function>() const { return function(); } ///< calls it
};

} // namespace cookbook
