#pragma once

/// \file
/// \brief The wide solver's passes, compiled once for each instruction set.

#include "06_world/wide_solver/wide_view.hpp"

namespace cookbook
{

using WidePassesKernel = WidePasses(); ///< gives the passes in registers of one width

WidePassesKernel wide_passes_portable; ///< for every processor
WidePassesKernel wide_passes_avx2;     ///< for processors with AVX2
WidePassesKernel wide_passes_avx512;   ///< for processors with AVX-512

} // namespace cookbook
