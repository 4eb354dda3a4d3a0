/// \file
/// What a page gets without being typed: the links to its neighbours, and the heads of its
/// listings.
#pragma once

#include "docs/index/pages.hpp"

namespace cookbook::book
{

/// Puts the page `id` and then all that it opens by `\subpage` behind `order`.
inline void add_in_order(
    const std::vector<TextFile>& pages, const std::string& id, std::vector<TextFile>& order)
{
  for (const TextFile& page : pages)
  {
    if (title_of(page).id == id)
    {
      order.push_back(page);
      for (const std::string& next : matches(page.text, R"([\\@]subpage +(\w+))"))
      {
        add_in_order(pages, next, order);
      }
    }
  }
}

/// The pages in the order in which the book is read; `id` is its first page.
inline std::vector<TextFile>
reading_order(const std::vector<TextFile>& pages, const std::string& id)
{
  std::vector<TextFile> order;
  add_in_order(pages, id, order);
  return order;
}

/// The book's pages that are written by hand, from its front page to its last.
inline std::vector<TextFile> book_pages(const std::filesystem::path& root)
{
  std::vector<TextFile> pages = read_tree(root, "chapters", {".md"});
  for (const TextFile& page : read_tree(root, "docs", {".md"}))
  {
    pages.push_back(page);
  }
  return reading_order(pages, "mainpage");
}

/// A link to the page before and one to the page behind the one at `path`; none for a page that
/// belongs to no chapter.
inline std::string neighbour_links(const std::vector<TextFile>& order, const std::string& path)
{
  const auto link = [](const TextFile& page, const std::string& side)
  {
    const Section title = title_of(page);
    const std::string file = title.id == "mainpage" ? "index" : title.id;
    return "<a class=\"" + side + "\" href=\"" + file + ".html\">" + escaped(title.title) + "</a>";
  };
  for (std::size_t i = 1; i < order.size() && !chapter_of(path).empty(); ++i)
  {
    if (order[i].path == path)
    {
      const std::string next = i + 1 < order.size() ? link(order[i + 1], "next") : "";
      return "<div class=\"neighbours\">" + link(order[i - 1], "previous") + next + "</div>";
    }
  }
  return "";
}

/// The id of the place in a recipe's listing where the file called `name` is shown.
inline std::string listing_place(const std::string& name)
{
  const auto ends_in = [&](const std::string& ending)
  { return name.size() > ending.size() && name.ends_with(ending); };
  const std::string of_tests = "_test.cpp";
  if (ends_in(of_tests))
  {
    return listing_id(name.substr(0, name.size() - of_tests.size())) + "_tests";
  }
  return listing_id(stem(name)) + (ends_in(".hpp")   ? "_header"
                                   : ends_in(".cpp") ? "_program"
                                                     : "_output");
}

/// What to link to for the file at `path`: its place in a recipe's listing, or the header's own
/// page; empty where no page shows it.
inline std::string shown_at(const std::string& path)
{
  const std::string name = std::filesystem::path(path).filename().string();
  const bool in_recipe =
      !is_example(path) && !is_live(path) &&
      std::regex_search(path, std::regex(R"(^recipes/\d.*\.(hpp|cpp|expected)$)"));
  const bool tests = std::regex_search(path, std::regex(R"(^tests/\d.*_test\.cpp$)"));
  const bool shared = std::regex_search(path, std::regex(R"(^(common|tools)/.*\.hpp$)"));
  return in_recipe || tests ? listing_place(name) : shared ? name : "";
}

/// The head of a listing of the file at `path`: its name, linked to where it is shown in full.
inline std::string listing_head(const std::string& path)
{
  const std::string name = std::filesystem::path(path).filename().string();
  const std::string target = shown_at(path);
  return "<div class=\"listing\">" +
         (target.empty() ? escaped(name) : "\\ref " + target + " \"" + name + "\"") +
         (name.ends_with(".expected") ? " &middot; what it prints" : "") + "</div>";
}

/// Heads each `\snippet` and `\include` of a page; `paths` are the files of the tree. The lines
/// keep their numbers.
inline std::string with_heads(const std::string& page, const std::vector<std::string>& paths)
{
  static const std::regex command(R"([\\@](?:snippet(?:lineno)?|include)[ \t]+(\S+).*)");
  std::string result;
  for (const std::string& line : lines(page))
  {
    std::smatch match;
    const auto shown = [&](const std::string& path)
    { return std::filesystem::path(path).filename() == match.str(1); };
    if (std::regex_match(line, match, command))
    {
      const auto path = std::find_if(paths.begin(), paths.end(), shown);
      result += path == paths.end() ? "" : listing_head(*path) + " ";
    }
    result += line + "\n";
  }
  return result;
}

/// Hands the tags of a fold, each on a line of its own, to the browser as they are: Doxygen would
/// begin a new fold with every paragraph.
inline std::string with_folds(const std::string& page)
{
  static const std::regex tag(
      R"((^|\n)(<details class="more">|<summary>.*?</summary>|</details>)(?=\n|$))");
  return std::regex_replace(page, tag, "$1\\htmlonly[block]$2\\endhtmlonly");
}

/// Puts a link that a line's end cuts in two on the first of its lines: Doxygen reads links by
/// lines.
inline std::string with_whole_links(const std::string& page)
{
  static const std::regex in_text(R"rx((\\ref +\w+ +"[^"\n]*)\n *([^"\n]*"))rx");
  static const std::regex in_name(R"rx(\\ref *\n *(\w+(?: +"[^"\n]*")?))rx");
  return std::regex_replace(std::regex_replace(page, in_name, "\\ref $1\n"), in_text, "$1 $2\n");
}

/// The paths, from `root`, of all files that a page may show.
inline std::vector<std::string> shown_paths(const std::filesystem::path& root)
{
  std::vector<std::string> paths;
  for (const char* part : {"common", "tools", "recipes", "tests"})
  {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / part))
    {
      if (entry.is_regular_file())
      {
        paths.push_back(entry.path().lexically_relative(root).generic_string());
      }
    }
  }
  return paths;
}

} // namespace cookbook::book
