/// \file
/// \brief wide_passes: chooses the instruction set.

#include "03_sphere_manifolds/sphere_pairs/one_of_kernels.hpp"
#include "06_world/wide_passes/wide_passes.hpp"
#include "06_world/wide_passes/wide_passes_kernel.hpp"
#include "06_world/wide_solver/wide_contacts.hpp"

namespace cookbook
{

WidePasses wide_passes(InstructionSet set)
{
#if defined(COOKBOOK_KERNELS_X86)
  return one_of(set, wide_passes_portable, wide_passes_avx2, wide_passes_avx512)();
#else
  static_cast<void>(set);
  return wide_passes_portable();
#endif
}

WidePasses widest_passes()
{
  return wide_passes(widest_instruction_set());
}

} // namespace cookbook
