#include "tools/measure/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace cookbook::measure
{

std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& methods)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    if (std::isfinite(methods[i].error))
    {
      order.push_back(i);
    }
  }
  std::stable_sort(
      order.begin(), order.end(),
      [&](std::size_t i, std::size_t k)
      {
        return methods[i].cost != methods[k].cost ? methods[i].cost < methods[k].cost
                                                  : methods[i].error < methods[k].error;
      });
  // From cheap to dear, each that is clearly better than all before is on the front.
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order)
  {
    const auto& [cost, error, answer] = methods[i];
    if (error < 0.8 * least)
    {
      least = error;
      const bool there = std::any_of(
          front.begin(), front.end(),
          [&same = answer, &methods](std::size_t k)
          { return !same.empty() && methods[k].answer == same; });
      if (!there)
      {
        front.push_back(i);
      }
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
