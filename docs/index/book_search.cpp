/// \file
/// Writes what the book's search box looks through: `book_search ROOT TAGS OUT`. Of each section
/// its heading, bold terms and prose, from the pages; and the names of the code, from Doxygen's
/// TAGS.

#include "docs/index/order.hpp"

#include <iostream>
#include <set>

namespace
{

using namespace cookbook::book;

/// A string of a script, in quotation marks.
std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text)
  {
    result +=
        c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c < ' ' && c >= 0 ? ' ' : c);
  }
  return result + "\"";
}

std::string replaced(const std::string& text, const char* pattern, const char* by)
{
  return std::regex_replace(text, std::regex(pattern), by);
}

/// What a reader sees of a page's text, in words: no formulas, commands, listings and tags.
std::string words(std::string text)
{
  static const std::pair<const char*, const char*> steps[] = {
      {R"(```[^`]*```)", " "},                                        // commands
      {R"(\\f\[[^]*?\\f\]|\\f\$[^]*?\\f\$)", " "},                    // formulas
      {R"([\\@](?:snippet|include|htmlinclude|anchor)\b[^\n]*)", ""}, // listings, figures
      {R"rx([\\@](?:ref|subpage)\s+\w+(?:\s+"([^"]*)")?)rx", "$1"},   // links
      {R"([\\@](?:note|remark|attention|warning|htmlonly\S*|endhtmlonly|tableofcontents)\b)", ""},
      {R"(!?\[([^\]]*)\]\([^)]*\))", "$1"},
      {R"([*`])", ""},
      {R"(<[^>]*>|\|?(?:-{3,}\|?)+|\|)", " "},
      {R"(&[a-z]+;|\s+)", " "}};
  for (const auto& [pattern, by] : steps)
  {
    text = replaced(text, pattern, by);
  }
  return replaced(text, "^ | $", "");
}

/// The terms in bold, each once.
std::string bold_terms(const std::string& text)
{
  std::string joined;
  std::set<std::string> seen;
  for (const std::string& term : matches(text, R"(\*\*([^*]+)\*\*)"))
  {
    joined += seen.insert(term).second ? (joined.empty() ? "" : "|") + words(term) : "";
  }
  return joined;
}

/// One row for each section with an id: address, page, the heading above, its own, bold terms, code
/// that it shows, prose. What follows a heading without one belongs to the section before it; a
/// recipe's name is a term of the section that runs it.
std::string section_rows(const TextFile& page)
{
  struct Row
  {
    std::string place, above, heading, terms, shown, text;
  };
  std::vector<Row> rows;
  std::size_t second = 0; // the last row with a heading of level 2
  const Section title = title_of(page);
  for (const Section& section : sections(page.text))
  {
    if (section.id.empty())
    {
      rows.back().text += section.title + ".\n" + section.text;
      continue;
    }
    second = section.level <= 2 ? rows.size() : second;
    const std::string above = section.level <= 2 ? "" : rows[second].heading;
    rows.push_back({section.id, above, words(section.title), "", "", section.text});
    for (const std::string& name : matches(section.text, R"(\./cookbook run (\w+))"))
    {
      rows[second].terms += name + "|";
    }
    for (const std::string& mark : matches(section.text, R"([\\@]snippet\s+\S+\.hpp\s+(\w+))"))
    {
      rows.back().shown += mark + "|";
    }
  }
  const std::string file = title.id == "mainpage" ? "index.html" : title.id + ".html";
  std::string result;
  for (const Row& row : rows)
  {
    const std::string place = row.place == title.id ? file : file + "#" + row.place;
    result += "[";
    for (const std::string& cell :
         {place, words(title.title), row.above, row.heading, row.terms + bold_terms(row.text),
          row.shown})
    {
      result += quoted(cell) + ",";
    }
    result += quoted(words(row.text)) + "],\n";
  }
  return result;
}

/// One row for each name of the code: name, kind, address; overloads on one page once.
std::string name_rows(const std::string& tags)
{
  static const std::regex compound(
      R"rx(<compound kind="(struct|class|concept)"[^>]*>\s*<name>(?:\w+::)*(\w+)[^<]*</name>\s*<filename>([^<]+)</filename>)rx");
  static const std::regex member(
      R"rx(<member kind="(function|variable|typedef|enumeration)"[^>]*>[^]*?<name>(\w+)</name>\s*<anchorfile>([^<]+)</anchorfile>\s*<anchor>(\w+)</anchor>)rx");
  std::string result;
  std::set<std::string> seen;
  const auto add = [&](const std::string& name, const std::string& kind, const std::string& place)
  {
    if (seen.insert(name + place.substr(0, place.find('#'))).second)
    {
      result += "[" + quoted(name) + "," + quoted(kind) + "," + quoted(place) + "],\n";
    }
  };
  for (std::sregex_iterator at(tags.begin(), tags.end(), compound), end; at != end; ++at)
  {
    add(at->str(2), at->str(1), at->str(3));
  }
  for (std::sregex_iterator at(tags.begin(), tags.end(), member), end; at != end; ++at)
  {
    add(at->str(2), at->str(1), at->str(3) + "#" + at->str(4));
  }
  return result;
}

} // namespace

int main(int argc, char** argv)
try
{
  if (argc != 4)
  {
    throw std::runtime_error("usage: book_search ROOT TAGS OUT");
  }
  std::string rows;
  for (const TextFile& page : book_pages(argv[1]))
  {
    rows += section_rows(page);
  }
  std::ofstream out(argv[3], std::ios::binary);
  out << "const bookSections = [\n"
      << rows << "];\nconst bookNames = [\n"
      << name_rows(read_text(argv[2])) << "];\n";
  if (!out.flush())
  {
    throw std::runtime_error(std::string("cannot write ") + argv[3]);
  }
  return 0;
}
catch (const std::exception& error)
{
  std::cerr << "book_search: " << error.what() << '\n';
  return 1;
}
