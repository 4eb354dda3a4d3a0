/// \file
/// Random sizes and speeds over many orders of magnitude.
#pragma once

#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"

#include <cmath>

namespace cookbook
{

/// A number whose logarithm is spread evenly.
inline double evenly(BoxDraw& draw, double least, double most)
{
  return least * std::pow(most / least, draw.between(0, 1));
}

} // namespace cookbook
