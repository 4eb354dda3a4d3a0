/// \file
/// \brief Reads scenes from files.

#include "06_world/scenes/trial/scene_file.hpp"

#include <fstream>
#include <iterator>

namespace cookbook
{

Scene read_scene(std::istream& stream, const std::string& file)
{
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return scene_in(text, file);
}

Scene read_scene(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path))
  {
    throw std::runtime_error("cannot read " + path.string());
  }
  return read_scene(stream, path.string());
}

} // namespace cookbook
