/// \file
/// \brief The methods for two boxes in float and in double, compiled here and nowhere else.

#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"

namespace cookbook
{

COOKBOOK_BOX_ROWS(, float, RowOf<float, 3>)
COOKBOOK_BOX_ROWS(, float, RowInRegisters<float>)
COOKBOOK_BOX_ROWS(, double, RowOf<double, 3>)
COOKBOOK_BOX_ROWS(, double, RowInRegisters<double>)
COOKBOOK_BOX_METHODS(, float)
COOKBOOK_BOX_METHODS(, double)

} // namespace cookbook
