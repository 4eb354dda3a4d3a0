#pragma once

/// \file
/// \brief A row of the reader's own pairs: its numbers, and errors that say where it stands.

#include "common/math/vector.hpp"
#include "tools/files/csv.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace cookbook
{

/// A row of a file of pairs, with what an error needs to say where it is.
struct PairsRow
{
  std::string file;   ///< its path
  std::string header; ///< names of the columns
  CsvRow row;         ///< the numbers

  /// The number in a column, rounded to `Real`; CsvError if it is too large or too small for that.
  template <class Real>
  Real at(std::size_t column) const
  {
    const double value = row.values[column];
    const bool too_large = std::abs(value) > static_cast<double>(std::numeric_limits<Real>::max());
    const Real rounded = too_large ? Real(0) : static_cast<Real>(value);
    if (rounded == Real(0) && value != 0)
    {
      fail(
          column, round_trip(value) + (too_large ? " is too large" : " is too small") +
                      " for the number type");
    }
    return rounded;
  }

  /// Three columns from `first` on, as a vector.
  template <class Real>
  Vector3<Real> vector(std::size_t first) const
  {
    return {at<Real>(first), at<Real>(first + 1), at<Real>(first + 2)};
  }

  /// Throws CsvError at a column, beginning with the column's name.
  [[noreturn]] void fail(std::size_t column, const std::string& sentence) const
  {
    throw CsvError(file, row.line, column + 1, csv_column(header, column) + ": " + sentence);
  }
};

} // namespace cookbook
