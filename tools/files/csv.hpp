#pragma once

/// \file
/// \brief Tables of numbers: read from CSV with errors that name line and column, written back
/// with all their digits.

#include "tools/files/round_trip.hpp"

#include <filesystem>
#include <istream>
#include <stdexcept>
#include <string>
#include <vector>

namespace cookbook
{

/// What a wrong table is answered with: `path:line:column: sentence`. Both count from one; a
/// column is a field, not a character.
class CsvError : public std::runtime_error
{
public:
  /// Says where and what.
  CsvError(const std::string& file, std::size_t line, std::size_t column, const std::string& what)
      : std::runtime_error(
            file + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + what)
  {
  }
};

/// One row of numbers and where it stood.
struct CsvRow
{
  std::size_t line;           ///< in the file, from one
  std::vector<double> values; ///< as many as the header has names
};

/// Reads all rows of finite numbers below a header, which must be the one given.
///
/// Empty lines are passed over, spaces around fields too, and lines may end as on Unix or on
/// Windows. Throws CsvError for anything else, before a caller sees any row.
std::vector<CsvRow>
read_csv(std::istream& stream, const std::string& file, const std::string& header);

/// The same from a file; throws std::runtime_error if it cannot be read.
std::vector<CsvRow> read_csv(const std::filesystem::path& path, const std::string& header);

/// The name of a header's column, counted from zero: `csv_column("ax,ay", 1)` is `ay`.
std::string csv_column(const std::string& header, std::size_t column);

} // namespace cookbook
