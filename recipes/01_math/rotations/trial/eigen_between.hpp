#pragma once

/// \file
/// \brief Eigen's rotation between two vectors, compiled once: it brings a decomposition with it.

#include "common/math/vector.hpp"

namespace cookbook
{

/// Quaternion::FromTwoVectors().
Quaternion<float> eigen_between(const Vector3<float>& from, const Vector3<float>& to);

} // namespace cookbook
