/// \file
/// \brief The wide solver's passes; COOKBOOK_INSTRUCTION_SET names the instruction set.

#include "06_world/wide_passes/wide_passes_kernel.hpp"
#include "06_world/wide_solver/passes_in_lanes.hpp"
#include "common/simd/lanes.hpp"

namespace cookbook
{

WidePasses COOKBOOK_NAMED(wide_passes_, COOKBOOK_INSTRUCTION_SET)()
{
  return passes_in_lanes<Lanes>();
}

} // namespace cookbook
