/// \file
/// How many random inputs a function is tried on.
#pragma once

namespace cookbook
{

/// A hundred thousand; fewer where every step is watched by sanitizers.
#ifdef COOKBOOK_FEWER_PAIRS
constexpr int random_inputs = 3'000;
#else
constexpr int random_inputs = 100'000;
#endif

} // namespace cookbook
