/// \file
/// Reads the house's own text: headings and formulas of pages, names and tags of tests.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace cookbook::book
{

/// A file of the tree: its path from the root, with forward slashes, and its text.
struct TextFile
{
  std::string path;
  std::string text;
};

/// A heading of a page and the text that follows it, up to the next heading of any level.
struct Section
{
  std::size_t level;
  std::string title;
  std::string id;
  std::string text;
};

/// A Catch2 test case: where it stands, its name and its tags, without the brackets.
struct Test
{
  std::string path;
  std::string name;
  std::vector<std::string> tags;
};

/// Reads one whole file; throws std::runtime_error naming it if it cannot be read.
inline std::string read_text(const std::filesystem::path& path)
{
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf()))
  {
    // An empty file also ends here: streaming nothing sets the failure bit.
    if (std::filesystem::is_regular_file(path) && std::filesystem::file_size(path) == 0)
    {
      return {};
    }
    throw std::runtime_error("cannot read " + path.string());
  }
  return text.str();
}

/// Reads every file below `root/folder` with one of the `extensions`, in order of path.
inline std::vector<TextFile> read_tree(
    const std::filesystem::path& root, const std::string& folder,
    const std::vector<std::string>& extensions)
{
  namespace fs = std::filesystem;
  std::vector<TextFile> files;
  if (!fs::is_directory(root / folder))
  {
    return files;
  }
  for (const auto& entry : fs::recursive_directory_iterator(root / folder))
  {
    const std::string extension = entry.path().extension().string();
    const bool wanted =
        std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
    if (entry.is_regular_file() && wanted)
    {
      files.push_back(
          {entry.path().lexically_relative(root).generic_string(), read_text(entry.path())});
    }
  }
  std::sort(
      files.begin(), files.end(),
      [](const TextFile& a, const TextFile& b) { return a.path < b.path; });
  return files;
}

/// Returns group `group` of every match of `pattern` in `text`, in order.
inline std::vector<std::string>
matches(const std::string& text, const std::string& pattern, std::size_t group = 1)
{
  static std::map<std::string, std::regex> compiled; // each pattern once
  const std::regex& expression = compiled.try_emplace(pattern, pattern).first->second;
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
  {
    found.push_back(match->str(group));
  }
  return found;
}

/// Splits text into lines, without their ends.
inline std::vector<std::string> lines(const std::string& text)
{
  std::vector<std::string> result;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
  {
    result.push_back(line);
  }
  return result;
}

/// The file name without folder and extension: `recipes/03_x/friction.hpp` gives friction.
inline std::string stem(const std::string& path)
{
  return std::filesystem::path(path).stem().string();
}

/// The name of the chapter's folder in a path: 03_sphere_manifolds; empty if there is none.
inline std::string chapter_folder(const std::string& path)
{
  const auto folders = matches(path, R"((?:^|/)(\d\d_\w+)/)");
  return folders.empty() ? std::string{} : folders.front();
}

/// The chapter a path belongs to, the two digits that open one of its parts; empty if none do.
inline std::string chapter_of(const std::string& path)
{
  const auto numbers = matches(path, R"((?:^|/)(\d\d)_)");
  return numbers.empty() ? std::string{} : numbers.front();
}

/// The headings of a page (`## Title {#id}`) in order; the title of the page has level 1.
inline std::vector<Section> sections(const std::string& page)
{
  static const std::regex heading(R"(^(#+)\s+(.*?)\s*(?:\{#([\w-]+)\})?\s*$)");
  std::vector<Section> found;
  bool fenced = false;
  for (const std::string& line : lines(page))
  {
    fenced ^= line.rfind("```", 0) == 0;
    std::smatch match;
    if (!fenced && std::regex_match(line, match, heading))
    {
      found.push_back({match.str(1).size(), match.str(2), match.str(3), {}});
    }
    else if (!found.empty())
    {
      found.back().text += line + "\n";
    }
  }
  return found;
}

/// True for what may number a formula: M1, P22, S11, O18, R34.
inline bool is_formula_id(const std::string& id)
{
  return std::regex_match(id, std::regex("[MPSORG][0-9]+"));
}

/// The ids in `\tag{...}` of a page's formulas, in order.
inline std::vector<std::string> formula_ids(const std::string& page)
{
  return matches(page, R"(\\tag\{([^}]*)\})");
}

/// The failing cases of a verdict table: what follows `id="case-`, in order.
inline std::vector<std::string> case_ids(const std::string& fragment)
{
  return matches(fragment, R"rx(id="case-([A-Za-z0-9]+)")rx");
}

/// The test cases of a source file; adjacent string literals are joined as the compiler does.
inline std::vector<Test> tests(const TextFile& file)
{
  static const std::string literals = R"rx(((?:\s*"(?:[^"\\]|\\.)*")+))rx";
  static const std::regex test_case(
      "(?:^|\n) *(?:TEMPLATE_)?(?:TEST_CASE|SCENARIO)\\(" + literals + "(?:\\s*," + literals +
      ")?");
  const auto join = [](const std::string& text)
  {
    std::string joined;
    for (const std::string& part : matches(text, R"rx("((?:[^"\\]|\\.)*)")rx"))
    {
      joined += part;
    }
    return joined;
  };
  std::vector<Test> found;
  const std::string& text = file.text;
  for (std::sregex_iterator match(text.begin(), text.end(), test_case), end; match != end; ++match)
  {
    found.push_back(
        {file.path, join(match->str(1)), matches(join(match->str(2)), R"(\[([^\]]+)\])")});
  }
  return found;
}

} // namespace cookbook::book
