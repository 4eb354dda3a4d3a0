#pragma once

/// \file
/// \brief When a free body flips, in closed form: elliptic integrals by means of two numbers.

#include "common/math/vector.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace cookbook
{

/// The elliptic integral of the first kind of an amplitude [rad], 0 to π/2, by the complementary
/// modulus k' = √(1 − k²), above zero, that is the descent of arithmetic and geometric means.
inline double elliptic_integral(double amplitude, double complement)
{
  double a = 1, b = complement, scale = 1;
  while (std::abs(a - b) > 1e-15 * a)
  {
    const double turns = std::floor(amplitude / std::numbers::pi + 0.5);
    amplitude += std::atan(b / a * std::tan(amplitude)) + turns * std::numbers::pi;
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
    scale *= 2;
  }
  return amplitude / (scale * a);
}

/// The same of π/2, a quarter of a period: π / (2 agm(1, k')).
inline double quarter_period(double complement)
{
  double a = 1, b = complement;
  while (std::abs(a - b) > 1e-15 * a)
  {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return std::numbers::pi / (2 * a);
}

/// When [s] the spin about the middle axis is zero, for the first three times, of a free body with
/// moments that grow from x to z and a spin [rad/s] along its axes that is nowhere zero.
inline std::array<double, 3> flip_times(Vector3<double> moments, Vector3<double> spin)
{
  const auto swap = [](Vector3<double>& v) { std::swap(v.x(), v.z()); };
  const Vector3<double> momentum = moments.cwiseProduct(spin);
  if (momentum.squaredNorm() < momentum.dot(spin) * moments.y())
  {
    swap(moments);
    swap(spin);
  }
  const double i1 = moments.x(), i2 = moments.y(), i3 = moments.z();
  const double energy = moments.cwiseProduct(spin).dot(spin);
  const double square = moments.cwiseProduct(spin).squaredNorm();
  const double slow = energy * i3 - square, fast = square - energy * i1;
  const double complement = std::sqrt(1 - (i2 - i1) * slow / ((i3 - i2) * fast));
  const double rate = std::sqrt((i3 - i2) * fast / (i1 * i2 * i3));
  // The spin about y is a sine of this amplitude, that about x the cosine.
  const double sine = std::abs(spin.y()) * std::sqrt(i2 * (i3 - i2) / slow);
  const double cosine = std::abs(spin.x()) * std::sqrt(i1 * (i3 - i1) / slow);
  const double quarter = quarter_period(complement);
  const double left = elliptic_integral(std::atan2(cosine, complement * sine), complement);
  const bool grows = spin.x() * spin.y() * spin.z() > 0; // |spin about y|
  const double first = grows ? quarter + left : quarter - left;
  return {first / rate, (first + 2 * quarter) / rate, (first + 4 * quarter) / rate};
}

} // namespace cookbook
