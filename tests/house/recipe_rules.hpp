/// \file
/// The rules of the house about whole recipes: their files, their snippets, their size.
#pragma once

#include "rules.hpp"

#include "docs/index/pages.hpp"

namespace cookbook::house
{

/// The paths of `files` that end in `/ending` or are `ending`.
inline std::vector<const TextFile*>
ending_in(const std::vector<TextFile>& files, const std::string& ending)
{
  std::vector<const TextFile*> found;
  for (const TextFile& file : files)
  {
    const std::string path = "/" + file.path;
    const std::string tail = "/" + ending;
    if (path.size() >= tail.size() &&
        path.compare(path.size() - tail.size(), tail.size(), tail) == 0)
    {
      found.push_back(&file);
    }
  }
  return found;
}

/// True if a section `##` of one of the chapter's pages shows code of the recipe's header.
inline bool
has_section(const std::vector<TextFile>& pages, const std::string& chapter, const std::string& stem)
{
  const std::regex snippet("[\\\\@]snippet(?:lineno)? +(?:[\\w/]*/)?" + stem + "\\.hpp");
  return std::any_of(
      pages.begin(), pages.end(),
      [&](const TextFile& page)
      {
        const std::size_t start = page.text.find("\n## ");
        return book::chapter_of(page.path) == chapter && start != std::string::npos &&
               std::regex_search(page.text.substr(start), snippet);
      });
}

/// Every example is a complete program of at most 20 lines between its marks `// [example]`, blank
/// ones not counted; a page shows it whole, and what it prints.
inline Complaints
examples_are_whole(const std::vector<TextFile>& tree, const std::vector<TextFile>& pages)
{
  Complaints complaints;
  for (const TextFile& file : tree)
  {
    if (!book::is_example(file.path) || !file.path.ends_with(".cpp"))
    {
      continue;
    }
    const std::string name = book::stem(file.path);
    const auto shown = [&](const std::string& command)
    {
      return std::any_of(
          pages.begin(), pages.end(),
          [&](const TextFile& page)
          { return page.text.find(command + "\n") != std::string::npos; });
    };
    if (!shown("\\snippet " + name + ".cpp example") || !shown("\\include " + name + ".expected"))
    {
      complaints.push_back(file.path + " or what it prints is on no page");
    }
    const auto between =
        book::matches(file.text, "\n// \\[example\\]\n([^]*?)\n// \\[example\\]\n");
    const std::string program = between.empty() ? "" : between.front();
    const auto all = book::lines(program);
    const auto blank = std::count(all.begin(), all.end(), "");
    if (program.find("int main(") == std::string::npos ||
        all.size() > 20 + static_cast<std::size_t>(blank))
    {
      complaints.push_back(file.path + " has no complete program of at most 20 lines");
    }
  }
  return complaints;
}

/// Every program but an example is a whole recipe: header, checked output (unless a chart), test,
/// section.
///
/// `tree` holds recipes/ and tests/, with the CMakeLists.txt that tell the charts.
inline Complaints
recipes_are_whole(const std::vector<TextFile>& tree, const std::vector<TextFile>& pages)
{
  Complaints complaints;
  std::set<std::string> charts;
  for (const TextFile& file : tree)
  {
    for (const std::string& name : book::matches(file.text, R"(\ncookbook_chart\(\s*(\w+))"))
    {
      charts.insert(name);
    }
  }
  for (const TextFile& file : tree)
  {
    const bool program = file.text.find("main(") != std::string::npos;
    if (!program || file.path.rfind("recipes/", 0) != 0 || book::is_example(file.path))
    {
      continue;
    }
    const std::string name = book::stem(file.path);
    const auto require = [&](bool there, const std::string& what)
    {
      if (!there)
      {
        complaints.push_back(file.path + " has no " + what);
      }
    };
    const auto exists = [&](const std::string& path)
    {
      return std::any_of(
          tree.begin(), tree.end(), [&](const TextFile& other) { return other.path == path; });
    };
    const std::filesystem::path folder = std::filesystem::path(file.path).parent_path();
    const std::string chapter = folder.parent_path().filename().string();
    const auto in_folder = [&](const std::string& one)
    { return exists((folder / one).generic_string()); };
    require(folder.filename() == name, "folder of its name");
    require(in_folder(name + ".hpp") || in_folder("trial/" + name + ".hpp"), "header");
    require(in_folder(name + ".expected") || charts.count(name) == 1, "checked output");
    require(exists("tests/" + chapter + "/" + name + "_test.cpp"), "test");
    require(has_section(pages, book::chapter_of(file.path), name), "section on its page");
  }
  return complaints;
}

/// Every `\snippet file tag` means one file, which holds the mark exactly twice.
inline Complaints
snippets_are_marked(const std::vector<TextFile>& pages, const std::vector<TextFile>& sources)
{
  static const std::regex command(
      R"([\\@]snippet(?:lineno)?(?:\{[^}]*\})?[ \t]+(\S+)[ \t]+([^\r\n]+))");
  Complaints complaints;
  for (const TextFile& page : pages)
  {
    const std::string& text = page.text;
    for (std::sregex_iterator match(text.begin(), text.end(), command), end; match != end; ++match)
    {
      std::string tag = match->str(2);
      tag.erase(tag.find_last_not_of(" \t") + 1);
      const auto files = ending_in(sources, match->str(1));
      std::size_t marks = 0;
      for (const std::string& line : files.empty() ? Complaints{} : book::lines(files[0]->text))
      {
        marks += line == "// [" + tag + "]" ? 1 : 0;
      }
      if (files.size() != 1 || marks != 2)
      {
        complaints.push_back(
            page.path + ": \\snippet " + match->str(1) + " " + tag + " finds " +
            std::to_string(files.size()) + " files and " + std::to_string(marks) + " marks");
      }
    }
  }
  return complaints;
}

/// Every piece that is marked, `// [tag]` before and after it, is shown by a `\snippet`.
inline Complaints
marks_are_shown(const std::vector<TextFile>& pages, const std::vector<TextFile>& sources)
{
  std::set<std::string> shown;
  for (const TextFile& page : pages)
  {
    for (const std::string& piece :
         book::matches(page.text, R"([\\@]snippet(?:lineno)?[ \t]+(?:\S*/)?(\S+[ \t]+\S+))"))
    {
      shown.insert(std::regex_replace(piece, std::regex("[ \t]+"), " "));
    }
  }
  std::set<std::string> missing;
  for (const TextFile& source : sources)
  {
    for (const std::string& tag : book::matches(source.text, R"((?:^|\n)// \[(\S+)\](?=\n|$))"))
    {
      const std::string file = std::filesystem::path(source.path).filename().string();
      if (shown.count(file + " " + tag) == 0)
      {
        missing.insert(source.path + ": no page shows the piece [" + tag + "]");
      }
    }
  }
  return {missing.begin(), missing.end()};
}

} // namespace cookbook::house
