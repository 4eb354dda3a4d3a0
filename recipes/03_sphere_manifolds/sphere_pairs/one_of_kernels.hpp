#pragma once

/// \file
/// \brief Which of three kernels an instruction set takes.

#include "03_sphere_manifolds/sphere_pairs/sphere_pairs.hpp"

namespace cookbook
{

/// The kernel for an instruction set.
template <class Kernel>
Kernel* one_of(InstructionSet set, Kernel* portable, Kernel* avx2, Kernel* avx512)
{
  switch (set)
  {
  case InstructionSet::avx2:
    return avx2;
  case InstructionSet::avx512:
    return avx512;
  case InstructionSet::portable:
    return portable;
  }
  return portable;
}

} // namespace cookbook
