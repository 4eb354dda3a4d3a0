#pragma once

/// \file
/// \brief The reader's own pairs: shapes from the rows of a CSV file, manifolds back as CSV.

#include "02_primitives/shapes/checked_shapes.hpp"
#include "02_primitives/shapes/shapes.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "tools/files/pairs_row.hpp"
#include "tools/program/program.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

/// A shape from a row, if its numbers make sense; else CsvError at the column of the member at
/// fault.
template <class Shape>
Shape checked_shape(
    const PairsRow& row, const Shape& shape,
    const std::map<std::string, std::size_t>& column_of_member)
{
  try
  {
    return checked(shape);
  }
  catch (const InvalidShape& error)
  {
    row.fail(column_of_member.at(error.member()), error.what());
  }
}

/// The sphere whose four columns begin at `first`: centre, radius.
template <class Real>
Sphere<Real> sphere_at(const PairsRow& row, std::size_t first)
{
  const Sphere<Real> sphere{row.vector<Real>(first), row.at<Real>(first + 3)};
  return checked_shape(
      row, sphere,
      {{"center.x", first},
       {"center.y", first + 1},
       {"center.z", first + 2},
       {"radius", first + 3}});
}

/// The box whose ten columns begin at `first`: centre, quaternion w x y z, half extents.
///
/// A quaternion whose length is within a thousandth of one is taken as rounded and set to one.
template <class Real>
Obb<Real> obb_at(const PairsRow& row, std::size_t first)
{
  const std::vector<double>& v = row.row.values;
  const Quaternion<double> q(v[first + 3], v[first + 4], v[first + 5], v[first + 6]);
  if (!(std::abs(q.norm() - 1) <= 1e-3))
  {
    row.fail(first + 3, "the quaternion must have length 1, got " + round_trip(q.norm()));
  }
  const Obb<Real> box{
      row.vector<Real>(first), q.normalized().toRotationMatrix().template cast<Real>(),
      row.vector<Real>(first + 7)};
  return checked_shape(
      row, box,
      {{"center.x", first},
       {"center.y", first + 1},
       {"center.z", first + 2},
       {"axes", first + 3},
       {"half_extents.x", first + 7},
       {"half_extents.y", first + 8},
       {"half_extents.z", first + 9}});
}

/// All manifolds as CSV: `pair,hit,depth,nx,ny,nz,count,p0x,p0y,p0z,p0depth,…`, pairs from zero.
///
/// There are columns for as many points as any pair has; cells that a pair has no value for are
/// empty. Numbers read back as the same numbers.
template <class Real, std::size_t Capacity>
std::string manifolds_csv(const std::vector<std::optional<Manifold<Real, Capacity>>>& manifolds)
{
  std::size_t most = 1;
  for (const auto& manifold : manifolds)
  {
    most = std::max(most, manifold ? manifold->points.size() : 0);
  }
  std::string text = "pair,hit,depth,nx,ny,nz,count";
  for (std::size_t i = 0; i < most; ++i)
  {
    for (const char* const part : {"x", "y", "z", "depth"})
    {
      text.append(",p").append(std::to_string(i)).append(part);
    }
  }
  text += "\n";
  const auto add = [&text](const auto& value) { text.append(",").append(round_trip(value)); };
  const auto add_vector = [&add](const Vector3<Real>& v) { add(v.x()), add(v.y()), add(v.z()); };
  for (std::size_t pair = 0; pair < manifolds.size(); ++pair)
  {
    const auto& manifold = manifolds[pair];
    const std::size_t count = manifold ? manifold->points.size() : 0;
    text.append(std::to_string(pair)).append(manifold ? ",1" : ",0,,,,");
    if (manifold)
    {
      add(manifold->depth);
      add_vector(manifold->normal);
    }
    text.append(",").append(std::to_string(count));
    for (std::size_t i = 0; i < count; ++i)
    {
      add_vector(manifold->points[i].position);
      add(manifold->points[i].depth);
    }
    text.append(4 * (most - count), ',').append("\n");
  }
  return text;
}

/// Whether all numbers of a manifold are finite.
template <class Real, std::size_t Capacity>
bool is_finite(const Manifold<Real, Capacity>& manifold)
{
  return manifold.normal.allFinite() && std::isfinite(manifold.depth) &&
         std::all_of(
             manifold.points.begin(), manifold.points.end(),
             [](const ContactPoint<Real>& point)
             { return point.position.allFinite() && std::isfinite(point.depth); });
}

/// Prints the manifold that `find(row, Real())` gives of every row of --pairs, in the number type
/// that --scalar names; the whole file is read first. CsvError at a row whose manifold does not fit
/// that type.
template <class Find>
void print_pairs(const Arguments& arguments, const Find& find)
{
  const auto print_as = [&](auto zero)
  {
    const std::string file = arguments.pairs.string();
    std::vector<decltype(find(std::declval<PairsRow>(), zero))> manifolds;
    for (const CsvRow& row : read_csv(arguments.pairs, arguments.pairs_header))
    {
      manifolds.push_back(find({file, arguments.pairs_header, row}, zero));
      if (manifolds.back() && !is_finite(*manifolds.back()))
      {
        throw CsvError(file, row.line, 1, "the manifold is too large for the number type");
      }
    }
    std::cout << manifolds_csv(manifolds);
  };
  arguments.value("scalar") == "float" ? print_as(0.0f) : print_as(0.0);
}

/// Runs a program that takes --pairs and --scalar: prints the manifolds of the reader's own pairs,
/// as print_pairs() does, or else calls `own(arguments)` for the chapter's scene.
template <class Find>
int run_pairs_program(
    int argc, char** argv, Arguments arguments, const Find& find,
    const std::function<void(const Arguments&)>& own)
{
  arguments.options.push_back(scalar_option());
  return run_program(
      argc, argv, std::move(arguments),
      [&](const Arguments& given) { given.pairs.empty() ? own(given) : print_pairs(given, find); });
}

} // namespace cookbook
