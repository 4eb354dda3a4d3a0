#pragma once

/// \file
/// \brief Which methods are worth having: those that none beats in both cost and error.

#include <cstddef>
#include <string>
#include <vector>

namespace cookbook::measure
{

/// What a method costs, and how wrong it is; less is better in both.
struct CostAndError
{
  double cost;             ///< for example [ns]
  double error;            ///< for example [ulp]; infinite where the method fails
  std::string answer = {}; ///< what several have in common by construction; empty: nothing
};

/// The places in `methods` of those on the Pareto front, from the cheapest to the most accurate.
///
/// A method is on it if no other is cheaper, or costs the same, and has no more than 5/4 of its
/// error: less is no reason to pay more. Methods with an infinite or unknown error are never on it;
/// of equal methods, the first is. Those with the same answer (a method in float and in double,
/// say) are no competitors: the cheapest stands for all.
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

} // namespace cookbook::measure
