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
/// What every recipe's section holds, in this order.
inline const std::vector<std::string> recipe_parts{"Formula", "Code", "Run it", "Proof"};

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
/// `pages` come in order of path: 05_resolution.md, then its sub-page 05_resolution_bodies.md.
inline std::vector<TextFile> with_sub_pages(const std::vector<TextFile>& pages)
{
  std::vector<TextFile> chapters;
  for (const TextFile& page : pages)
  {
    const std::string name = book::stem(page.path);
    if (!chapters.empty() && name.rfind(book::stem(chapters.back().path) + "_", 0) == 0)
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

/// A chapter's page has its sections in order, and all four parts in each recipe's section.
inline Complaints page_is_in_order(const TextFile& page)
{
  Complaints complaints;
  std::vector<std::string> headings;
  std::map<std::string, std::vector<std::string>> parts;
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
    const bool recipe = std::find(fixed.begin(), fixed.end(), heading) == fixed.end();
    if (recipe && !in_order(recipe_parts, parts[heading]))
    {
      complaints.push_back(
          page.path + ": \"" + heading + "\" lacks Formula, Code, Run it or Proof, in this order");
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

} // namespace cookbook::house
