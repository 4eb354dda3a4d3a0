#include "tools/program/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace cookbook
{

std::string number(double value)
{
  char text[32]; // std::to_chars brings tables of 110 kB, which a live figure would carry; no
                 // locale is set
  return std::string(
      text, std::size_t(std::snprintf(text, sizeof text, "%.4g", value == 0 ? 0.0 : value)));
}

std::string rounded(double value)
{
  if (!std::isfinite(value) || value <= 0)
  {
    return std::isfinite(value) ? "0" : "–";
  }
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return number(std::round(value / unit) * unit);
}

Table::Table(std::vector<std::string> header)
{
  rows_.push_back(std::move(header));
}

void Table::row(std::vector<std::string> cells)
{
  if (cells.size() != rows_.front().size())
  {
    throw std::logic_error("a row has " + std::to_string(cells.size()) + " cells");
  }
  rows_.push_back(std::move(cells));
}

namespace
{

/// Characters in UTF-8: every byte but those that continue one.
std::size_t width(const std::string& text)
{
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

bool is_number(const std::string& text)
{
  return text == "inf" || text == "-inf" || text == "nan" ||
         (!text.empty() && text.find_first_not_of("0123456789.+-e,") == text.npos);
}

} // namespace

std::string Table::text() const
{
  std::vector<std::size_t> widths(rows_.front().size(), 0);
  std::vector<bool> numbers(rows_.front().size(), false);
  for (const std::vector<std::string>& row : rows_)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      widths[i] = std::max(widths[i], width(row[i]));
      numbers[i] = numbers[i] || is_number(row[i]);
    }
  }
  std::string all;
  for (const std::vector<std::string>& row : rows_)
  {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      const bool right = is_number(row[i]) || (&row == &rows_.front() && numbers[i]);
      const std::string fill(widths[i] - width(row[i]), ' ');
      line += (i == 0 ? "" : "  ") + (right ? fill + row[i] : row[i] + fill);
    }
    all += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return all;
}

std::string text_table(const Cells& rows)
{
  Table table(rows.front());
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    table.row(rows[i]);
  }
  return table.text();
}

std::string html_table(const Cells& rows)
{
  std::string html = "<table class=\"doxtable\">";
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const std::string tag = i == 0 ? "th>" : "td>";
    html += "<tr>";
    for (const std::string& cell : rows[i])
    {
      html.append("<").append(tag).append(cell).append("</").append(tag);
    }
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

} // namespace cookbook
