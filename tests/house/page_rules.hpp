/// \file
/// The rules of the house about a page: its sections, and that nothing on it is typed.
#pragma once

#include "rules.hpp"

namespace cookbook::house
{

/// The words every chapter's page is divided by, in this order.
inline const std::vector<std::string> opening{"What you need", "What this scene needs"};
inline const std::vector<std::string> closing{
    "Where it breaks", "Speed against accuracy", "Exercises", "Sources"};
/// What every recipe's section holds, in this order: the way in first.
inline const std::vector<std::string> recipe_parts{"The idea", "Code", "Run it", "Proof"};
/// The same where it is derived after it has been run.
inline const std::vector<std::string> parts_with_why{"The idea", "Code", "Run it", "Why", "Proof"};

/// True if `words` all occur in `all`, in that order.
inline bool in_order(const std::vector<std::string>& words, const std::vector<std::string>& all)
{
  auto place = all.begin();
  for (const std::string& word : words)
  {
    place = std::find(place, all.end(), word);
    if (place == all.end())
    {
      return false;
    }
    ++place;
  }
  return true;
}

/// The pages of whole chapters: each with the text of its sub-pages behind it, as they are read.
///
/// `pages` come in the book's order: a chapter's first page, then those it opens by `\subpage`.
inline std::vector<TextFile> with_sub_pages(const std::vector<TextFile>& pages)
{
  std::vector<TextFile> chapters;
  for (const TextFile& page : pages)
  {
    const std::string chapter = book::chapter_of(page.path);
    if (!chapters.empty() && book::chapter_of(chapters.back().path) == chapter)
    {
      chapters.back().text += "\n" + page.text;
    }
    else
    {
      chapters.push_back(page);
    }
  }
  return chapters;
}

/// True if `parts`, the headings of a section, are those of a recipe's in the right order.
inline bool has_recipe_parts(const std::vector<std::string>& parts)
{
  const bool why = std::find(parts.begin(), parts.end(), "Why") != parts.end();
  return in_order(why ? parts_with_why : recipe_parts, parts);
}

/// True if a section with these headings and this text is a recipe's: it has one of the parts, or
/// shows what a program prints.
inline bool is_recipe(const std::vector<std::string>& parts, const std::string& text)
{
  static const std::set<std::string> all{"The idea", "Formula", "Code", "Run it", "Why", "Proof"};
  const auto is_part = [](const std::string& title) { return all.count(title) == 1; };
  return std::any_of(parts.begin(), parts.end(), is_part) ||
         std::regex_search(text, std::regex(R"([\\@]include +\S+\.expected)"));
}

/// A chapter's page has its sections in order, and all parts in each recipe's section.
inline Complaints page_is_in_order(const TextFile& page)
{
  Complaints complaints;
  std::vector<std::string> headings;
  std::map<std::string, std::vector<std::string>> parts;
  std::map<std::string, std::string> texts;
  for (const book::Section& section : book::sections(page.text))
  {
    if (section.level == 2)
    {
      headings.push_back(section.title);
    }
    else if (section.level == 3 && !headings.empty())
    {
      parts[headings.back()].push_back(section.title);
    }
    if (!headings.empty())
    {
      texts[headings.back()] += section.text;
    }
  }
  std::vector<std::string> fixed = opening;
  fixed.insert(fixed.end(), closing.begin(), closing.end());
  const bool framed = headings.size() >= fixed.size() &&
                      std::equal(opening.begin(), opening.end(), headings.begin()) &&
                      std::equal(closing.rbegin(), closing.rend(), headings.rbegin());
  if (!framed)
  {
    complaints.push_back(page.path + ": sections are missing or out of order");
  }
  for (const std::string& heading : headings)
  {
    const bool own = std::find(fixed.begin(), fixed.end(), heading) == fixed.end();
    const bool recipe = own && is_recipe(parts[heading], texts[heading]);
    if (recipe && !has_recipe_parts(parts[heading]))
    {
      complaints.push_back(
          page.path + ": \"" + heading +
          "\" lacks The idea, Code, Run it or Proof, in this order, with Why before Proof");
    }
  }
  return complaints;
}

/// Nothing is typed on a page but commands for a shell, in blocks opened by ```sh.
inline Complaints nothing_is_typed(const TextFile& page)
{
  Complaints complaints;
  bool fenced = false, formula = false, list = false, blank = true;
  std::size_t number = 0;
  const auto complain = [&](const std::string& what)
  { complaints.push_back(page.path + ":" + std::to_string(number) + ": " + what); };
  for (const std::string& line : book::lines(page.text))
  {
    ++number;
    const std::size_t indent = line.find_first_not_of(' ');
    const bool fence = indent != std::string::npos &&
                       (line.compare(indent, 3, "```") == 0 || line.compare(indent, 3, "~~~") == 0);
    if (fence && !fenced && line.substr(indent) != "```sh")
    {
      complain("a code block that is not ```sh");
    }
    fenced ^= fence;
    if (fenced || fence)
    {
      continue;
    }
    if (std::regex_search(line, std::regex(R"([\\@](code|verbatim)\b|<pre\b)")))
    {
      complain("typed code");
    }
    if (indent == 0)
    {
      list = std::regex_search(line, std::regex(R"(^([-*+]|\d+\.)\s)"));
    }
    if (blank && !list && !formula && indent != std::string::npos && indent >= 4)
    {
      complain("an indented code block");
    }
    formula = (formula || line.find("\\f[") != std::string::npos) &&
              line.find("\\f]") == std::string::npos;
    blank = indent == std::string::npos;
  }
  return complaints;
}

/// Every live.cpp is built for the book, and stands on a page.
inline Complaints
live_figures_are_shown(const std::vector<TextFile>& tree, const std::vector<TextFile>& pages)
{
  const auto anywhere = [](const std::vector<TextFile>& files, const std::string& words)
  {
    return std::any_of(
        files.begin(), files.end(),
        [&](const TextFile& file) { return file.text.find(words) != std::string::npos; });
  };
  Complaints complaints;
  for (const TextFile& file : tree)
  {
    if (!file.path.ends_with("/live.cpp"))
    {
      continue;
    }
    const std::string folder = file.path.substr(0, file.path.rfind('/'));
    const std::string name = folder.substr(folder.rfind('/') + 1);
    if (!anywhere(pages, "\\live{" + name + "}"))
    {
      complaints.push_back(file.path + " is on no page");
    }
    if (!anywhere(tree, "cookbook_live(" + name))
    {
      complaints.push_back(file.path + " has no cookbook_live in its chapter's CMakeLists.txt");
    }
  }
  return complaints;
}

} // namespace cookbook::house
