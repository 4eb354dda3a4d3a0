#pragma once

/// \file
/// \brief The reader's own pairs of boxes, from the rows of a CSV file.

#include "03_sphere_manifolds/manifold/any_size.hpp"
#include "03_sphere_manifolds/manifold/trial/pairs_file.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace cookbook
{

/// Which lengths of boxes a method takes.
enum class BoxLengths
{
  with_squares, ///< those whose squares fit
  any           ///< all
};

/// Both boxes of a row under box_pairs_header; CsvError at the first length that is too large.
template <class Real>
std::pair<Obb<Real>, Obb<Real>>
box_pair_at(const PairsRow& row, BoxLengths lengths = BoxLengths::with_squares)
{
  const std::pair<Obb<Real>, Obb<Real>> boxes{obb_at<Real>(row, 0), obb_at<Real>(row, 10)};
  const Real most =
      lengths == BoxLengths::any ? std::numeric_limits<Real>::max() : squares_fit<Real>;
  for (const std::size_t column : {0u, 1u, 2u, 7u, 8u, 9u, 10u, 11u, 12u, 17u, 18u, 19u})
  {
    const Real length = row.at<Real>(column);
    if (std::abs(length) > most)
    {
      row.fail(
          column, "lengths must be at most " + round_trip(most) + ", got " + round_trip(length));
    }
  }
  return boxes;
}

/// The manifold that `method(a, b)` gives of a row, as print_pairs() asks for it.
template <class Method>
auto of_box_rows(const Method& method, BoxLengths lengths = BoxLengths::with_squares)
{
  return [method, lengths](const PairsRow& row, auto zero)
  {
    const auto [a, b] = box_pair_at<decltype(zero)>(row, lengths);
    return method(a, b);
  };
}

} // namespace cookbook
