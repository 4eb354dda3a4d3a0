/// \file
/// \brief The program of a live figure outside of a page: prints its tour, or what events make of
/// it, and writes its still.

#include "tools/live/hosts.hpp"
#include "tools/live/session.hpp"
#include "tools/program/program.hpp"

#include <iostream>

/// The name of the figure: written by cookbook_live in CMake.
extern const char* const cookbook_live_name;

namespace
{

using namespace cookbook;

/// Ten poses that try all inputs, each with the numbers that it shows.
void print_tour(live::Session& session)
{
  std::cout << "start\n" << session.numbers();
  for (const std::string& pose : session.tour())
  {
    session.send(pose);
    std::cout << "\n";
    for (std::size_t begin = 0; begin < pose.size(); begin = pose.find('\n', begin) + 1)
    {
      std::cout << "> " << pose.substr(begin, pose.find('\n', begin) - begin) << "\n";
    }
    std::cout << session.numbers();
  }
}

/// What events from standard input show, a block of lines for each.
void answer_events(live::Session& session)
{
  for (std::string event; std::getline(std::cin, event);)
  {
    session.send(event);
    std::cout << "> " << event << "\n" << session.numbers();
  }
}

} // namespace

int main(int argc, char** argv)
{
  const std::vector<Option> options = {
      {.name = "still",
       .help = "write the first state as HTML for the book",
       .value = "",
       .choices = {},
       .file = FileUse::written,
       .draws = false},
      {.name = "events",
       .help = "carry out events, a line each",
       .value = "no",
       .choices = {"no", "stdin"},
       .draws = false},
      {.name = "state", .help = "begin with the state of a link", .value = "", .choices = {}},
      {.name = "scene-file",
       .help = "open this file in the figure",
       .value = "",
       .choices = {},
       .file = FileUse::read,
       .draws = false},
      {.name = "host",
       .help = "where it is shown",
       .value = "text",
       .choices = {"text", "window", "terminal"}}};
  return run_program(
      argc, argv,
      {.name = cookbook_live_name,
       .summary = std::string("The live figure ") + cookbook_live_name +
                  ": prints ten poses and their numbers.",
       .options = options},
      [](const Arguments& given)
      {
        live::Session session(live::figure);
        if (!given.value("state").empty())
        {
          session.send("restore " + given.value("state"));
        }
        if (!given.value("scene-file").empty())
        {
          live::open_file(session, given.value("scene-file"));
        }
        if (given.value("host") != "text")
        {
          live::run_host(given.value("host"), cookbook_live_name, session);
        }
        else if (!given.value("still").empty())
        {
          live::write_still(given.value("still"), cookbook_live_name, session);
        }
        else if (given.value("events") == "stdin")
        {
          answer_events(session);
        }
        else
        {
          print_tour(session);
        }
      });
}
