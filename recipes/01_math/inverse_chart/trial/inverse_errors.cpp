#include "01_math/inverse_chart/trial/inverse_chart.hpp"

namespace cookbook
{

template std::vector<SquareMatrix<double, 3>> conditioned<3>(double, int);
template measure::ErrorStatistics
inverse_errors<3>(const TimedInverse<3>&, const std::vector<SquareMatrix<double, 3>>&);
template std::vector<SquareMatrix<double, 4>> conditioned<4>(double, int);
template measure::ErrorStatistics
inverse_errors<4>(const TimedInverse<4>&, const std::vector<SquareMatrix<double, 4>>&);

} // namespace cookbook
