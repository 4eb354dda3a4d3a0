#pragma once

/// \file
/// \brief Which methods are worth having: those that none beats in both cost and error.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace cookbook::measure
{

/// What a method costs, and how wrong it is; less is better in both.
struct CostAndError
{
  double cost;  ///< for example [ns]
  double error; ///< for example [ulp]; infinite where the method fails
};

/// The places in `methods` of those on the Pareto front, from the cheapest to the most accurate.
///
/// A method is on it if no other is at least as good in both and better in one. Methods with an
/// infinite or unknown error are never on it; of equal methods, the first is.
std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& methods);

/// The place in `front` where paying more stops to pay: the point farthest below the line from
/// the front's first to its last point, both axes logarithmic.
///
/// `front` is what pareto_front gives, with positive costs; an error of zero counts as
/// `least_error`. A front without a point below that line has its cheapest as knee; an empty one
/// throws std::invalid_argument.
std::size_t knee(
    const std::vector<CostAndError>& methods, const std::vector<std::size_t>& front,
    double least_error);

/// The least time that any peer takes on a workload [ns]; infinite without peers.
template <class Measured>
double fastest_peer(const std::vector<Measured>& methods, std::size_t workload)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Measured& method : methods)
  {
    least = method.peer ? std::min(least, method.ns[workload]) : least;
  }
  return least;
}

} // namespace cookbook::measure
