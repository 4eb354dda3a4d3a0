/// \file
/// Writes what Doxygen reads beside the tree, indexes and sources: `book_index ROOT FOLDER`; or
/// prints one page prepared for it, with anchors, links and heads: `book_index ROOT PAGE.md`.

#include "docs/index/order.hpp"

#include <iostream>

namespace
{

using namespace cookbook::book;
namespace fs = std::filesystem;
using Summaries = std::map<std::string, std::string>;
using Rows = std::map<std::string, std::string, ById>;

void write(const fs::path& path, const std::string& text)
{
  std::ofstream out(path, std::ios::binary);
  if (!(out << text).flush())
  {
    throw std::runtime_error("cannot write " + path.string());
  }
}

std::string table(const std::string& head, const Rows& rows)
{
  std::string text = "<table class=\"index\">\n<tr>" + head + "</tr>\n";
  for (const auto& [id, row] : rows)
  {
    text += "<tr>" + row + "</tr>\n";
  }
  return text + "</table>\n";
}

std::string list(const std::map<std::string, std::string>& tests, const std::string& tag)
{
  const auto found = tests.find(tag);
  return found == tests.end() ? "" : "<ul>" + found->second + "</ul>";
}

/// Each numbered formula of a text, by its id, as it stands but for its number.
std::map<std::string, std::string> formulas_of(const std::string& text)
{
  std::map<std::string, std::string> found;
  for (const std::string& formula : matches(text, R"(\\f\[((?:[^\\]|\\(?!f\]))*)\\f\])"))
  {
    for (const std::string& id : formula_ids(formula))
    {
      const std::regex number(R"(\s*\\tag\{[^}]*\}\s*)");
      const std::regex space(R"(\s+)");
      found[id] = std::regex_replace(std::regex_replace(formula, number, " "), space, " ");
    }
  }
  return found;
}

std::string formulas(const House& house)
{
  const auto tests = tests_by_tag(house.tests);
  std::string text = "# Index of formulas {#formulas}\n\nEvery numbered formula of the book, and "
                     "the tests that assert it.\n\n";
  for (const TextFile& page : house.pages)
  {
    Rows rows;
    for (const auto& [id, formula] : formulas_of(page.text))
    {
      rows[id] = "<td>\\ref " + id + " \"" + id + "\"</td><td>\\f$\\displaystyle " + formula +
                 "\\f$ <details><summary>tests</summary>" + list(tests, id) + "</details></td>";
    }
    text += rows.empty() ? ""
                         : "## " + title_of(page).title + "\n\n" +
                               table("<th>Number</th><th>Formula</th>", rows) + "\n";
  }
  return text;
}

/// The ids of the pages that include a table of failing cases.
std::vector<Section> pages_with(const House& house, const TextFile& fragment)
{
  std::vector<Section> found;
  const std::string name = fragment.path.substr(fragment.path.rfind('/') + 1);
  for (const TextFile& page : house.pages)
  {
    if (page.text.find(name) != std::string::npos)
    {
      found.push_back(title_of(page));
    }
  }
  return found;
}

std::string failing_cases(const House& house)
{
  const auto tests = tests_by_tag(house.tests);
  Rows places;
  for (const auto& [tag, cell] : tests)
  {
    if (tag.rfind("case:", 0) == 0)
    {
      places[tag.substr(5)];
    }
  }
  for (const TextFile& fragment : house.tables)
  {
    for (const std::string& id : case_ids(fragment.text))
    {
      for (const Section& page : pages_with(house, fragment))
      {
        places[id] +=
            "<a href=\"" + page.id + ".html#case-" + id + "\">" + escaped(page.title) + "</a><br>";
      }
    }
  }
  Rows rows;
  for (const auto& [id, place] : places)
  {
    rows[id] =
        "<td>" + id + "</td><td>" + place + "</td><td>" + list(tests, "case:" + id) + "</td>";
  }
  return "# Where methods fail {#failing_cases}\n\nEvery case that breaks a method, where the book "
         "shows it, and the tests that\nassert which method fails and which survives.\n\n" +
         table("<th>Case</th><th>Shown in</th><th>Asserted by</th>", rows);
}

/// The first sentence of a header's `\file` comment.
std::string summary(const std::string& header)
{
  static const std::regex comment(R"([\\@]file[^\n]*\n((?:[ ]*///[^\n]*\n)+))");
  std::smatch match;
  if (!std::regex_search(header, match, comment))
  {
    return "";
  }
  std::string text;
  for (const std::string& word : matches(match.str(1), R"((\S+))"))
  {
    text += word == "///" || word == "\\brief" ? "" : (text.empty() ? "" : " ") + word;
    if (word.back() == '.')
    {
      break;
    }
  }
  return escaped(text);
}

/// The section `##` of the chapter's pages that shows a recipe's header; its id may be empty.
std::string section_of(const House& house, const std::string& chapter, const std::string& stem)
{
  const std::regex snippet(R"([\\@]snippet +(?:[\w/]*/)?)" + stem + R"(\.hpp)");
  for (const TextFile& page : house.pages)
  {
    std::string id;
    for (const Section& section : sections(page.text))
    {
      id = section.level == 2 ? section.id : id;
      if (chapter_of(page.path) == chapter && !id.empty() &&
          std::regex_search(section.text, snippet))
      {
        return id;
      }
    }
  }
  return "";
}

/// The name of the copy of a source that has no marks.
std::string whole(const std::string& file)
{
  const std::size_t dot = file.find('.');
  return file.substr(0, dot) + "_whole" + file.substr(dot);
}

/// Copies the sources that pages show: once with marks for pieces, once without for the whole.
void write_sources(const fs::path& root, const fs::path& folder)
{
  for (const char* part : {"common", "tools", "recipes", "tests"})
  {
    for (const TextFile& file :
         read_tree(root, part, {".hpp", ".cpp", ".expected", ".json", ".cmake"}))
    {
      const fs::path path = folder / file.path;
      fs::create_directories(path.parent_path());
      write(path, with_marks(file.text));
      write(path.parent_path() / whole(path.filename().string()), without_marks(file.text));
    }
  }
}

std::string listing(const House& house, const std::string& folder, const std::string& stem)
{
  std::string text = "# Files of " + stem + " {#" + listing_id(stem) + "}\n\n";
  const auto show =
      [&](const std::string& heading, const std::vector<TextFile>& files, const std::string& file)
  {
    for (const TextFile& one : files)
    {
      if (chapter_folder(one.path) == folder && fs::path(one.path).filename() == file)
      {
        text += "## " + heading + " {#" + listing_place(file) + "}\n\n<span class=\"path\">" +
                escaped(one.path) + "</span>\n\n\\include " + whole(file) + "\n\n";
      }
    }
  };
  show("The header", house.recipes, stem + ".hpp");
  show("The program", house.recipes, stem + ".cpp");
  show("What it prints", house.recipes, stem + ".expected");
  for (const TextFile& one : house.live)
  {
    if (one.path == "recipes/" + folder + "/" + stem + "/live.cpp")
    {
      text += "## The live figure {#" + listing_id(stem) + "_live}\n\n<span class=\"path\">" +
              escaped(one.path) + "</span>\n\n\\include " + stem + "/live_whole.cpp\n\n";
    }
  }
  show("The tests", house.tests, stem + "_test.cpp");
  return text;
}

/// What each recipe is for, by chapter and name: a header says it, else a program, else a test.
std::map<std::string, Summaries> summaries(const House& house)
{
  std::map<std::string, Summaries> found;
  for (const std::string ending : {".hpp", ".cpp", "_test.cpp"})
  {
    for (const auto* files : {&house.recipes, &house.tests})
    {
      for (const TextFile& file : *files)
      {
        const std::string name = fs::path(file.path).filename().string();
        const std::size_t start = name.size() - std::min(ending.size(), name.size());
        if (name.substr(start) == ending && (files == &house.tests) == (ending == "_test.cpp"))
        {
          found[chapter_folder(file.path)].emplace(name.substr(0, start), summary(file.text));
        }
      }
    }
  }
  return found;
}

/// What a command prints; nothing if it fails.
std::string printed(const std::string& command)
{
  std::string text;
  if (FILE* const pipe = popen(command.c_str(), "r"))
  {
    for (int c = fgetc(pipe); c != EOF; c = fgetc(pipe))
    {
      text += static_cast<char>(c);
    }
    text = pclose(pipe) == 0 ? text : "";
  }
  return text;
}

/// After each command that runs a recipe with a header, how long its single-header export is;
/// `paths` are the files of the tree.
std::string
with_sizes(const fs::path& root, const std::string& page, const std::vector<std::string>& paths)
{
  static const std::regex run(R"(\./cookbook run (\w+)\n[^`]*```\n)");
  static const std::regex count(R"(: (\d+) of its files in one)");
  const std::string take = "'" + (root / "cookbook").string() + "' take ";
  std::string result;
  std::size_t done = 0;
  for (std::sregex_iterator each(page.begin(), page.end(), run), end; each != end; ++each)
  {
    const std::string name = each->str(1);
    const auto is_header = [ending = "/" + name + "/" + name + ".hpp"](const std::string& path)
    { return path.ends_with(ending); };
    const auto header = std::find_if(paths.begin(), paths.end(), is_header);
    if (header == paths.end())
    {
      continue;
    }
    const std::string taken = printed(take + name + " 2>/dev/null");
    std::smatch files;
    if (std::regex_search(taken, files, count))
    {
      const std::size_t past = static_cast<std::size_t>(each->position() + each->length());
      result += page.substr(done, past - done) +
                "\n<p class=\"taken\">As a single header: <code>./cookbook take " + name +
                "</code> writes " + std::to_string(std::count(taken.begin(), taken.end(), '\n')) +
                " lines, from " + files.str(1) + " files.</p>\n";
      done = past;
    }
  }
  return result + page.substr(done);
}

/// A page as Doxygen reads it. What is not in the tree's own folders is written by this program.
std::string filtered(const fs::path& root, const fs::path& page)
{
  const std::string path =
      fs::absolute(page).lexically_relative(fs::absolute(root)).generic_string();
  const std::string text = with_whole_links(read_text(page));
  if (path.rfind("chapters/", 0) != 0 && path.rfind("docs/", 0) != 0)
  {
    return prepared(text, "");
  }
  const std::vector<std::string> paths = shown_paths(root);
  const std::string neighbours = neighbour_links(book_pages(root), path);
  return with_heads(with_folds(prepared(with_sizes(root, text, paths), neighbours)), paths);
}

/// The first figure that a recipe draws, as a path that \htmlinclude knows; empty if it draws none.
std::string figure_of(const fs::path& root, const std::string& chapter, const std::string& name)
{
  const fs::path folder = fs::path("chapters/figures") / chapter;
  const std::regex mine(name + R"((_\w+)?\.svg)");
  std::string first;
  for (const TextFile& figure : read_tree(root, folder.generic_string(), {".svg"}))
  {
    const std::string file = fs::path(figure.path).filename().string();
    first = first.empty() && std::regex_match(file, mine) ? chapter + "/" + file : first;
  }
  return first;
}

/// Writes a page with its files in full for each recipe, helper and test; the index of recipes,
/// with a line and a figure each, in the order of the book; and one of all other files.
void write_recipes(const fs::path& root, const House& house, const fs::path& folder)
{
  const auto chapters = summaries(house);
  std::string text = "# Index of recipes {#recipes}\n\nEvery recipe of the book, what it answers, "
                     "and its files in full.\n\n";
  std::string others = "# Other files {#other_files}\n\nWhat recipes share, what puts them to the "
                       "test, and charts: each with its files in full.\n\n";
  for (const TextFile& page : house.pages)
  {
    const std::string chapter = stem(page.path);
    const auto found = chapters.find(chapter);
    if (found == chapters.end())
    {
      continue;
    }
    std::map<std::string, std::string> rows; // by place in the book
    Rows rest;
    const std::string list = read_text(root / "recipes" / chapter / "CMakeLists.txt");
    for (const auto& [name, sentence] : found->second)
    {
      write(folder / (listing_id(name) + ".md"), listing(house, chapter, name));
      const std::string files = "\\subpage " + listing_id(name) + " \"";
      const std::regex line("(^|\n)cookbook_recipe\\(" + name + R"(\b)");
      std::smatch place;
      if (!std::regex_search(list, place, line))
      {
        rest[name] = "<td>" + files + name + "\"</td><td>" + sentence + "</td>";
        continue;
      }
      const std::string id = section_of(house, chapter_of(page.path), name);
      const std::string figure = figure_of(root, chapter, name);
      const std::string order = std::to_string(1'000'000 + place.position());
      rows[order] = "<td>" + (figure.empty() ? "" : "\n\\htmlinclude " + figure + "\n") +
                    "</td><td>" +
                    (id.empty() ? escaped(name) : "\\ref " + id + " \"" + name + "\"") + "<br>" +
                    sentence + "</td><td>" + files + "files\"</td>";
    }
    const std::string heading = "## " + title_of(page).title + "\n\n";
    Rows ordered(rows.begin(), rows.end());
    text +=
        ordered.empty() ? "" : heading + table("<th></th><th>Recipe</th><th></th>", ordered) + "\n";
    others +=
        rest.empty() ? "" : heading + table("<th>Name</th><th>What it is for</th>", rest) + "\n";
  }
  text += "What else there is, helpers and charts: \\subpage other_files.\n";
  write(folder / "recipes.md", text);
  write(folder / "other_files.md", others);
}

} // namespace

int main(int argc, char** argv)
try
{
  if (argc != 3)
  {
    throw std::runtime_error("usage: book_index ROOT FOLDER | book_index ROOT PAGE.md");
  }
  if (fs::path(argv[2]).extension() == ".md")
  {
    std::cout << filtered(argv[1], argv[2]);
    return 0;
  }
  const House house = read_house(argv[1]);
  const fs::path folder = fs::path(argv[2]) / "pages";
  fs::remove_all(folder);
  fs::create_directories(folder);
  fs::remove_all(folder.parent_path() / "sources");
  write_sources(argv[1], folder.parent_path() / "sources");
  write(folder / "formulas.md", formulas(house));
  write(folder / "failing_cases.md", failing_cases(house));
  write_recipes(argv[1], house, folder);
  return 0;
}
catch (const std::exception& error)
{
  std::cerr << "book_index: " << error.what() << '\n';
  return 1;
}
