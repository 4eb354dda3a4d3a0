/// \file
/// Finds what Doxygen does not: `book_check HTML MATHJAX` fails on a missing figure, a dead link,
/// a request that would leave the machine, and TeX that MathJax would refuse.

#include "docs/index/scan.hpp"

#include <iostream>
#include <map>
#include <set>

namespace
{

using namespace cookbook::book;
namespace fs = std::filesystem;

int complaints = 0;

void complain(const std::string& page, const std::string& what)
{
  std::cerr << page << ": " << what << '\n';
  ++complaints;
}

std::set<std::string> anchors(const std::string& html)
{
  const auto ids = matches(html, R"rx( (?:id|name)="([^"]+)")rx");
  return {ids.begin(), ids.end()};
}

bool is_remote(const std::string& address)
{
  return std::regex_search(address, std::regex("^(https?:)?//"));
}

std::string unescaped(std::string text)
{
  const std::pair<const char*, const char*> marks[] = {
      {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"%20", " "}, {"&amp;", "&"}};
  for (const auto& [mark, meaning] : marks)
  {
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1))
    {
      text.replace(at, std::string(mark).size(), meaning);
    }
  }
  return text;
}

/// What a page loads by itself must lie beside it; a link inside the book must lead somewhere.
void check_links(
    const std::string& name, const std::string& html, const fs::path& folder,
    const std::map<std::string, std::set<std::string>>& targets)
{
  for (
      const std::string& loaded : matches(
          html,
          R"rx(<(?:script|img|iframe|embed|link|object|source)\b[^>]*? (?:src|href|data)="([^"]*)")rx"))
  {
    if (loaded.starts_with("data:") || loaded.starts_with("javascript:"))
    {
      continue; // it stands in the page itself
    }
    if (is_remote(loaded) || !fs::exists(folder / loaded.substr(0, loaded.find('?'))))
    {
      complain(name, (is_remote(loaded) ? "loads from the net: " : "missing: ") + loaded);
    }
  }
  for (const std::string& link : matches(html, R"rx(<a\b[^>]*? href="([^"]*)")rx"))
  {
    if (std::regex_search(link, std::regex("^(https?|mailto|javascript):")))
    {
      continue;
    }
    const std::size_t hash = std::min(link.find('#'), link.size());
    const std::string file = hash == 0 ? name : unescaped(link.substr(0, hash));
    const std::string anchor = hash < link.size() ? unescaped(link.substr(hash + 1)) : "";
    const auto target = targets.find(file);
    // Doxygen links to a summary of nested types even where all are private.
    const bool there = target == targets.end() ? anchor.empty() && fs::exists(folder / file)
                                               : anchor.empty() || anchor == "nested-classes" ||
                                                     target->second.count(anchor) == 1;
    if (!there)
    {
      complain(name, "dead link: " + link);
    }
  }
}

/// The commands MathJax knows: the keys of the tables in its own files.
std::set<std::string> tex_commands(const fs::path& mathjax)
{
  std::set<std::string> known{"begin", "end", "left", "right", "middle", "tag", "(", ")", "[", "]"};
  for (const char* file :
       {"jax/input/TeX/jax.js", "extensions/TeX/AMSmath.js", "extensions/TeX/AMSsymbols.js"})
  {
    for (const std::string& key :
         matches(read_text(mathjax / file), R"rx([{,]\s*"?(?:\\\\)?([A-Za-z]+)"?\s*:)rx"))
    {
      known.insert(key);
    }
  }
  return known;
}

/// Complains about unknown commands and about braces, environments and fences left open.
void check_tex(const std::string& name, const std::string& tex, const std::set<std::string>& known)
{
  int depth = 0;
  int fences = 0;
  std::vector<std::string> environments;
  bool closed = true;
  for (std::size_t i = 0; i < tex.size(); ++i)
  {
    depth += tex[i] == '{' ? 1 : tex[i] == '}' ? -1 : 0;
    closed = closed && depth >= 0 && fences >= 0;
    std::smatch match;
    const std::string rest = tex[i] == '\\' ? tex.substr(i + 1, 60) : "";
    if (std::regex_search(rest, match, std::regex(R"(^(begin|end)\{([^}]*)\})")))
    {
      if (match.str(1) == "begin")
      {
        environments.push_back(match.str(2));
      }
      else if (closed = closed && !environments.empty() && environments.back() == match.str(2);
               closed)
      {
        environments.pop_back();
      }
    }
    if (std::regex_search(rest, match, std::regex("^[A-Za-z]+")))
    {
      fences += match.str() == "left" ? 1 : match.str() == "right" ? -1 : 0;
      if (known.count(match.str()) == 0)
      {
        complain(name, "unknown TeX command \\" + match.str() + " in " + tex);
      }
      i += match.str().size();
    }
    else if (tex[i] == '\\')
    {
      ++i; // an escaped character: \{ opens nothing
    }
  }
  if (!closed || depth != 0 || fences != 0 || !environments.empty())
  {
    complain(name, "unbalanced TeX: " + tex);
  }
}

void check_formulas(
    const std::string& name, const std::string& html, const std::set<std::string>& known)
{
  for (const auto& [open, close] : {std::pair{"\\(", "\\)"}, std::pair{"\\[", "\\]"}})
  {
    std::size_t start = html.find(open);
    while (start != std::string::npos)
    {
      const std::size_t end = html.find(close, start + 2);
      if (end == std::string::npos)
      {
        break;
      }
      check_tex(name, unescaped(html.substr(start + 2, end - start - 2)), known);
      start = html.find(open, end);
    }
  }
}

} // namespace

int main(int argc, char** argv)
try
{
  if (argc != 3)
  {
    throw std::runtime_error("usage: book_check HTML MATHJAX");
  }
  const fs::path folder = argv[1];
  const std::set<std::string> known = tex_commands(argv[2]);
  std::map<std::string, std::string> pages;
  std::map<std::string, std::set<std::string>> targets;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    if (entry.path().extension() == ".html")
    {
      const std::string name = entry.path().filename().string();
      pages[name] = read_text(entry.path());
      targets[name] = anchors(pages[name]);
    }
  }
  for (const auto& [name, html] : pages)
  {
    check_links(name, html, folder, targets);
    check_formulas(name, html, known);
  }
  std::cout << pages.size() << " pages, " << complaints << " complaints\n";
  return complaints == 0 && !pages.empty() ? 0 : 1;
}
catch (const std::exception& error)
{
  std::cerr << "book_check: " << error.what() << '\n';
  return 1;
}
