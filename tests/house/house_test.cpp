/// \file
/// The house keeps its own rules. Each rule is tried twice: on the tree, where it must find
/// nothing, and on a small text that breaks it, where it must complain.

#include "file_rules.hpp"
#include "folder_rules.hpp"
#include "page_rules.hpp"
#include "reading_rules.hpp"
#include "recipe_rules.hpp"

#include "docs/index/order.hpp"
#include "tests/catch.hpp"

#include <cstdlib>

using namespace cookbook::house;
using cookbook::book::read_tree;

namespace
{

/// The tree, or the one that the environment names: tests/new asks about a tree with a new recipe.
const char* const named = std::getenv("COOKBOOK_HOUSE");
const std::filesystem::path root{named != nullptr ? named : COOKBOOK_SOURCE_DIR};

/// The chapters' pages, in the order in which the book is read.
std::vector<TextFile> pages()
{
  auto files = cookbook::book::book_pages(root);
  std::erase_if(
      files, [](const TextFile& page) { return cookbook::book::chapter_of(page.path).empty(); });
  return files;
}

std::vector<TextFile> test_sources()
{
  auto files = read_tree(root, "tests", {".cpp"});
  std::erase_if(
      files, [](const TextFile& file) { return file.path.rfind("tests/house/", 0) == 0; });
  return files;
}

std::vector<TextFile> together(std::vector<TextFile> a, const std::vector<TextFile>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Files of these kinds in common/, tools/ and recipes/.
std::vector<TextFile> house_sources(const std::vector<std::string>& kinds)
{
  return together(
      together(read_tree(root, "common", kinds), read_tree(root, "tools", kinds)),
      read_tree(root, "recipes", kinds));
}

std::vector<TextFile> all_headers()
{
  std::vector<TextFile> headers;
  for (const char* folder : {"common", "tools", "recipes", "docs", "tests"})
  {
    headers = together(headers, read_tree(root, folder, {".hpp"}));
  }
  return headers;
}

void expect_none(const Complaints& complaints)
{
  for (const std::string& complaint : complaints)
  {
    UNSCOPED_INFO(complaint);
  }
  CHECK(complaints.empty());
}

} // namespace

TEST_CASE("every formula on a page has a test, and every test's formula a page", "[house]")
{
  expect_none(formulas_are_tested(pages(), test_sources()));
}

TEST_CASE(
    "a formula without test, a test without formula and a doubled formula are found", "[house]")
{
  const std::vector<TextFile> page{{"chapters/03_x.md", "\\f[ p = r \\tag{S1} \\f]"}};
  const std::vector<TextFile> test{
      {"tests/t.cpp", "TEST_CASE(\"adds \"\n  \"up\", \"[S1][slow]\")"}};
  const std::vector<TextFile> other{{"tests/t.cpp", "TEST_CASE(\"adds up\", \"[S2][case:S1]\")"}};
  CHECK(formulas_are_tested(page, test).empty());
  CHECK(formulas_are_tested(page, other).size() == 2);
  CHECK(formulas_are_tested(together(page, page), test).size() == 1);
  CHECK(formulas_are_tested({{"chapters/03_x.md", "\\tag{one}"}}, {}).size() == 1);
}

TEST_CASE("every row of a table of failing cases has a test", "[house]")
{
  expect_none(cases_are_tested(read_tree(root, "chapters/figures", {".html"}), test_sources()));
}

TEST_CASE("a failing case without test is found, and a formula's tag does not serve", "[house]")
{
  const std::vector<TextFile> table{{"t.html", "<tr id=\"case-S1\"><td>"}};
  CHECK(cases_are_tested(table, {{"t.cpp", "TEST_CASE(\"falls\", \"[S1]\")"}}).size() == 1);
  CHECK(cases_are_tested(table, {{"t.cpp", "TEST_CASE(\"falls\", \"[case:S1]\")"}}).empty());
}

TEST_CASE(
    "includes go downhill: to common and to earlier chapters; tools only in programs and trials",
    "[house]")
{
  const std::vector<std::string> code{".hpp", ".cpp"};
  const auto sources = house_sources(code);
  CHECK(sources.size() > 0);
  expect_none(includes_go_downhill(sources));
}

TEST_CASE("an include of a later chapter, of a recipe by common and of a test are found", "[house]")
{
  const auto include = [](const std::string& path, const std::string& target) {
    return includes_go_downhill({{path, "#include \"" + target + "\"\n"}}).size();
  };
  CHECK(include("recipes/03_x/a.hpp", "04_y/b.hpp") == 1);
  CHECK(include("recipes/03_x/a.hpp", "03_x/b.hpp") == 0);
  CHECK(include("recipes/03_x/a.hpp", "common/math/norm.hpp") == 0);
  CHECK(include("common/math/a.hpp", "02_primitives/shapes.hpp") == 1);
  CHECK(include("common/math/a.hpp", "tests/catch.hpp") == 1);
  CHECK(include("common/math/a.hpp", "tools/plot/svg.hpp") == 1);
  CHECK(include("tools/plot/a.hpp", "03_x/b.hpp") == 1);
  CHECK(include("recipes/03_x/a/a.hpp", "tools/plot/svg.hpp") == 1);
  CHECK(include("recipes/03_x/a/a.cpp", "tools/plot/svg.hpp") == 0);
  CHECK(include("recipes/03_x/a/trial/a.hpp", "tools/plot/svg.hpp") == 0);
}

TEST_CASE(
    "a folder of more than 14 files or a header of more than 200 lines has a reason, every file a "
    "folder",
    "[house]")
{
  std::vector<std::string> paths;
  for (const char* folder : {"common", "tools", "recipes"})
  {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder))
    {
      if (entry.is_regular_file())
      {
        paths.push_back(entry.path().lexically_relative(root).generic_string());
      }
    }
  }
  CHECK(paths.size() > 300);
  Sizes large = large_folders(paths);
  large.merge(large_headers(all_headers()));
  expect_none(large_for_a_reason(large, cookbook::book::read_text(root / "tests/house/large.txt")));
  expect_none(recipes_have_folders(paths));
}

TEST_CASE("a folder of 15 files and a file in none are found", "[house]")
{
  std::vector<std::string> paths;
  for (char name = 'a'; name < 'o'; ++name)
  {
    paths.push_back("recipes/03_x/a/" + std::string(1, name) + ".hpp");
  }
  CHECK(large_folders(paths).empty());
  paths.push_back("recipes/03_x/a/trial/a.hpp");
  CHECK(large_folders(paths).empty());
  paths.push_back("recipes/03_x/a/z.hpp");
  CHECK(large_folders(paths) == Sizes{{"recipes/03_x/a", "15 files"}});
  CHECK(recipes_have_folders(paths).empty());
  CHECK(recipes_have_folders({"recipes/CMakeLists.txt", "recipes/03_x/CMakeLists.txt"}).empty());
  CHECK(recipes_have_folders({"recipes/03_x/a.hpp"}).size() == 1);
  CHECK(recipes_have_folders({"recipes/03_x/a/other/a.hpp"}).size() == 1);
}

TEST_CASE("nothing outside a trial includes one, but programs; folders have no circles", "[house]")
{
  const std::vector<std::string> code{".hpp", ".cpp"};
  const auto sources = house_sources(code);
  expect_none(exported_stand_alone(sources));
  expect_none(folders_have_no_circles(sources));
}

TEST_CASE("an include of a trial and a circle of folders or trials are found", "[house]")
{
  const auto file = [](const std::string& path, const std::string& target) {
    return TextFile{path, "#include \"" + target + "\"\n"};
  };
  const TextFile scenes{"recipes/03_x/a/trial/scenes.hpp", ""};
  CHECK(
      exported_stand_alone({scenes, file("recipes/03_x/a/a.hpp", "03_x/a/trial/scenes.hpp")})
          .size() == 1);
  CHECK(
      exported_stand_alone({scenes, file("recipes/03_x/b/trial/b.hpp", "03_x/a/trial/scenes.hpp")})
          .empty());
  TextFile program = file("recipes/03_x/a/a.cpp", "03_x/a/trial/scenes.hpp");
  CHECK(exported_stand_alone({scenes, program}).size() == 1);
  program.text += "int main(int argc, char** argv)\n";
  CHECK(exported_stand_alone({scenes, program}).empty());

  const TextFile to_b = file("recipes/03_x/a/a.hpp", "03_x/b/b.hpp");
  const TextFile to_c = file("recipes/03_x/b/b.hpp", "03_x/c/trial/c.hpp");
  CHECK(folders_have_no_circles({to_b, to_c, {"recipes/03_x/c/trial/c.hpp", ""}}).empty());
  const TextFile back = file("recipes/03_x/c/trial/c.hpp", "03_x/a/a.hpp");
  CHECK(folders_have_no_circles({to_b, to_c, back}).size() == 1);
  CHECK(folders_have_no_circles({to_b, file("recipes/03_x/b/b.hpp", "03_x/a/a.hpp")}).size() == 1);
}

TEST_CASE("every live figure is built, and is on a page", "[house]")
{
  expect_none(live_figures_are_shown(read_tree(root, "recipes", {".cpp", ".txt"}), pages()));
  const TextFile figure{"recipes/03_x/a/live.cpp", ""};
  const TextFile list{"recipes/03_x/CMakeLists.txt", "cookbook_live(a)\n"};
  const TextFile page{"chapters/03_x.md", "\\live{a}\n"};
  CHECK(live_figures_are_shown({figure, list}, {page}).empty());
  CHECK(live_figures_are_shown({figure, list}, {}).size() == 1);
  CHECK(live_figures_are_shown({figure}, {page}).size() == 1);
}

TEST_CASE("every chapter has its sections in the same order, on one page or several", "[house]")
{
  for (const TextFile& page : with_sub_pages(pages()))
  {
    expect_none(page_is_in_order(page));
  }
}

TEST_CASE("a page with swapped sections, or a recipe without proof, is found", "[house]")
{
  const std::string start = "# Chapter 3: X {#ch3}\n## What you need\n## What this scene needs\n";
  const std::string recipe = "## A {#a}\n### The idea\n### Code\n### Run it\n";
  const std::string end =
      "## Where it breaks\n## Speed against accuracy\n## Exercises\n## Sources\n";
  CHECK(page_is_in_order({"p", start + recipe + "### Proof\n" + end}).empty());
  CHECK(page_is_in_order({"p", start + recipe + end}).size() == 1);
  CHECK(page_is_in_order({"p", end + start}).size() == 1);
  CHECK(page_is_in_order({"p", start + "## Sources\n" + end}).empty());
  CHECK(page_is_in_order({"p", start}).size() == 1);
  const auto with = [&](const std::string& path, const std::string& section) {
    return page_is_in_order({path, start + section + end}).size();
  };
  CHECK(with("chapters/03_x.md", recipe + "### Why\n### Proof\n") == 0);
  CHECK(with("chapters/03_x.md", recipe + "### Proof\n### Why\n") == 1);
  const std::string old = "## A {#a}\n### Formula\n### Code\n### Run it\n### Proof\n";
  CHECK(with("chapters/03_x.md", old) == 1);
  CHECK(with("chapters/03_x.md", "## Rounding {#r}\nText.\n") == 0);
  CHECK(with("chapters/03_x.md", "## A {#a}\n\\include a.expected\n") == 1);
}

TEST_CASE("every page has a chapter's or the front page's link to it", "[house]")
{
  CHECK(pages().size() == read_tree(root, "chapters", {".md"}).size());
}

TEST_CASE("pages are read in the order of the links that open them", "[house]")
{
  using namespace cookbook::book;
  const std::vector<TextFile> tree{
      {"chapters/03_a.md", "# A {#a}\n\\subpage d and \\subpage c\n"},
      {"chapters/03_c.md", "# C {#c}\n"},
      {"chapters/03_d.md", "# D {#d}\n"},
      {"docs/index.md", "# F {#mainpage}\n\\subpage a\n"}};
  const auto order = reading_order(tree, "mainpage");
  REQUIRE(order.size() == 4);
  CHECK(order[2].path == "chapters/03_d.md");
  const std::string links = neighbour_links(order, "chapters/03_d.md");
  CHECK(links.find("\"previous\" href=\"a.html\"") != std::string::npos);
  CHECK(links.find("\"next\" href=\"c.html\"") != std::string::npos);
  CHECK(neighbour_links(order, "docs/index.md").empty());
}

TEST_CASE("a listing is headed by its file, linked where a page shows it in full", "[house]")
{
  using cookbook::book::listing_head;
  const auto links = [](const std::string& path)
  { return listing_head(path).find("\\ref ") != std::string::npos; };
  CHECK(listing_head("recipes/03_x/a/a.hpp").find("files_a_header \"a.hpp\"") != std::string::npos);
  CHECK(listing_head("recipes/03_x/a/a.expected").find("files_a_output") != std::string::npos);
  CHECK(listing_head("tests/03_x/a_test.cpp").find("files_a_tests") != std::string::npos);
  CHECK(listing_head("common/math/b.hpp").find("\\ref b.hpp") != std::string::npos);
  CHECK_FALSE(links("tools/plot/b.cpp"));
  CHECK_FALSE(links("tests/03_x/accuracy.hpp"));
  CHECK_FALSE(links("recipes/03_x/a/a.json"));
  const std::string page = "Text\n\\snippet b.hpp piece\n";
  CHECK(cookbook::book::with_heads(page, {"common/math/b.hpp"}).find("\n<div") == 4);
}

TEST_CASE(
    "a link that a line's end cuts in two is made whole, and the lines keep their number",
    "[house]")
{
  using cookbook::book::with_whole_links;
  CHECK(
      with_whole_links("a \\ref b \"two\n  words\", c\nd\n") ==
      "a \\ref b \"two words\"\n, c\nd\n");
  CHECK(with_whole_links("a \\ref\n  b \"two words\", c\n") == "a \\ref b \"two words\"\n, c\n");
  CHECK(with_whole_links("\\ref a \"b\" and\n\"c\"\n") == "\\ref a \"b\" and\n\"c\"\n");
}

TEST_CASE("a fold's tags are handed to the browser as they are", "[house]")
{
  CHECK(
      cookbook::book::with_folds("A\n<details class=\"more\">\nB\n</details>\n") ==
      "A\n\\htmlonly[block]<details class=\"more\">\\endhtmlonly\nB\n"
      "\\htmlonly[block]</details>\\endhtmlonly\n");
}

TEST_CASE("no page has more words or lines of listings than a reader has patience for", "[house]")
{
  const std::vector<std::string> shown{".hpp", ".cpp", ".expected"};
  const auto tree = together(house_sources(shown), read_tree(root, "tests", shown));
  expect_none(pages_are_short(pages(), tree));
}

TEST_CASE("a page's words and lines are counted as they are read", "[house]")
{
  const std::vector<TextFile> tree{
      {"recipes/03_x/a.hpp", "// [a]\nint x;\n// [b]\nint y;\n// [b]\n// [a]\nint z;\n"},
      {"recipes/03_x/a.expected", "1\n2\n3\n"}};
  const auto lines = [&](const std::string& page) { return size_of(page, tree).lines; };
  CHECK(lines("\\snippet a.hpp a\n") == 2);
  CHECK(lines("\\snippet a.hpp b\n\\include a.expected\n") == 4);
  CHECK(lines("<details class=\"more\">\n\\snippet a.hpp a\n</details>\n\\snippet a.hpp b\n") == 1);
  CHECK(
      count_words("# Two words {#id}\nand **three** more, \\f$ n = 1 \\f$ \\ref S1 \"(S1)\".\n") ==
      6);
  CHECK(
      count_words(
          "\\snippet a.hpp a\n<div class=\"x\">one</div>\n| two | 3 |\n```sh\nrun\n```\n") == 2);
  std::string text;
  for (std::size_t word = 0; word < most.words; ++word)
  {
    text += "word ";
  }
  CHECK(pages_are_short({{"chapters/03_x.md", text}}, tree).empty());
  CHECK(pages_are_short({{"chapters/03_x.md", text + "word"}}, tree).size() == 1);
  const std::vector<TextFile> tall{{"recipes/03_x/a.expected", std::string(most.lines + 1, '\n')}};
  CHECK(pages_are_short({{"chapters/03_x.md", "\\include a.expected\n"}}, tall).size() == 1);
}

TEST_CASE("a sentence before each listing, exercises on each page", "[house]")
{
  for (const TextFile& page : pages())
  {
    expect_none(listings_are_introduced(page));
    expect_none(page_has_exercises(page));
  }
}

TEST_CASE("two listings in a row, and a page without exercises, are found", "[house]")
{
  const std::string one = "\\snippet a.hpp a\n", other = "\\include a.expected\n";
  CHECK(listings_are_introduced({"p", one + "\nIt prints:\n\n" + other}).empty());
  CHECK(listings_are_introduced({"p", one + "\n### Run it\n\n" + other}).size() == 1);
  CHECK(listings_are_introduced({"p", one + "<details class=\"more\">\n" + other}).size() == 1);
  CHECK(page_has_exercises({"p", "## Exercises\n1. Run `a`,\n   then `b`.\n2. `c`.\n"}).empty());
  CHECK(page_has_exercises({"p", "## Exercises\n1. Think,\n   then `b`.\n2. Rest.\n"}).size() == 1);
  CHECK(page_has_exercises({"p", "## Exercises\nNone.\n"}).size() == 1);
}

TEST_CASE("a chapter's sub-pages are read behind it, and another chapter is not", "[house]")
{
  const std::vector<TextFile> tree{
      {"chapters/03_x.md", "## A"}, {"chapters/03_x_more.md", "## B"}, {"chapters/04_xy.md", "C"}};
  const auto chapters = with_sub_pages(tree);
  REQUIRE(chapters.size() == 2);
  CHECK(chapters[0].text == "## A\n## B");
  CHECK(chapters[1].text == "C");
}

TEST_CASE("every program has its header, output, test and section", "[house]")
{
  const auto recipes = read_tree(root, "recipes", {".hpp", ".cpp", ".expected", ".txt"});
  expect_none(recipes_are_whole(together(recipes, test_sources()), pages()));
  expect_none(examples_are_whole(recipes, pages()));
}

TEST_CASE("an example that no page shows, or of 21 lines, is found", "[house]")
{
  const auto example = [](std::size_t lines)
  {
    std::string text = "\n// [example]\n#include <cstdio>\n\nint main()\n{\n";
    for (std::size_t line = 4; line < lines; ++line)
    {
      text += "  f();\n";
    }
    return std::vector<TextFile>{{"recipes/03_x/a/b_example.cpp", text + "}\n// [example]\n"}};
  };
  const std::vector<TextFile> page{
      {"chapters/03_x.md", "\\snippet b_example.cpp example\n\\include b_example.expected\n"}};
  CHECK(examples_are_whole(example(20), page).empty());
  CHECK(examples_are_whole(example(21), page).size() == 1);
  CHECK(examples_are_whole(example(20), {}).size() == 1);
  CHECK(recipes_are_whole(example(20), page).empty());
}

TEST_CASE("a recipe that lacks a part is found, and a chart needs no checked output", "[house]")
{
  const std::vector<TextFile> tree{
      {"recipes/03_x/a/a.cpp", "int main()"},
      {"recipes/03_x/a/a.hpp", ""},
      {"tests/03_x/a_test.cpp", ""}};
  const std::vector<TextFile> page{{"chapters/03_x.md", "# X\n## A\n\\snippet a.hpp a\n"}};
  const std::vector<TextFile> chart{
      {"recipes/03_x/CMakeLists.txt", "cookbook_recipe(b)\ncookbook_chart(a)\n"}};
  CHECK(recipes_are_whole(together(tree, chart), page).empty());
  CHECK(recipes_are_whole(tree, page).size() == 1);
  CHECK(recipes_are_whole(together(tree, chart), {}).size() == 1);
  CHECK(recipes_are_whole({tree[0]}, {}).size() == 4);
}

TEST_CASE("no code or output is typed on a page: only commands for a shell", "[house]")
{
  for (const TextFile& page : together(pages(), read_tree(root, "docs", {".md"})))
  {
    expect_none(nothing_is_typed(page));
  }
}

TEST_CASE(
    "typed code is found, fenced, indented and by command; lists and formulas are not", "[house]")
{
  CHECK(nothing_is_typed({"p", "```sh\nrun\n```\n"}).empty());
  CHECK(nothing_is_typed({"p", "```cpp\nint x;\n```\n"}).size() == 1);
  CHECK(nothing_is_typed({"p", "```\n0.5\n```\n"}).size() == 1);
  CHECK(nothing_is_typed({"p", "Text\n\n    int x;\n"}).size() == 1);
  CHECK(nothing_is_typed({"p", "- item\n\n    more of it\n"}).empty());
  CHECK(nothing_is_typed({"p", "\\f[\n\n    x\n\\f]\n"}).empty());
  CHECK(nothing_is_typed({"p", "@code\nint x;\n@endcode\n"}).size() == 1);
}

TEST_CASE("tests name Approx as Catch2's version 3 has it, too", "[house]")
{
  for (const TextFile& source : test_sources())
  {
    CAPTURE(source.path);
    const bool bare = !cookbook::book::matches(source.text, R"((?:^|[^:\w])(Approx\())").empty();
    CHECK((!bare || source.text.find("using Catch::Approx;") != std::string::npos));
  }
}

TEST_CASE("every snippet on a page is marked twice in one file", "[house]")
{
  const std::vector<std::string> code{".hpp", ".cpp"};
  const auto sources = together(house_sources(code), read_tree(root, "tests", code));
  expect_none(snippets_are_marked(pages(), sources));
}

TEST_CASE("every marked piece of code is on a page", "[house]")
{
  const std::vector<std::string> code{".hpp", ".cpp"};
  const auto sources = together(house_sources(code), read_tree(root, "tests", code));
  expect_none(marks_are_shown(together(pages(), read_tree(root, "docs", {".md"})), sources));
}

TEST_CASE("a marked piece that no page shows is found", "[house]")
{
  const std::vector<TextFile> marked{{"recipes/03_x/a.hpp", "// [a]\nint x;\n// [a]\n"}};
  CHECK(marks_are_shown({{"p", "\\snippet a.hpp a\n"}}, marked).empty());
  CHECK(marks_are_shown({{"p", "\\snippet a.hpp b\n\\snippet b.hpp a\n"}}, marked).size() == 1);
}

TEST_CASE("a snippet of a missing, ambiguous or unmarked piece is found", "[house]")
{
  const std::vector<TextFile> page{{"p", "\\snippet a.hpp a\n"}};
  const std::vector<TextFile> marked{{"recipes/03_x/a.hpp", "// [a]\nint x;\n// [a]\n"}};
  CHECK(snippets_are_marked(page, marked).empty());
  CHECK(snippets_are_marked(page, together(marked, marked)).size() == 1);
  CHECK(snippets_are_marked(page, {{"recipes/03_x/a.hpp", "// [a]\nint x;\n"}}).size() == 1);
  CHECK(snippets_are_marked(page, {{"recipes/03_x/aa.hpp", marked[0].text}}).size() == 1);
}

TEST_CASE("every type and function of a header is documented", "[house]")
{
  expect_none(headers_are_documented(house_sources({".hpp"})));
}

TEST_CASE(
    "a header of 201 lines is found unless its reason is listed, one of 200 is not", "[house]")
{
  CHECK(large_headers({{"a.hpp", std::string(200, '\n')}}).empty());
  const Sizes large = large_headers({{"a.hpp", std::string(201, '\n')}});
  CHECK(large == Sizes{{"a.hpp", "201 lines"}});
  CHECK(large_for_a_reason(large, "# b: no\n").size() == 1);
  CHECK(large_for_a_reason(large, "a.hpp: one class\n").empty());
  CHECK(large_for_a_reason({}, "a.hpp: one class\n").size() == 1);
}

TEST_CASE("a header, a type or a function without its sentence is found", "[house]")
{
  const auto count = [](const std::string& text) {
    return headers_are_documented({{"a.hpp", "/// \\file\n/// A.\n\n" + text}}).size();
  };
  CHECK(count("/// A body.\nstruct Body\n{\n};\n") == 0);
  CHECK(count("struct Body\n{\n};\n") == 1);
  CHECK(count("struct Body;\n\ntemplate <class Real>\nstruct Other;\n") == 0);
  CHECK(count("/// A body.\nstruct Body;\n\nstruct Body\n{\n};\n") == 0);
  CHECK(count("// [turn]\ntemplate <class Real>\nReal turn(Real x)\n{\n}\n") == 1);
  CHECK(
      headers_are_documented({{"recipes/a.hpp", "/// A body.\nstruct Body\n{\n};\n"}}).size() == 1);
}

TEST_CASE("chapters 1 to 6, common, tools and docs speak the words of the field", "[house]")
{
  const std::vector<std::string> kinds{".hpp", ".cpp", ".md", ".expected"};
  std::vector<TextFile> files;
  for (const char* folder : {"chapters", "recipes", "tests", "common", "tools", "docs"})
  {
    files = together(files, read_tree(root, folder, kinds));
  }
  std::erase_if(
      files,
      [](const TextFile& file)
      {
        return cookbook::book::chapter_of(file.path) > "06" ||
               file.path.rfind("tests/house/", 0) == 0 || file.path.rfind("tests/take/", 0) == 0;
      });
  expect_none(words_are_of_the_field(
      files, cookbook::book::read_text(root / "tests/house/private_words.txt")));
}

TEST_CASE(
    "a word of the list is found, also within a name; those for code may be on a page", "[house]")
{
  const std::string list = "# a: b\nsquare to: perpendicular to\ncode: rails?: threshold\n";
  const auto count = [&](const std::string& path, const std::string& text) {
    return words_are_of_the_field({{path, text}}, list).size();
  };
  CHECK(count("a.hpp", "// Square to it.\nint draw_rail;\nint derail;\n") == 2);
  CHECK(count("a.md", "square to\n") == 1);
  CHECK(count("a.md", "a rail\n") == 0);
}

TEST_CASE("no file names a folder of one machine or a package registry", "[house]")
{
  const std::vector<std::string> text{".md",  ".hpp",  ".cpp", ".txt",     ".cmake",
                                      ".in",  ".css",  ".js",  ".xml",     ".json",
                                      ".yml", ".html", ".svg", ".expected"};
  std::vector<TextFile> files;
  for (const char* folder : {"chapters", "common", "tools", "docs", "recipes", "tests", ".github"})
  {
    files = together(files, read_tree(root, folder, text));
  }
  for (const char* name : {"README.md", "CMakeLists.txt", "CMakePresets.json", "cookbook"})
  {
    if (std::filesystem::is_regular_file(root / name))
    {
      files.push_back({name, cookbook::book::read_text(root / name)});
    }
  }
  expect_none(no_machine_is_named(files));
}

TEST_CASE("a machine's folder and a registry's address are found", "[house]")
{
  const auto count = [](const std::string& line) {
    return no_machine_is_named({{"f", line}}).size();
  };
  CHECK(count(std::string("see /ho") + "me/somebody/book") == 1);
  CHECK(count(std::string("https://regis") + "try.example.org/x") == 1);
  CHECK(count("recipes/work/a and /usr/share/javascript") == 0);
}
