/// \file
/// The rules of the house about any file: short, documented, tied to no machine.
#pragma once

#include "rules.hpp"

namespace cookbook::house
{

/// The headers of more than 200 lines, and how many they have.
inline Sizes large_headers(const std::vector<TextFile>& headers)
{
  Sizes large;
  for (const TextFile& header : headers)
  {
    const std::size_t count = book::lines(header.text).size();
    if (count > 200)
    {
      large[header.path] = std::to_string(count) + " lines";
    }
  }
  return large;
}

/// What is large has its reason in the list, a line "path: reason" each; what has one is large.
inline Complaints large_for_a_reason(const Sizes& large, const std::string& list)
{
  Complaints complaints;
  std::set<std::string> listed;
  for (const std::string& line : book::lines(list))
  {
    const std::size_t colon = line.find(": ");
    if (!line.empty() && line[0] != '#' && colon != std::string::npos)
    {
      listed.insert(line.substr(0, colon));
    }
  }
  for (const auto& [path, size] : large)
  {
    if (listed.erase(path) == 0)
    {
      complaints.push_back(path + " has " + size + "; tests/house/large.txt gives no reason");
    }
  }
  for (const std::string& path : listed)
  {
    complaints.push_back("tests/house/large.txt: " + path + " is not large");
  }
  return complaints;
}

/// Every type and function of a header opens with a `///` sentence, and every recipe's header
/// with `/// \file`.
///
/// What is looked at is the first line of each paragraph that starts at the left edge, as our
/// layout has it. A type that was declared before it is defined is documented there.
inline Complaints headers_are_documented(const std::vector<TextFile>& headers)
{
  static const std::regex start(
      "^(template|struct|class|enum|inline(?! namespace)|constexpr)\\b(?!.*(;|///<))");
  static const std::regex type("^(?:template <[^\n]*>\n)?(?:struct|class) (\\w+)(;|\n)");
  Complaints complaints;
  for (const TextFile& header : headers)
  {
    const bool recipe = header.path.rfind("recipes/", 0) == 0;
    if (recipe && header.text.find("/// \\file") == std::string::npos)
    {
      complaints.push_back(header.path + " has no /// \\file");
    }
    std::size_t offset = 0;
    bool opens = true;
    for (const std::string& line : book::lines(header.text))
    {
      std::smatch name;
      const std::string rest = header.text.substr(offset, 300);
      const bool declared =
          std::regex_search(rest, name, type) &&
          (name.str(2) == ";" || header.text.find("class " + name.str(1) + ";") < offset ||
           header.text.find("struct " + name.str(1) + ";") < offset);
      if (opens && !declared && std::regex_search(line, start))
      {
        complaints.push_back(header.path + ": no /// before " + line);
      }
      opens = line.empty() || line == "{" || line.rfind("// [", 0) == 0;
      offset += line.size() + 1;
    }
  }
  return complaints;
}

/// Words of the list, lines "pattern: instead" or "code: pattern: instead", are in none of the
/// files; those for code may be on pages.
inline Complaints
words_are_of_the_field(const std::vector<TextFile>& files, const std::string& list)
{
  Complaints complaints;
  for (std::string entry : book::lines(list))
  {
    const bool code_only = entry.rfind("code: ", 0) == 0;
    entry.erase(0, code_only ? 6 : 0);
    const std::size_t colon = entry.find(": ");
    if (entry.empty() || entry[0] == '#' || colon == std::string::npos)
    {
      continue;
    }
    const std::regex word(
        "(^|[^A-Za-z])(" + entry.substr(0, colon) + ")([^A-Za-z]|$)",
        std::regex::icase | std::regex::optimize);
    for (const TextFile& file : files)
    {
      std::size_t number = 0;
      for (const std::string& line :
           code_only&& file.path.ends_with(".md") ? Complaints{} : book::lines(file.text))
      {
        ++number;
        if (std::regex_search(line, word))
        {
          complaints.push_back(
              file.path + ":" + std::to_string(number) + ": write" + entry.substr(colon + 1) +
              ": " + line);
        }
      }
    }
  }
  return complaints;
}

/// Nothing names a folder of one machine, or the address of a package registry.
inline Complaints no_machine_is_named(const std::vector<TextFile>& files)
{
  // The words are put together here so that this file does not contain them.
  static const std::regex machine(
      std::string("(^|[\\s\"'`(=])/(wo") +
      "rk|tm"
      "p|ho"
      "me|ro"
      "ot|far"
      "m|Use"
      "rs)/|[A-Z]:\\\\Use"
      "rs|" +
      "(regis"
      "try|pro"
      "xy|artifac"
      "tory)\\.[a-z0-9.-]+\\.[a-z]+|" +
      "(pyp"
      "i\\.org|crat"
      "es\\.io)");
  Complaints complaints;
  for (const TextFile& file : files)
  {
    std::size_t number = 0;
    for (const std::string& line : book::lines(file.text))
    {
      ++number;
      if (line.size() < 2000 && std::regex_search(line, machine))
      {
        complaints.push_back(file.path + ":" + std::to_string(number) + ": " + line);
      }
    }
  }
  return complaints;
}

} // namespace cookbook::house
