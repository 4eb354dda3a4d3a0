#pragma once

/// \file
/// \brief The most additions and multiplications a second that a core can do.

#include "tools/measure/timing.hpp"

#include <cstddef>

namespace cookbook::measure
{

// [peak_flops]
/// A loop of nothing but additions and multiplications of floats in registers of `lanes` lanes, as
/// many of each, all but a few independent of each other; a call is one of them.
///
/// Timed with methods, it gives the peak that they could reach without fused multiply-adds, which
/// this project does not use: with them a core may do twice as many. `lanes` is 4, 8 or 16, and the
/// processor must have such registers: std::invalid_argument for other numbers.
Timed peak_flops(std::size_t lanes);
// [peak_flops]

} // namespace cookbook::measure
