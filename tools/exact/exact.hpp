#pragma once

/// \file
/// \brief The exact values of floats and doubles, in fractions or in a hundred digits.

#include "tools/exact/rational.hpp"
#include "tools/exact/reference.hpp"

namespace cookbook
{

/// The exact value of a float or double, as another kind of number.
template <class To, class From>
To exact(From x)
{
  return To(x);
}

/// The exact values of a vector's components.
template <class To, class From>
Vector3<To> exact(const Vector3<From>& v)
{
  return {To(v.x()), To(v.y()), To(v.z())};
}

} // namespace cookbook
