/// \file
/// \brief Prints how wrong every method is on every workload, and draws their depths on a sweep.

#include "03_sphere_manifolds/sphere_methods/trial/sphere_methods.hpp"
#include "03_sphere_manifolds/sphere_methods/trial/sphere_methods_truth.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

constexpr std::size_t pairs_each = 300;

/// A number with two significant digits.
std::string two_digits(double value)
{
  const double digits = value > 0 ? std::pow(10, 1 - std::floor(std::log10(value))) : 1;
  return number(std::round(value * digits) / digits);
}

/// What a cell says of the errors of all pairs of a workload.
std::string cell(const std::vector<SphereError>& errors, double SphereError::*which)
{
  std::size_t wrong = 0;
  double most = 0;
  for (const SphereError& error : errors)
  {
    wrong += error.verdict ? 1 : 0;
    most = std::max(most, error.*which);
  }
  if (wrong > 0)
  {
    const std::size_t percent = (100 * wrong + errors.size() - 1) / errors.size();
    return "wrong " + std::to_string(percent) + "%";
  }
  return std::isinf(most) ? "NaN" : most < 1e-3 ? "0" : two_digits(most);
}

void print_errors()
{
  const std::vector<SphereMethod> methods = sphere_methods();
  std::vector<std::string> header{"method"};
  std::vector<std::vector<std::string>> depth(methods.size()), normal(methods.size());
  for (const Recipe& recipe : sphere_workload_recipes())
  {
    header.push_back(recipe.name);
    const Workload workload = sphere_workload(recipe, pairs_each);
    std::vector<std::vector<SphereError>> errors(methods.size());
    for (const WorldPair& pair : workload.pairs)
    {
      const auto truth = exact_sphere_sphere(pair);
      const double larger = std::max(pair.first.radius, pair.second.radius);
      for (std::size_t m = 0; m < methods.size(); ++m)
      {
        errors[m].push_back(sphere_error(
            methods[m].run(pair.first, pair.second), truth, static_cast<float>(larger)));
      }
    }
    for (std::size_t m = 0; m < methods.size(); ++m)
    {
      depth[m].push_back(cell(errors[m], &SphereError::depth));
      normal[m].push_back(cell(errors[m], &SphereError::normal));
    }
  }
  Table depths(header), normals(header);
  for (std::size_t m = 0; m < methods.size(); ++m)
  {
    depth[m].insert(depth[m].begin(), methods[m].name);
    normal[m].insert(normal[m].begin(), methods[m].name);
    depths.row(depth[m]);
    normals.row(normal[m]);
  }
  std::cout << "Largest error of the depth, in ulps of the larger radius\n" << depths.text();
  std::cout << "\nLargest error of the normal, in ulps of 1\n" << normals.text();
}

/// The depth that a method finds for B at x, a little beside A; nothing where they are apart.
std::vector<Eigen::Vector2d> depth_on_sweep(const SphereMethod& method)
{
  std::vector<Eigen::Vector2d> points;
  for (int step = -190; step <= 190; ++step)
  {
    const double x = step / 100.0;
    const auto manifold = method.run({{0, 0, 0}, 1}, {{x, 0.0625, 0}, 0.5});
    if (manifold)
    {
      points.push_back({x, manifold->depth});
    }
  }
  return points;
}

void draw(const Arguments& arguments)
{
  plot::Chart chart(
      "sphere_methods", "B passes 0.0625 m beside A's centre", {"position of B along x [m]"},
      {"depth [m]"});
  chart.describe("The depth each method finds while one sphere passes through another.")
      .size(400, 340);
  std::size_t look = 0;
  for (const SphereMethod& method : sphere_methods())
  {
    // The others coincide with these to less than a line's width.
    if (method.name == "as published" || method.name == "reciprocal, 0 steps" ||
        method.name == "sphere_sphere, float")
    {
      chart.line(method.name, depth_on_sweep(method), plot::series_look(look++));
    }
  }
  save_figure(arguments, "sphere_methods.svg", chart.svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "sphere_methods", .summary = "How wrong each method for two spheres is, and where."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_errors();
        draw(given);
      });
}
