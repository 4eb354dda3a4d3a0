/// \file
/// Random sizes and speeds over many orders of magnitude, and turns.
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

/// A turn by any angle about any line.
inline Quaternion<double> any_turn(BoxDraw& draw)
{
  const double w = draw.between(-1, 1);
  const Vector3<double> v = draw.vector(-1, 1);
  return Quaternion<double>(w, v.x(), v.y(), v.z()).normalized();
}

} // namespace cookbook
