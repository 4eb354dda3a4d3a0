#include "tools/measure/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace cookbook::measure
{

std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& methods)
{
  std::vector<std::size_t> order(methods.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(
      order.begin(), order.end(),
      [&](std::size_t i, std::size_t k)
      {
        return methods[i].cost != methods[k].cost ? methods[i].cost < methods[k].cost
                                                  : methods[i].error < methods[k].error;
      });
  // From cheap to dear, each new least error is on the front.
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order)
  {
    if (methods[i].error < least)
    {
      least = methods[i].error;
      front.push_back(i);
    }
  }
  return front;
}

std::size_t knee(
    const std::vector<CostAndError>& methods, const std::vector<std::size_t>& front,
    double least_error)
{
  if (front.empty())
  {
    throw std::invalid_argument("front must have points, got none");
  }
  const auto x = [&](std::size_t i) { return std::log(methods[i].cost); };
  const auto y = [&](std::size_t i) { return std::log(std::max(methods[i].error, least_error)); };
  const double slope_x = x(front.back()) - x(front.front());
  const double slope_y = y(front.back()) - y(front.front());
  std::size_t best = front.front();
  double farthest = 0;
  for (const std::size_t i : front)
  {
    // Twice the area under the line: grows with the distance from it.
    const double below = slope_y * (x(i) - x(front.front())) - slope_x * (y(i) - y(front.front()));
    if (below > farthest)
    {
      farthest = below;
      best = i;
    }
  }
  return best;
}

} // namespace cookbook::measure
