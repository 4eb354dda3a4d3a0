#pragma once

/// \file
/// \brief The reader's own level: from a JSON file, with errors by line.

#include "09_game/game/level.hpp"
#include "tools/files/json_file.hpp"

#include <filesystem>

namespace cookbook::game
{

/// The level in a JSON text; `file` is named where there is an error.
///
/// The text is an object with `name`, `birds` (how many), `bricks` and `pigs`. A brick is an object
/// with `material`, "wood" or "stone", `center` and `half_extents` [m]; a pig one with `center`,
/// `radius` [m] and `strength` [N s]. Lengths are seen from the side: two numbers, x to the right
/// and y up.
///
/// Throws SceneError for anything else, with the line and the reason; also for what check()
/// refuses.
Level read_level(const std::string& text, const std::string& file);

/// The same from a file; std::runtime_error if it cannot be read.
Level read_level(const std::filesystem::path& path);

/// The folder of the game's own levels, in the tree that this was compiled from.
std::filesystem::path levels_folder();

} // namespace cookbook::game
