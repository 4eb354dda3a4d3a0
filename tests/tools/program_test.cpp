/// \file
/// What holds for the programs' common parts: tables, numbers, CSV files, errors.

#include "tools/files/csv.hpp"
#include "tools/files/whole_file.hpp"
#include "tools/program/asking.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include "tests/catch.hpp"
#include "tests/tools/run_program.hpp"

#include <csignal>
#include <fstream>
#include <sstream>

#include <sys/resource.h>
#include <unistd.h>

using namespace cookbook;

namespace
{

std::vector<CsvRow> rows_of(const std::string& text, const std::string& header = "x,y")
{
  std::istringstream stream(text);
  return read_csv(stream, "pairs.csv", header);
}

/// The sentence a wrong file is answered with.
std::string complaint(const std::string& text, const std::string& header = "x,y")
{
  try
  {
    rows_of(text, header);
  }
  catch (const CsvError& error)
  {
    return error.what();
  }
  return "";
}

/// A folder that is gone after the test.
struct Folder
{
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("cookbook_program_" + std::to_string(getpid()));

  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
};

std::string text_of(const std::filesystem::path& file)
{
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

auto files_in(const std::filesystem::path& folder)
{
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

/// As long as this lives, no file may grow beyond so many bytes: like a disk that is full.
class SmallFiles
{
public:
  explicit SmallFiles(rlim_t most)
  {
    signal_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{most, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFiles()
  {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

private:
  rlimit before_{};
  void (*signal_)(int) = nullptr;
};

} // namespace

TEST_CASE("rows of numbers are read, with spaces, blank lines and any line ends", "[csv]")
{
  const std::vector<CsvRow> rows = rows_of("\xEF\xBB\xBFx, y\r\n 1.5 ,-2e3\r\n\r\n+3,.5");
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].values == std::vector<double>{1.5, -2000});
  CHECK(rows[1].values == std::vector<double>{3, 0.5});
  CHECK(rows[1].line == 4);
}

TEST_CASE("what is wrong with a table is said by line and column", "[csv]")
{
  CHECK(complaint("") == "pairs.csv:1:1: the file is empty; expected the header x,y");
  CHECK(complaint("a,b\n") == "pairs.csv:1:1: expected the header x,y");
  CHECK(complaint("x,y\n1,2\n3,abc\n") == "pairs.csv:3:2: y must be a number, got \"abc\"");
  CHECK(complaint("x,y\n1,2x\n") == "pairs.csv:2:2: y must be a number, got \"2x\"");
  CHECK(complaint("x,y\n1,+-2\n") == "pairs.csv:2:2: y must be a number, got \"+-2\"");
  CHECK(complaint("x,y\n,2\n") == "pairs.csv:2:1: x is missing");
  CHECK(complaint("x,y\n1\n") == "pairs.csv:2:2: expected 2 numbers, got 1");
  CHECK(complaint("x,y\n1,2,3\n") == "pairs.csv:2:3: expected 2 numbers, got 3");
  CHECK(complaint("x,y\n1,nan\n") == "pairs.csv:2:2: y must be finite, got nan");
  CHECK(complaint("x,y\n-inf,1\n") == "pairs.csv:2:1: x must be finite, got -inf");
  CHECK(complaint("x,y\n1,1e999\n") == "pairs.csv:2:2: y is beyond the range of double: 1e999");
}

TEST_CASE("a table with a header and no rows is empty, not wrong", "[csv]")
{
  CHECK(rows_of("x,y\n").empty());
}

TEST_CASE("a file that cannot be read is named", "[csv]")
{
  CHECK_THROWS_WITH(read_csv("no/such/file.csv", "x"), "cannot read no/such/file.csv");
  CHECK_THROWS_WITH(read_csv(".", "x"), "cannot read .");
}

TEST_CASE("a number's shortest text reads back as the same number", "[csv]")
{
  CHECK(round_trip(0.1) == "0.1");
  CHECK(round_trip(0.1f) == "0.1");
  CHECK(round_trip(1.0 / 3) == "0.3333333333333333");
  CHECK(round_trip(-0.0) == "0");
}

TEST_CASE("printed numbers have four digits and no negative zero", "[table]")
{
  CHECK(number(0.5) == "0.5");
  CHECK(number(1.0 / 3) == "0.3333");
  CHECK(number(-0.0) == "0");
  CHECK(number(1.25e-7) == "1.25e-07");
}

TEST_CASE("columns are as wide as their widest cell, numbers at the right", "[table]")
{
  Table table({"name", "n"});
  table.row({"ä", "5"});
  table.row({"longer", "12"});
  CHECK(table.text() == "name     n\nä        5\nlonger  12\n");
  CHECK_THROWS_AS(table.row({"one"}), std::logic_error);
  table.row({"none", "inf"});
  CHECK(table.text() == "name      n\nä         5\nlonger   12\nnone    inf\n");
}

TEST_CASE("a table in HTML has its first row as its head", "[table]")
{
  CHECK(
      html_table({{"way", "ns"}, {"a", "1"}}) ==
      "<table class=\"doxtable\"><tr><th>way</th><th>ns</th></tr>\n<tr><td>a</td><td>1</td></tr>\n"
      "</table>\n");
}

TEST_CASE("a program's failure is one sentence and status 1, wrong words are status 2", "[program]")
{
  const Run failed =
      run({"demo"},
          [](const Arguments&)
          {
            std::cout << "half";
            throw std::runtime_error("the disc is full");
          });
  CHECK(failed.status == 1);
  CHECK(failed.out.empty());
  CHECK(failed.err == "demo: error: the disc is full\n");
  const Run misspelt = run({"demo", "--piars", "x"}, [](const Arguments&) {});
  CHECK(misspelt.status == 2);
  CHECK(misspelt.err.find("--help") != std::string::npos);
  CHECK(run({"demo", "--scalar", "half"}, [](const Arguments&) {}).status == 2);
}

TEST_CASE("help names the options and the columns of --pairs", "[program]")
{
  const Run help = run({"demo", "--help"}, [](const Arguments&) {});
  CHECK(help.status == 0);
  CHECK(help.out.find("A demonstration.") != std::string::npos);
  CHECK(help.out.find("ax,ay,az,ar,bx,by,bz,br") != std::string::npos);
}

TEST_CASE("an option with one choice stands alone", "[program]")
{
  const auto value_after = [](std::vector<std::string> words)
  {
    std::vector<char*> argv;
    for (std::string& word : words)
    {
      argv.push_back(word.data());
    }
    std::string value;
    const Arguments arguments{
        .name = "demo", .summary = "", .options = {{"compare", "compare", "", {"yes"}}}};
    run_program(
        static_cast<int>(argv.size()), argv.data(), arguments,
        [&](const Arguments& given) { value = given.value("compare"); });
    return value;
  };
  CHECK(value_after({"demo"}).empty());
  CHECK(value_after({"demo", "--compare"}) == "yes");
}

TEST_CASE("a figure that cannot be written is named", "[program]")
{
  Arguments arguments;
  arguments.out = "/proc/no/such/folder";
  CHECK_THROWS_WITH(
      save_figure(arguments, "x.svg", "<svg/>"),
      "cannot write /proc/no/such/folder/x.svg: No such file or directory");
  CHECK_THROWS_AS(arguments.value("scalar"), std::logic_error);
}

TEST_CASE("options that would be ignored are refused before the run", "[program]")
{
  const Arguments arguments{
      .name = "demo",
      .summary = "",
      .options = {
          {"scene", "", "", {}, {}, {"scene-file"}},
          {"scene-file", "", "", {}},
          {"solver", "", "direct", {}, {"scene", "scene-file"}}}};
  bool ran = false;
  const auto called = [&](std::vector<std::string> words)
  {
    ran = false;
    return run(
        std::move(words), [&](const Arguments&) { ran = true; }, arguments);
  };
  const Run alone = called({"demo", "--solver", "soft"});
  CHECK(alone.status == 2);
  CHECK(
      alone.err ==
      "demo: error: --solver would be ignored without --scene or --scene-file (try --help)\n");
  CHECK_FALSE(ran);
  CHECK(called({"demo", "--solver", "soft", "--scene-file", "x"}).status == 0);
  CHECK(ran);
  const Run both = called({"demo", "--scene-file", "x", "--scene", "y"});
  CHECK(both.status == 2);
  CHECK(both.err.find("--scene-file would be ignored beside --scene;") != std::string::npos);
  CHECK_FALSE(ran);
}

TEST_CASE("what cannot be written, or is read, is refused before the run", "[program]")
{
  const Folder folder;
  const std::filesystem::path scene = folder.path / "scene.json";
  save_whole(scene, "a scene");
  std::filesystem::create_symlink(scene, folder.path / "link.csv");
  const Arguments arguments{
      .name = "demo",
      .summary = "",
      .options = {
          {"scene-file", "", "", {}, {}, {}, FileUse::read},
          {"frames", "", "", {}, {}, {}, FileUse::written}}};
  bool ran = false;
  const auto complaint_about = [&](std::vector<std::string> words)
  {
    ran = false;
    words.insert(words.begin(), {"demo", "--scene-file", scene.string()});
    const Run result = run(
        std::move(words),
        [&](const Arguments& given)
        {
          ran = true;
          if (!given.value("frames").empty())
          {
            save_whole(given.value("frames"), "frames");
          }
        },
        arguments);
    CHECK(result.status == (ran ? 0 : 1));
    return result.err;
  };
  const std::string overwrites = "demo: error: --frames would overwrite what --scene-file reads\n";
  const auto in_folder = [&](const char* name) { return (folder.path / name).string(); };
  CHECK(complaint_about({"--frames", scene.string()}) == overwrites);
  CHECK(complaint_about({"--frames", in_folder("./scene.json")}) == overwrites);
  CHECK(complaint_about({"--frames", in_folder("link.csv")}) == overwrites);
  CHECK(
      complaint_about({"--frames", in_folder("")}) ==
      "demo: error: cannot write " + in_folder("") + ": it is a folder\n");
  CHECK(
      complaint_about({"--frames", in_folder("scene.json/x.csv")}).find("cannot write") !=
      std::string::npos);
  CHECK(
      complaint_about({"--out", in_folder("scene.json")}).find("cannot write") !=
      std::string::npos);
  CHECK_FALSE(ran);
  CHECK(text_of(scene) == "a scene");

  CHECK(complaint_about({"--frames", in_folder("new/frames.csv")}).empty());
  CHECK(text_of(folder.path / "new/frames.csv") == "frames");
  CHECK(complaint_about({"--frames", "/dev/null"}).empty());
  CHECK(std::filesystem::is_character_file("/dev/null"));
  CHECK(files_in(folder.path) == 3); // scene.json, link.csv and new
}

TEST_CASE("a file is written whole or not at all, and leaves no other", "[program]")
{
  const Folder folder;
  const std::filesystem::path file = folder.path / "deep" / "figure.svg";
  save_whole(file, "first");
  save_whole(file, "second");
  CHECK(text_of(file) == "second");
  std::filesystem::create_symlink(file, folder.path / "link.svg");
  save_whole(folder.path / "link.svg", "third");
  CHECK(text_of(file) == "third");
  CHECK_THROWS_WITH(
      save_whole(
          file,
          [](std::ostream& stream)
          {
            stream << "half";
            throw std::runtime_error("out of ideas");
          }),
      "cannot write " + file.string() + ": out of ideas");
  CHECK_THROWS_AS(save_whole(folder.path / "deep", "x"), std::runtime_error);
  CHECK_THROWS_AS(save_whole(file / "below_a_file.svg", "x"), std::runtime_error);
  CHECK_THROWS_AS(save_whole("", "x"), std::runtime_error);
  CHECK(text_of(file) == "third");
  CHECK(files_in(file.parent_path()) == 1);
}

TEST_CASE("a disk that is full leaves what was there", "[program]")
{
  const Folder folder;
  const std::filesystem::path file = folder.path / "frames.csv";
  save_whole(file, "kept");
  {
    const SmallFiles only(4096);
    CHECK_THROWS_WITH(
        save_whole(file, std::string(1 << 20, 'x')),
        "cannot write " + file.string() + ": File too large");
  }
  CHECK(text_of(file) == "kept");
  CHECK(files_in(folder.path) == 1);
  CHECK_THROWS_WITH(
      save_whole("/dev/full", "x"), "cannot write /dev/full: No space left on device");
  CHECK(std::filesystem::is_character_file("/dev/full"));
}

namespace
{

/// Runs a program that answers the sum, or the inverse, of each row's numbers.
Run ask(const std::string& content, std::vector<std::string> words)
{
  const Folder folder;
  const std::filesystem::path file = folder.path / "rows.csv";
  std::ofstream(file) << content;
  words.insert(words.begin(), {"demo"});
  for (std::string& word : words)
  {
    word = word == "FILE" ? file.string() : word;
  }
  const auto questions = [](auto zero)
  {
    using Real = decltype(zero);
    using Numbers = std::vector<Real>;
    return std::vector<Question<Real>>{
        {"sum", "x,y", "sum",
         [](const PairsRow& row) { return Numbers{row.at<Real>(0) + row.at<Real>(1)}; }},
        {"inverse", "x", "inverse,negated",
         [](const PairsRow& row)
         {
           const Real x = row.at<Real>(0);
           return x == 0 ? Numbers{} : Numbers{1 / x, -1 / x};
         }}};
  };
  std::vector<char*> argv;
  for (std::string& word : words)
  {
    argv.push_back(word.data());
  }
  return caught(
      [&]
      {
        return run_asking_program(
            static_cast<int>(argv.size()), argv.data(), {.name = "demo", .summary = "Asks."},
            questions, [](const Arguments&) { std::cout << "own\n"; });
      });
}

} // namespace

TEST_CASE("what is asked of each row is answered as CSV, with an empty cell for no answer")
{
  CHECK(
      ask("x,y\n1,2\n.5,-1\n", {"--ask", "sum", "--pairs", "FILE"}).out ==
      "pair,sum\n0,3\n1,-0.5\n");
  CHECK(
      ask("x\n4\n0\n", {"--ask", "inverse", "--pairs", "FILE"}).out ==
      "pair,inverse,negated\n0,0.25,-0.25\n1,,\n");
  CHECK(
      ask("x\n3\n", {"--ask", "inverse", "--pairs", "FILE", "--scalar", "float"}).out ==
      "pair,inverse,negated\n0,0.33333334,-0.33333334\n");
  CHECK(ask("x,y\n1,2\n", {}).out == "own\n");
}

TEST_CASE("a question that is unknown, missing, or without rows is refused by name")
{
  CHECK(
      ask("x,y\n1,2\n", {"--pairs", "FILE"}).err.find("--pairs needs --ask") != std::string::npos);
  CHECK(
      ask("x,y\n1,2\n", {"--ask", "sum"}).err.find("--ask would be ignored without --pairs") !=
      std::string::npos);
  CHECK(ask("x,y\n1,2\n", {"--ask", "product", "--pairs", "FILE"}).status == 2);
  const Run wrong_header = ask("x\n1\n", {"--ask", "sum", "--pairs", "FILE"});
  CHECK(wrong_header.status == 1);
  CHECK(wrong_header.err.find("rows.csv:1:1: expected the header x,y") != std::string::npos);
  const Run too_large = ask("x\n1\n1e-320\n", {"--ask", "inverse", "--pairs", "FILE"});
  CHECK(too_large.err.find("rows.csv:3:1: the answer is too large") != std::string::npos);
  CHECK(too_large.out.empty());
}
