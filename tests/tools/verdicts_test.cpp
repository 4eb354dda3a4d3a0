/// \file
/// Tables of failing cases: the column of right values, and which rows are folded.

#include "tools/program/verdicts.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

TEST_CASE("a column of right values appears where a row has one", "[verdicts]")
{
  const VerdictRow without{"", "a", {{true, "right"}}}, with{"", "a", {{true, "right"}}, "42"};
  CHECK(verdict_table("t", {"m"}, {without}).find("<th>right</th>") == std::string::npos);
  CHECK(verdict_table("t", {"m"}, {with}).find("<th>right</th>") != std::string::npos);
  CHECK(verdict_table("t", {"m"}, {with}).find("<td>42</td>") != std::string::npos);
}

TEST_CASE(
    "of 20 rows ten are shown, among them the last, which alone has an id and fails", "[verdicts]")
{
  std::vector<VerdictRow> rows;
  for (int i = 1; i < 20; ++i)
  {
    rows.push_back({"", "set-up " + std::to_string(i), {{true, "right"}}});
  }
  rows.push_back({"A1", "last", {{false, "wrong"}}});
  const std::string html = folded_verdict_table("t", {"m"}, rows);
  const std::size_t fold = html.find("<details");
  REQUIRE(fold != std::string::npos);
  CHECK(html.find("last") < fold);
  CHECK(html.find("set-up 9<") < fold);
  CHECK(html.find("set-up 10<") > fold);
  CHECK(html.find("<summary>10 other cases</summary>") != std::string::npos);
  CHECK(folded_verdict_table("t", {"m"}, {rows[0]}).find("<details") == std::string::npos);
}
