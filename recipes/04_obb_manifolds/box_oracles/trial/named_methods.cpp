/// \file
/// \brief Every method for two boxes, in float and in double, compiled once for programs, charts
/// and tests.

#include "04_obb_manifolds/box_oracles/trial/named_methods.hpp"
#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"
#include "04_obb_manifolds/box_oracles/trial/timed_methods.hpp"
#include "04_obb_manifolds/box_workloads/trial/boxes_file.hpp"

namespace cookbook
{
namespace
{

/// A method of this book: its pairs lie in a list, its answers are forgotten one by one.
template <class Real, class Method>
TimedMethod own_contender(const std::string& name, const Method& method)
{
  const auto prepare = [method](const BoxPairLists& lists) -> std::function<void()>
  {
    return [method, pairs = lists.in<Real>()]
    {
      for (const auto& [a, b] : pairs)
      {
        const auto manifold = method(a, b);
        measure::keep(manifold);
      }
    };
  };
  return box_contender<Real>(name, false, method, prepare);
}

} // namespace

std::vector<std::string> box_manifold_names()
{
  std::vector<std::string> names;
  for_every_box_method([&](const std::string& name, const auto&) { names.push_back(name); });
  return names;
}

std::vector<TimedMethod> own_contenders()
{
  std::vector<TimedMethod> all;
  for_every_box_method(
      [&](const std::string& name, const auto& method)
      {
        all.push_back(own_contender<float>(name + ", float", method));
        all.push_back(own_contender<double>(name + ", double", method));
      });
  return all;
}

void print_own_manifolds(const Arguments& arguments)
{
  for_every_box_method(
      [&](const std::string& name, const auto& method)
      {
        if (name == arguments.value("method"))
        {
          print_pairs(arguments, of_box_rows(method));
        }
      });
}

} // namespace cookbook
