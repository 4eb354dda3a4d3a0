/// \file
/// How many random inputs a function is tried on.
#pragma once

namespace cookbook
{

/// `all`, or only `watched` where sanitizers watch every step.
template <class Number>
constexpr Number inputs(Number all, Number watched)
{
#ifdef COOKBOOK_SANITIZE
  constexpr bool is_watched = true;
#else
  constexpr bool is_watched = false;
#endif
  return is_watched ? watched : all;
}

/// What is enough for most.
constexpr int random_inputs = inputs(100'000, 1'500);

} // namespace cookbook
