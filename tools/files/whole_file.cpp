#include "tools/files/whole_file.hpp"

#include <cstring>
#include <fstream>
#include <stdexcept>

#include <unistd.h>

namespace cookbook
{

namespace
{

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& why)
{
  throw std::runtime_error("cannot write " + file.string() + ": " + why);
}

/// The file beside it that is filled first; another one for each program that runs.
fs::path part_of(const fs::path& file)
{
  fs::path part = file;
  return part += ".part" + std::to_string(getpid());
}

bool is_device(const fs::path& file)
{
  std::error_code none;
  return fs::exists(file, none) && !fs::is_regular_file(file, none);
}

void fill(const fs::path& file, const std::function<void(std::ostream&)>& write)
{
  errno = 0;
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  if (stream)
  {
    write(stream);
  }
  stream.close();
  if (!stream)
  {
    throw std::runtime_error(errno != 0 ? std::strerror(errno) : "the disk does not take it");
  }
}

/// Where the file is, links followed; its folder is made.
fs::path place_of(const fs::path& file)
{
  std::error_code error;
  if (file.empty())
  {
    refuse(file, "the name is empty");
  }
  if (file.has_parent_path())
  {
    fs::create_directories(file.parent_path(), error);
    if (error)
    {
      refuse(file, error.message());
    }
  }
  if (fs::is_directory(file, error))
  {
    refuse(file, "it is a folder");
  }
  const fs::path place = is_device(file) ? file : fs::weakly_canonical(file, error);
  if (error)
  {
    refuse(file, error.message());
  }
  if (fs::exists(place, error) && access(place.c_str(), W_OK) != 0)
  {
    refuse(file, std::strerror(errno));
  }
  return place;
}

void remove_quietly(const fs::path& file)
{
  std::error_code ignored;
  fs::remove(file, ignored);
}

} // namespace

void save_whole(const fs::path& file, const std::function<void(std::ostream&)>& write)
{
  const fs::path place = place_of(file);
  const fs::path part = is_device(place) ? place : part_of(place);
  try
  {
    fill(part, write);
    if (part != place)
    {
      fs::rename(part, place);
    }
  }
  catch (const std::exception& error)
  {
    if (part != place)
    {
      remove_quietly(part);
    }
    refuse(file, error.what());
  }
}

void save_whole(const fs::path& file, const std::string& text)
{
  save_whole(file, [&text](std::ostream& stream) { stream << text; });
}

void check_place(const fs::path& file)
{
  const fs::path place = place_of(file);
  if (is_device(place))
  {
    return;
  }
  const fs::path part = part_of(place);
  try
  {
    fill(part, [](std::ostream&) {});
  }
  catch (const std::exception& error)
  {
    refuse(file, error.what());
  }
  remove_quietly(part);
}

} // namespace cookbook
