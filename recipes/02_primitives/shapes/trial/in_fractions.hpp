#pragma once

/// \file
/// \brief The exact shapes that floats and doubles make.

#include "02_primitives/shapes/more_shapes.hpp"
#include "tools/exact/exact.hpp"

namespace cookbook
{

/// The exact triangle.
template <class Real>
Triangle<Rational> in_fractions(const Triangle<Real>& t)
{
  return {exact<Rational>(t.a), exact<Rational>(t.b), exact<Rational>(t.c)};
}

/// The exact box: its axes are a little skew, as floats are.
template <class Real>
Obb<Rational> in_fractions(const Obb<Real>& box)
{
  Obb<Rational> exactly;
  exactly.center = exact<Rational>(box.center);
  exactly.half_extents = exact<Rational>(box.half_extents);
  for (int i = 0; i < 3; ++i)
  {
    exactly.axes.col(i) = exact<Rational>(Vector3<Real>(box.axes.col(i)));
  }
  return exactly;
}

} // namespace cookbook
