#pragma once

/// \file
/// \brief The reader's own scene: from a JSON file, with errors by line.

#include "06_world/scenes/trial/scene_text.hpp"

#include <filesystem>
#include <istream>

namespace cookbook
{

/// The scene in a stream of JSON, as scene_in() reads it; SceneError as there.
Scene read_scene(std::istream& stream, const std::string& file);

/// The same from a file, by whose name the scene is called; std::runtime_error if it cannot be
/// read.
Scene read_scene(const std::filesystem::path& path);

} // namespace cookbook
