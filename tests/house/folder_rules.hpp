/// \file
/// The rules of the house about folders: what stands where, and which file may include which.
#pragma once

#include "rules.hpp"

#include <functional>

namespace cookbook::house
{

/// A file of one source and what it includes from the house, as paths from the root.
struct Includes
{
  std::string path;
  std::vector<std::string> targets;
};

/// The includes of all sources; a target that is no file of the house is left out.
inline std::vector<Includes> includes_of(const std::vector<TextFile>& sources)
{
  std::set<std::string> paths;
  for (const TextFile& source : sources)
  {
    paths.insert(source.path);
  }
  std::vector<Includes> all;
  for (const TextFile& source : sources)
  {
    all.push_back({source.path, {}});
    for (const std::string& target :
         book::matches(source.text, R"rx((?:^|\n)#include "([^"]+)")rx"))
    {
      for (const std::string& path : {target, "recipes/" + target})
      {
        if (paths.count(path) == 1)
        {
          all.back().targets.push_back(path);
        }
      }
    }
  }
  return all;
}

/// The folder that a file stands in.
inline std::string folder_of(const std::string& path)
{
  return std::filesystem::path(path).parent_path().generic_string();
}

/// Whether a file stands in a trial.
inline bool in_trial(const std::string& path)
{
  return std::filesystem::path(path).parent_path().filename() == "trial";
}

/// The folders of more than 14 files, and how many they have.
inline Sizes large_folders(const std::vector<std::string>& paths)
{
  std::map<std::string, int> counts;
  for (const std::string& path : paths)
  {
    ++counts[folder_of(path)];
  }
  Sizes large;
  for (const auto& [folder, count] : counts)
  {
    if (count > 14)
    {
      large[folder] = std::to_string(count) + " files";
    }
  }
  return large;
}

/// A chapter's folder holds a folder a recipe and its CMakeLists.txt; that folder holds files and
/// its trial.
inline Complaints recipes_have_folders(const std::vector<std::string>& paths)
{
  static const std::regex place(
      R"(recipes/(CMakeLists\.txt|\d\d_\w+/(CMakeLists\.txt|\w+/(trial/)?[\w.]+)))");
  Complaints complaints;
  for (const std::string& path : paths)
  {
    if (path.rfind("recipes/", 0) == 0 && !std::regex_match(path, place))
    {
      complaints.push_back(path + " stands in no recipe's folder");
    }
  }
  return complaints;
}

/// What is exported stands alone: outside a trial, only programs and live figures include from one.
inline Complaints exported_stand_alone(const std::vector<TextFile>& sources)
{
  std::set<std::string> programs;
  for (const TextFile& source : sources)
  {
    if (source.text.find("int main(") != std::string::npos || source.path.ends_with("/live.cpp"))
    {
      programs.insert(source.path);
    }
  }
  Complaints complaints;
  for (const Includes& file : includes_of(sources))
  {
    for (const std::string& target : file.targets)
    {
      if (!in_trial(file.path) && in_trial(target) && programs.count(file.path) == 0)
      {
        complaints.push_back(file.path + " includes " + target);
      }
    }
  }
  return complaints;
}

/// Which folder includes which; programs are left out, for nothing includes them.
inline std::map<std::string, std::set<std::string>>
arrows_between_folders(const std::vector<TextFile>& sources)
{
  std::map<std::string, std::set<std::string>> arrows;
  for (const Includes& file : includes_of(sources))
  {
    if (file.path.ends_with(".cpp") && !in_trial(file.path))
    {
      continue;
    }
    for (const std::string& target : file.targets)
    {
      if (folder_of(target) != folder_of(file.path))
      {
        arrows[folder_of(file.path)].insert(folder_of(target));
      }
    }
  }
  return arrows;
}

/// No circles between folders of recipes, nor between trials.
inline Complaints folders_have_no_circles(const std::vector<TextFile>& sources)
{
  const auto arrows = arrows_between_folders(sources);
  enum class State
  {
    entered,
    left
  };
  std::map<std::string, State> states;
  Complaints complaints;
  const std::function<void(const std::string&, const std::string&)> visit =
      [&](const std::string& folder, const std::string& way)
  {
    states[folder] = State::entered;
    const auto found = arrows.find(folder);
    for (const std::string& next : found == arrows.end() ? std::set<std::string>{} : found->second)
    {
      const std::string longer = way + " → " + next;
      if (states.count(next) == 0)
      {
        visit(next, longer);
      }
      else if (states[next] == State::entered)
      {
        complaints.push_back("a circle: " + longer.substr(longer.find(next)));
      }
    }
    states[folder] = State::left;
  };
  for (const auto& [folder, targets] : arrows)
  {
    if (states.count(folder) == 0)
    {
      visit(folder, folder);
    }
  }
  return complaints;
}

} // namespace cookbook::house
