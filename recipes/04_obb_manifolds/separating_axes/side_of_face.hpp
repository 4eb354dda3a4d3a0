#pragma once

/// \file
/// \brief Which side of a face a point is on.

namespace cookbook
{

/// Which side of a face a point is on: 1 outside, 0 on it as far as rounding can tell, −1 inside.
template <class Real>
int side_of_face(Real distance, Real tolerance)
{
  return distance > tolerance ? 1 : distance < -tolerance ? -1 : 0;
}

} // namespace cookbook
