#include "01_math/inverse_chart/trial/inverse_chart.hpp"

namespace cookbook
{

template std::vector<TimedInverse<3>> timed_inverses<3>();
template std::vector<TimedInverse<4>> timed_inverses<4>();

} // namespace cookbook
