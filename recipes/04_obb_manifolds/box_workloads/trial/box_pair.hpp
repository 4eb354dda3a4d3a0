#pragma once

/// \file
/// \brief Two boxes whose manifold is asked for.

#include "02_primitives/shapes/shapes.hpp"

#include <utility>

namespace cookbook
{

/// Two boxes whose manifold is asked for.
template <class Real>
using BoxPair = std::pair<Obb<Real>, Obb<Real>>;

} // namespace cookbook
