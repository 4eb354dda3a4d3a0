/// \file
/// \brief Eigen's rotation between two vectors.

#include "01_math/rotations/trial/eigen_between.hpp"

namespace cookbook
{

Quaternion<float> eigen_between(const Vector3<float>& from, const Vector3<float>& to)
{
  return Quaternion<float>::FromTwoVectors(from, to);
}

} // namespace cookbook
