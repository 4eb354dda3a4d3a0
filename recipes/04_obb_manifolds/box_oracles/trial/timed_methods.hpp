#pragma once

/// \file
/// \brief The methods that give a whole manifold of two boxes, made ready to be checked and timed.

#include "04_obb_manifolds/box_oracles/trial/manifold_check.hpp"
#include "tools/measure/timing.hpp"
#include "tools/program/program.hpp"

#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

/// The same pairs for methods in float and for methods in double.
struct BoxPairLists
{
  std::vector<BoxPair<float>> in_float;
  std::vector<BoxPair<double>> in_double;

  /// Those in the number type `Real`.
  template <class Real>
  const std::vector<BoxPair<Real>>& in() const
  {
    if constexpr (std::is_same_v<Real, float>)
    {
      return in_float;
    }
    else
    {
      return in_double;
    }
  }
};

/// A workload's pairs.
inline BoxPairLists box_pair_lists(const std::vector<BoxPair<float>>& pairs)
{
  BoxPairLists lists{pairs, {}};
  lists.in_double.reserve(pairs.size());
  for (const BoxPair<float>& pair : pairs)
  {
    lists.in_double.push_back(pair_in<double>(pair));
  }
  return lists;
}

/// A method in one number type, or another library: how to time it, and how good it is.
struct TimedMethod
{
  std::string name;
  bool peer; ///< whether it is another library's
  /// What answers all pairs once, made ready; the pairs are copied.
  std::function<std::function<void()>(const BoxPairLists&)> prepare;
  std::function<std::vector<ManifoldCheck>(const BoxPairLists&)> checks; ///< of each answer
  std::function<RestingSteadiness(const BoxWorkload&)> steadiness;       ///< under a nudge
};

/// A contender by what it says of one pair, and how it is made ready for many.
template <class Real, class Method, class Prepare>
TimedMethod
box_contender(const std::string& name, bool peer, const Method& method, const Prepare& prepare)
{
  const auto checks = [method](const BoxPairLists& lists)
  {
    std::vector<ManifoldCheck> result;
    for (const BoxPair<Real>& pair : lists.in<Real>())
    {
      result.push_back(manifold_check(pair, method(pair.first, pair.second)));
    }
    return result;
  };
  const auto steadiness = [method](const BoxWorkload& workload)
  {
    const auto with_points = [&](const Obb<Real>& a, const Obb<Real>& b)
    {
      const auto answer = method(a, b);
      return answer && is_whole(*answer) ? answer : std::nullopt;
    };
    return resting_steadiness<Real>(workload, with_points);
  };
  return {name, peer, prepare, checks, steadiness};
}

/// The names of the functions that for_every_box_method() visits.
std::vector<std::string> box_manifold_names();

/// Every method in float and in double, box_box in float first.
std::vector<TimedMethod> own_contenders();

/// Prints the manifolds of --pairs by the method that --method names.
void print_own_manifolds(const Arguments& arguments);

} // namespace cookbook
