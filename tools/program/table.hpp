#pragma once

/// \file
/// \brief Numbers and tables as the recipes print them: the same text on every machine.

#include <string>
#include <vector>

namespace cookbook
{

/// A number with at most four significant digits and no negative zero, such as 0.05 or 1.25e-07.
std::string number(double value);

/// A number rounded to two significant digits; 0 for what is not above zero, – for infinite or
/// none.
std::string rounded(double value);

/// Rows under a header, each column as wide as its widest cell; numbers and the names of their
/// columns stand at the right.
class Table
{
public:
  /// A table with these columns.
  explicit Table(std::vector<std::string> header);

  /// Adds a row; std::logic_error if it has not one cell for each column.
  void row(std::vector<std::string> cells);

  /// The whole table, a line for each row, without spaces at the ends.
  std::string text() const;

private:
  std::vector<std::vector<std::string>> rows_;
};

/// Rows of cells, the first of them a head.
using Cells = std::vector<std::vector<std::string>>;

/// A table in text.
std::string text_table(const Cells& rows);

/// A table in HTML.
std::string html_table(const Cells& rows);

} // namespace cookbook
