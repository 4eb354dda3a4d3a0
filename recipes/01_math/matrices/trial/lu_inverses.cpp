#include "01_math/matrices/trial/lu_inverses.hpp"

#include <Eigen/LU>

namespace cookbook
{

template <class Real, int Size>
SquareMatrix<Real, Size> partial_lu_inverse(const SquareMatrix<Real, Size>& m)
{
  return m.partialPivLu().inverse();
}

template <class Real, int Size>
std::optional<SquareMatrix<Real, Size>> full_lu_inverse(const SquareMatrix<Real, Size>& m)
{
  using M = SquareMatrix<Real, Size>;
  const Eigen::FullPivLU<M> lu(m);
  return lu.isInvertible() ? std::optional<M>(lu.inverse()) : std::nullopt;
}

template Matrix3<float> partial_lu_inverse<float, 3>(const Matrix3<float>&);
template Matrix3<double> partial_lu_inverse<double, 3>(const Matrix3<double>&);
template Matrix4<double> partial_lu_inverse<double, 4>(const Matrix4<double>&);
template std::optional<Matrix3<float>> full_lu_inverse<float, 3>(const Matrix3<float>&);
template std::optional<Matrix3<double>> full_lu_inverse<double, 3>(const Matrix3<double>&);
template std::optional<Matrix4<double>> full_lu_inverse<double, 4>(const Matrix4<double>&);

} // namespace cookbook
