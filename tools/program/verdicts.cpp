#include "tools/program/verdicts.hpp"

#include <algorithm>
#include <stdexcept>

namespace cookbook
{

namespace
{

std::string escaped(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return result;
}

std::string row_html(const VerdictRow& row, const std::string& mark, bool right)
{
  const std::string id = row.id.empty() ? "" : " id=\"" + mark + "-" + row.id + "\"";
  std::string html =
      "<tr" + id + "><th>" + escaped(row.id) + "</th><td>" + escaped(row.what) + "</td>";
  html += right ? "<td>" + escaped(row.right) + "</td>" : "";
  for (const Verdict& verdict : row.verdicts)
  {
    const std::string kind = !verdict.applies ? "verdict-none"
                             : verdict.holds  ? "verdict-holds"
                                              : "verdict-fails";
    html += "<td class=\"" + kind + "\">" + escaped(verdict.what) + "</td>";
  }
  return html + "</tr>\n";
}

} // namespace

std::string verdict_table(
    const std::string& caption, const std::vector<std::string>& methods,
    const std::vector<VerdictRow>& rows, const std::string& mark)
{
  const bool right = std::any_of(
      rows.begin(), rows.end(), [](const VerdictRow& row) { return !row.right.empty(); });
  std::string html = "<table class=\"verdicts\">\n<caption>" + escaped(caption) +
                     "</caption>\n<thead><tr><th>case</th><th>set-up</th>";
  html += right ? "<th>right</th>" : "";
  for (const std::string& method : methods)
  {
    html += "<th>" + escaped(method) + "</th>";
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const VerdictRow& row : rows)
  {
    if (row.verdicts.size() != methods.size())
    {
      throw std::logic_error(
          "case " + row.id + " has " + std::to_string(row.verdicts.size()) + " verdicts");
    }
    html += row_html(row, mark, right);
  }
  return html + "</tbody>\n</table>\n";
}

} // namespace cookbook
