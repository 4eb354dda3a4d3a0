/// \file
/// \brief Eigen's sum, the one thing in the book that is compiled with Eigen's vector instructions.

#include "01_math/sums/trial/eigen_sum.hpp"
#include "common/math/vector.hpp"

namespace cookbook
{

namespace
{

template <class Real>
Real sum_of(std::span<const Real> numbers)
{
  using Numbers = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  return Eigen::Map<const Numbers>(numbers.data(), static_cast<Eigen::Index>(numbers.size())).sum();
}

} // namespace

float sum_eigen(std::span<const float> numbers)
{
  return sum_of(numbers);
}

double sum_eigen(std::span<const double> numbers)
{
  return sum_of(numbers);
}

} // namespace cookbook
