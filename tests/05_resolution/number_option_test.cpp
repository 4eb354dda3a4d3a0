/// \file
/// What holds for options that are numbers.

#include "tools/program/number_option.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

namespace
{

/// What a program says of `--speed TEXT` or `--steps TEXT`, or nothing where it takes it.
template <class Real>
std::string complaint(const std::string& name, const std::string& text, Real least, Real most)
{
  Arguments given{.name = "program", .summary = ""};
  given.options = {{name, "", text, {}}};
  try
  {
    number_option(given, name, least, most);
    return "";
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

} // namespace

TEST_CASE("a number within its range is taken, ends included, in any usual form")
{
  for (const char* text : {"0", "1", "0.5", "5e-1", ".5", "-0"})
  {
    CHECK(complaint(std::string("speed"), text, 0.0, 1.0) == "");
  }
  Arguments given{.name = "program", .summary = ""};
  given.options = {{"speed", "", "2.5e2", {}}, {"steps", "", "12", {}}};
  CHECK(number_option(given, "speed", 0.0, 1000.0) == 250);
  CHECK(number_option(given, "steps", 1, 100) == 12);
}

TEST_CASE("no number, too large, too small, infinite or followed by more: range and text are named")
{
  for (const std::string text :
       {"", "x", "1.5", "-1e-9", "nan", "inf", "1e999", "0.5x", "0,5", " 0.5", "+0.5"})
  {
    CHECK(
        complaint("speed", text, 0.0, 1.0) ==
        "--speed must be a number from 0 to 1, got '" + text + "'");
  }
}

TEST_CASE("where a whole number is asked for, a fraction is none")
{
  for (const std::string text : {"", "2.5", "1e1", "0", "101", "99999999999999999999"})
  {
    CHECK(
        complaint("steps", text, 1, 100) ==
        "--steps must be a whole number from 1 to 100, got '" + text + "'");
  }
}
