#include "tools/files/csv.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>

namespace cookbook
{

namespace
{

std::string_view trimmed(std::string_view text)
{
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == text.npos ? std::string_view{}
                            : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> fields_of(std::string_view line)
{
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin <= line.size();)
  {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    fields.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}

/// A field's number, or what is wrong with it.
double number_of(std::string_view field, const std::string& complaint_start)
{
  double value = 0;
  const bool plus = field.substr(0, 1) == "+" && field.substr(1, 1) != "-";
  const char* const begin = field.data() + (plus ? 1 : 0);
  const char* const end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (field.empty())
  {
    throw std::invalid_argument(complaint_start + " is missing");
  }
  if (error == std::errc::result_out_of_range)
  {
    throw std::invalid_argument(
        complaint_start + " is beyond the range of double: " + std::string(field));
  }
  if (error != std::errc{} || stop != end)
  {
    throw std::invalid_argument(
        complaint_start + " must be a number, got \"" + std::string(field) + "\"");
  }
  if (!std::isfinite(value))
  {
    throw std::invalid_argument(complaint_start + " must be finite, got " + std::string(field));
  }
  return value;
}

CsvRow row_of(
    std::string_view text, const std::string& file, std::size_t line,
    const std::vector<std::string_view>& names)
{
  const std::vector<std::string_view> fields = fields_of(text);
  if (fields.size() != names.size())
  {
    throw CsvError(
        file, line, std::min(fields.size(), names.size()) + 1,
        "expected " + std::to_string(names.size()) + " numbers, got " +
            std::to_string(fields.size()));
  }
  CsvRow row{line, {}};
  for (std::size_t column = 0; column < fields.size(); ++column)
  {
    try
    {
      row.values.push_back(number_of(fields[column], std::string(names[column])));
    }
    catch (const std::invalid_argument& complaint)
    {
      throw CsvError(file, line, column + 1, complaint.what());
    }
  }
  return row;
}

} // namespace

std::vector<CsvRow>
read_csv(std::istream& stream, const std::string& file, const std::string& header)
{
  const std::vector<std::string_view> names = fields_of(header);
  std::vector<CsvRow> rows;
  std::string text;
  bool header_seen = false;
  for (std::size_t line = 1; std::getline(stream, text); ++line)
  {
    if (line == 1 && text.substr(0, 3) == "\xEF\xBB\xBF")
    {
      text.erase(0, 3); // the mark that some editors put before UTF-8
    }
    if (trimmed(text).empty())
    {
      continue;
    }
    if (header_seen)
    {
      rows.push_back(row_of(text, file, line, names));
    }
    else if (fields_of(text) != names)
    {
      throw CsvError(file, line, 1, "expected the header " + header);
    }
    header_seen = true;
  }
  if (stream.bad())
  {
    throw std::runtime_error("cannot read " + file + " to its end");
  }
  if (!header_seen)
  {
    throw CsvError(file, 1, 1, "the file is empty; expected the header " + header);
  }
  return rows;
}

std::vector<CsvRow> read_csv(const std::filesystem::path& path, const std::string& header)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path))
  {
    throw std::runtime_error("cannot read " + path.string());
  }
  return read_csv(stream, path.string(), header);
}

std::string csv_column(const std::string& header, std::size_t column)
{
  return std::string(fields_of(header).at(column));
}

} // namespace cookbook
