/// \file
/// The rules of the house, each a function from text to complaints: none means it is kept.
#pragma once

#include "docs/index/scan.hpp"

#include <map>
#include <set>

namespace cookbook::house
{

using book::TextFile;
using Complaints = std::vector<std::string>;

/// What is large, by path, and how large.
using Sizes = std::map<std::string, std::string>;

/// What was found, by id, and where.
using Places = std::map<std::string, std::string>;

/// The formulas on the pages; complains about a tag that is no formula's id, or used twice.
inline Places shown_formulas(const std::vector<TextFile>& pages, Complaints& complaints)
{
  Places shown;
  for (const TextFile& page : pages)
  {
    for (const std::string& id : book::formula_ids(page.text))
    {
      if (!book::is_formula_id(id))
      {
        complaints.push_back(page.path + ": \\tag{" + id + "} is no formula's id");
      }
      else if (!shown.emplace(id, page.path).second)
      {
        complaints.push_back(page.path + ": " + id + " is already on " + shown[id]);
      }
    }
  }
  return shown;
}

/// The formulas that tests assert: tags that are one capital letter and a number.
inline Places asserted_formulas(const std::vector<TextFile>& sources)
{
  Places asserted;
  for (const TextFile& source : sources)
  {
    for (const book::Test& test : book::tests(source))
    {
      for (const std::string& tag : test.tags)
      {
        if (std::regex_match(tag, std::regex("[A-Z][0-9]+")))
        {
          asserted.emplace(tag, source.path + ": \"" + test.name + "\"");
        }
      }
    }
  }
  return asserted;
}

/// Every formula's tag has one page and at least one test; every test's tag has its formula.
inline Complaints
formulas_are_tested(const std::vector<TextFile>& pages, const std::vector<TextFile>& sources)
{
  Complaints complaints;
  const Places shown = shown_formulas(pages, complaints);
  const Places asserted = asserted_formulas(sources);
  for (const auto& [id, path] : shown)
  {
    if (asserted.count(id) == 0)
    {
      complaints.push_back(path + ": no test has the tag [" + id + "]");
    }
  }
  for (const auto& [id, place] : asserted)
  {
    if (shown.count(id) == 0)
    {
      complaints.push_back(
          place + ": no page has the formula " + id + " (a failing case is written [case:" + id +
          "])");
    }
  }
  return complaints;
}

/// Every row `id="case-C4"` of a verdict table has a test tagged [case:C4].
inline Complaints
cases_are_tested(const std::vector<TextFile>& tables, const std::vector<TextFile>& sources)
{
  std::set<std::string> asserted;
  for (const TextFile& source : sources)
  {
    for (const book::Test& test : book::tests(source))
    {
      asserted.insert(test.tags.begin(), test.tags.end());
    }
  }
  Complaints complaints;
  for (const TextFile& table : tables)
  {
    for (const std::string& id : book::case_ids(table.text))
    {
      if (asserted.count("case:" + id) == 0)
      {
        complaints.push_back(table.path + ": no test has the tag [case:" + id + "]");
      }
    }
  }
  return complaints;
}

/// Includes go downhill: common/ and tools/ know no recipe, a recipe none of a later chapter, and
/// none of them the tests or the book. Headers that are exported do not include tools/.
inline Complaints includes_go_downhill(const std::vector<TextFile>& sources)
{
  Complaints complaints;
  for (const TextFile& source : sources)
  {
    const std::string chapter = book::chapter_of(source.path);
    for (const std::string& target :
         book::matches(source.text, R"((?:^|\n)\s*#\s*include\s*["<]([^">]+)[">])"))
    {
      const std::string other = book::chapter_of(target);
      const bool above = target.rfind("tests/", 0) == 0 || target.rfind("docs/", 0) == 0;
      const bool exported =
          source.path.rfind("common/", 0) == 0 ||
          (source.path.rfind("recipes/", 0) == 0 && source.path.ends_with(".hpp") &&
           source.path.find("/trial/") == std::string::npos);
      const bool to_tools = target.rfind("tools/", 0) == 0;
      if (above || (exported && to_tools) || target.find("..") != std::string::npos ||
          other > chapter)
      {
        complaints.push_back(source.path + " includes " + target);
      }
    }
  }
  return complaints;
}

} // namespace cookbook::house
