/// \file
/// Runs a program's body as the shell would run the program, and catches what it prints.
#pragma once

#include "tools/program/program.hpp"

#include <iostream>
#include <sstream>

namespace cookbook
{

/// Runs a program as the shell would, with standard output and errors caught.
struct Run
{
  int status;
  std::string out;
  std::string err;
};

/// What the programs of these tests can be called with, unless a test says otherwise.
inline const Arguments demo{
    .name = "demo",
    .summary = "A demonstration.",
    .pairs_header = "ax,ay,az,ar,bx,by,bz,br",
    .options = {{"scalar", "number type", "double", {"float", "double"}}}};

/// Calls a program's main part, and catches what it prints.
inline Run caught(const std::function<int()>& program)
{
  std::ostringstream out;
  std::ostringstream err;
  std::streambuf* const old_out = std::cout.rdbuf(out.rdbuf());
  std::streambuf* const old_err = std::cerr.rdbuf(err.rdbuf());
  const int status = program();
  std::cout.rdbuf(old_out);
  std::cerr.rdbuf(old_err);
  return {status, out.str(), err.str()};
}

inline Run
run(std::vector<std::string> words, const std::function<void(const Arguments&)>& body,
    const Arguments& arguments = demo)
{
  std::vector<char*> argv;
  for (std::string& word : words)
  {
    argv.push_back(word.data());
  }
  return caught(
      [&] { return run_program(static_cast<int>(argv.size()), argv.data(), arguments, body); });
}

} // namespace cookbook
