/// \file
/// The rules of the house about reading: how long a page may be, and what stands between listings.
#pragma once

#include "recipe_rules.hpp"

namespace cookbook::house
{

/// What a page asks of its reader: words of prose, and lines of listings that are not folded.
struct PageSize
{
  std::size_t words = 0;
  std::size_t lines = 0;
};

/// What a page may have at most.
inline constexpr PageSize most{2800, 450};

/// A page cut at its folds: pieces that are shown, and between them those in
/// `<details class="more">`.
inline std::vector<std::string> pieces_by_folds(const std::string& page)
{
  std::vector<std::string> pieces(1);
  for (const std::string& line : book::lines(page))
  {
    const bool opens = line.find("<details class=\"more\">") != std::string::npos;
    const bool closes = line.find("</details>") != std::string::npos && pieces.size() % 2 == 0;
    if (opens || closes)
    {
      pieces.emplace_back();
    }
    pieces.back() += line + "\n";
  }
  return pieces;
}

/// The words of a page: without formulas, commands, code, anchors and tags of HTML.
inline std::size_t count_words(const std::string& page)
{
  static const std::regex unread(
      R"(\\f\[[^]*?\\f\]|\\f\$[^]*?\\f\$|```[^]*?```|<[^>]*>|\{#[^}]*\}|`[^`]*`)"
      R"(|[\\@](?:snippet|include|htmlinclude)[^\n]*|[\\@](?:ref|subpage|anchor) +\w+|[\\@]\w+)");
  const std::string read = std::regex_replace(page, unread, " ");
  return book::matches(read, "([A-Za-z][^\\s]*)").size();
}

/// The lines that Doxygen shows for `\snippet file tag`, or `\include file` where `tag` is empty.
inline std::size_t
count_lines(const std::vector<TextFile>& tree, const std::string& file, const std::string& tag)
{
  std::size_t count = 0;
  bool inside = tag.empty();
  for (const TextFile* source : ending_in(tree, file))
  {
    for (const std::string& line : book::lines(source->text))
    {
      const bool mark = line == "// [" + tag + "]";
      inside ^= mark;
      count += inside && !mark && line.rfind("// [", 0) != 0 ? 1 : 0;
    }
  }
  return count;
}

/// The size of a page; `tree` holds the files that it shows.
inline PageSize size_of(const std::string& page, const std::vector<TextFile>& tree)
{
  static const std::regex command(R"([\\@](snippet|include)(?:lineno)?[ \t]+(\S+)[ \t]*(.*))");
  PageSize size{count_words(page), 0};
  const auto pieces = pieces_by_folds(page);
  for (std::size_t shown = 0; shown < pieces.size(); shown += 2)
  {
    for (const std::string& line : book::lines(pieces[shown]))
    {
      std::smatch match;
      if (std::regex_match(line, match, command))
      {
        size.lines += count_lines(tree, match.str(2), match.str(3));
      }
    }
  }
  return size;
}

/// No page has more words or lines of listings than a reader has patience for.
inline Complaints
pages_are_short(const std::vector<TextFile>& pages, const std::vector<TextFile>& tree)
{
  Complaints complaints;
  for (const TextFile& page : pages)
  {
    const PageSize size = size_of(page.text, tree);
    const auto compare = [&](std::size_t count, std::size_t may_be, const std::string& what)
    {
      if (count > may_be)
      {
        complaints.push_back(
            page.path + ": " + std::to_string(count) + " " + what + ", at most " +
            std::to_string(may_be));
      }
    };
    compare(size.words, most.words, "words");
    compare(size.lines, most.lines, "lines of listings");
  }
  return complaints;
}

/// Between two listings there is a sentence that says what the second one shows.
inline Complaints listings_are_introduced(const TextFile& page)
{
  static const std::regex listing(R"([\\@](?:snippet|include)\b.*)");
  static const std::regex silent(
      R"(\s*|#.*|</?(?:details|div)\b[^>]*>\s*|<summary>.*</summary>\s*)");
  Complaints complaints;
  bool introduced = true;
  std::size_t number = 0;
  for (const std::string& line : book::lines(page.text))
  {
    ++number;
    if (!std::regex_match(line, listing))
    {
      introduced = introduced || !std::regex_match(line, silent);
      continue;
    }
    if (!introduced)
    {
      complaints.push_back(
          page.path + ":" + std::to_string(number) + ": no sentence before this listing");
    }
    introduced = false;
  }
  return complaints;
}

/// A page ends with exercises, numbered, and each names what turns red or green: a test, a command.
inline Complaints page_has_exercises(const TextFile& page)
{
  Complaints complaints;
  std::size_t exercises = 0;
  for (const book::Section& section : book::sections(page.text))
  {
    const std::string text = section.title == "Exercises" ? "\n" + section.text : "";
    for (const std::string& exercise : book::matches(text, R"(\n\d+\. ([^\n]*(?:\n +[^\n]*)*))"))
    {
      ++exercises;
      if (exercise.find('`') == std::string::npos)
      {
        complaints.push_back(page.path + ": no test or command in the exercise " + exercise);
      }
    }
  }
  if (exercises == 0)
  {
    complaints.push_back(page.path + ": no exercises");
  }
  return complaints;
}

} // namespace cookbook::house
