#include "tools/program/verdicts.hpp"

#include <algorithm>
#include <set>
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

std::string folded_verdict_table(
    const std::string& caption, const std::vector<std::string>& methods,
    const std::vector<VerdictRow>& rows, const std::string& mark)
{
  constexpr std::size_t most = 10;
  std::vector<bool> is_shown;
  std::set<std::vector<bool>> patterns;
  std::size_t shown = 0;
  for (const VerdictRow& row : rows)
  {
    std::vector<bool> pattern;
    for (const Verdict& verdict : row.verdicts)
    {
      pattern.push_back(verdict.holds);
    }
    is_shown.push_back(patterns.insert(pattern).second || !row.id.empty());
    shown += is_shown.back() ? 1 : 0;
  }
  std::vector<VerdictRow> telling, rest;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const bool fills = !is_shown[i] && shown < most;
    shown += fills ? 1 : 0;
    (is_shown[i] || fills ? telling : rest).push_back(rows[i]);
  }
  const std::string others = rest.empty() ? "" : std::to_string(rest.size()) + " other cases";
  return verdict_table(caption, methods, telling, mark) +
         (rest.empty() ? ""
                       : "<details class=\"more\">\n<summary>" + others + "</summary>\n" +
                             verdict_table("The others.", methods, rest, mark) + "</details>\n");
}

} // namespace cookbook
