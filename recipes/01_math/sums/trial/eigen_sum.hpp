#pragma once

/// \file
/// \brief Eigen's sum of many numbers, compiled as Eigen is by itself: with vector instructions.

#include <span>

namespace cookbook
{

/// The sum as Eigen adds: in several columns, four or two numbers wide.
float sum_eigen(std::span<const float> numbers);

/// The same in double.
double sum_eigen(std::span<const double> numbers);

} // namespace cookbook
