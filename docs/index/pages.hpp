/// \file
/// The pages of the book that are written from the tree: formulas, failing cases, recipes.
#pragma once

#include "docs/index/scan.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>

namespace cookbook::book
{

/// True for an example and its output, which a page shows whole: recipes/03_x/a/a_example.cpp.
inline bool is_example(const std::string& path)
{
  return path.rfind("recipes/", 0) == 0 && stem(path).ends_with("_example");
}

/// True for a live figure and its poses, of which each folder has its own: recipes/03_x/a/live.cpp.
inline bool is_live(const std::string& path)
{
  return path.rfind("recipes/", 0) == 0 && stem(path) == "live";
}

/// What the indexes are made from: the pages, the tables of failing cases, recipes and tests.
struct House
{
  std::vector<TextFile> pages;
  std::vector<TextFile> tables;
  std::vector<TextFile> recipes;
  std::vector<TextFile> tests;
  std::vector<TextFile> live;
};

/// Reads the house below `root`.
inline House read_house(const std::filesystem::path& root)
{
  House house{
      read_tree(root, "chapters", {".md"}),
      read_tree(root, "chapters/figures", {".html"}),
      read_tree(root, "recipes", {".hpp", ".cpp", ".expected"}),
      read_tree(root, "tests", {".cpp"}),
      {}};
  const auto unnumbered = [](const TextFile& file) { return chapter_of(file.path).empty(); };
  std::erase_if(house.pages, unnumbered);
  std::erase_if(house.recipes, [](const TextFile& file) { return is_example(file.path); });
  std::copy_if(
      house.recipes.begin(), house.recipes.end(), std::back_inserter(house.live),
      [](const TextFile& file) { return is_live(file.path) && file.path.ends_with(".cpp"); });
  std::erase_if(house.recipes, [](const TextFile& file) { return is_live(file.path); });
  std::erase_if(house.tests, unnumbered);
  return house;
}

/// Orders ids by letters, then by number: S2 before S11.
struct ById
{
  static std::tuple<std::string, std::size_t, std::string> key(const std::string& id)
  {
    const std::size_t digits = std::min(id.find_first_of("0123456789"), id.size());
    return {id.substr(0, digits), id.size(), id};
  }
  bool operator()(const std::string& a, const std::string& b) const { return key(a) < key(b); }
};

/// The text of a page with the characters escaped that Doxygen or HTML would take for its own.
inline std::string escaped(const std::string& text)
{
  static const std::map<char, std::string> marks{
      {'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'@', "\\@"}, {'#', "\\#"},
      {'%', "\\%"},  {'*', "\\*"},  {'_', "\\_"},   {'`', "\\`"}, {'\\', "\\\\"}};
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    // In a C++ string a quotation mark is written \".
    const bool quoted = text[i] == '\\' && i + 1 < text.size() && text[i + 1] == '"';
    const auto mark = marks.find(text[i]);
    result += quoted ? "" : mark != marks.end() ? mark->second : std::string(1, text[i]);
  }
  return result;
}

/// The title and id of a page's heading, which is its first line.
inline Section title_of(const TextFile& page)
{
  const auto all = sections(page.text.substr(0, page.text.find('\n')));
  if (all.empty() || all.front().id.empty())
  {
    throw std::runtime_error(page.path + ": the first line has to be a heading with an id, {#ch3}");
  }
  return all.front();
}

/// The name of the page that lists a recipe's files in full.
inline std::string listing_id(const std::string& stem)
{
  return "files_" + stem;
}

/// A link to the listing of the test file at `path`.
inline std::string test_link(const std::string& path)
{
  std::string recipe = stem(path);
  recipe.erase(recipe.rfind("_test"));
  return "\\ref " + listing_id(recipe) + " \"" + recipe + "_test.cpp\"";
}

/// The tests that carry each tag, as a list in one cell of a table.
inline std::map<std::string, std::string> tests_by_tag(const std::vector<TextFile>& files)
{
  std::map<std::string, std::string> cells;
  for (const TextFile& file : files)
  {
    for (const Test& test : tests(file))
    {
      for (const std::string& tag : test.tags)
      {
        cells[tag] += "<li>" + escaped(test.name) + " (" + test_link(file.path) + ")</li>";
      }
    }
  }
  return cells;
}

/// Puts `\anchor S1` before each formula with `\tag{S1}`, so that indexes and pages can link to
/// it; the lines keep their numbers. An anchor that is there already is left alone.
inline std::string with_anchors(const std::string& page)
{
  std::string result;
  std::size_t done = 0;
  for (std::size_t open = page.find("\\f["); open != std::string::npos;
       open = page.find("\\f[", done))
  {
    const std::size_t close = std::min(page.find("\\f]", open), page.size());
    result += page.substr(done, open - done);
    for (const std::string& id : formula_ids(page.substr(open, close - open)))
    {
      const bool there = page.find("\\anchor " + id + "\n") != std::string::npos;
      result += is_formula_id(id) && !there ? "\\anchor " + id + " " : "";
    }
    result += page.substr(open, close - open);
    done = close;
  }
  return result + page.substr(done);
}

/// A source with its marks `// [S1]` renamed to `// [mark S1]`: Doxygen would also take the tag
/// of a test, "[S1]", for a mark.
inline std::string with_marks(const std::string& source)
{
  return std::regex_replace(
      source, std::regex(R"((^|\n)// \[([^\]\n]+)\](?=\n|$))"), "$1// [mark $2]");
}

/// A source without its marks.
inline std::string without_marks(const std::string& source)
{
  return std::regex_replace(source, std::regex(R"((^|\n)// \[[^\]\n]+\](?=\n|$))"), "");
}

/// A page as Doxygen reads it: a table of contents under the title where there are sections to
/// list, the links to its neighbours at both ends, anchors at formulas, and snippets that ask for
/// the renamed marks.
inline std::string prepared(const std::string& page, const std::string& neighbours)
{
  static const std::regex snippet(R"(([\\@]snippet(?:lineno)?[ \t]+\S+[ \t]+)(\S))");
  std::string result = std::regex_replace(with_anchors(page), snippet, "$1mark $2");
  const std::size_t blank = result.find("\n\n");
  if (blank != std::string::npos)
  {
    const std::string contents = sections(page).size() > 5 ? "\\tableofcontents" : "";
    result.insert(blank + 1, contents + neighbours);
    result += neighbours.empty() ? "" : "\n" + neighbours + "\n";
  }
  return result;
}

} // namespace cookbook::book
