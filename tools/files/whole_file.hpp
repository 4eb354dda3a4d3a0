#pragma once

/// \file
/// \brief Files that are written whole or not at all.

#include <filesystem>
#include <functional>
#include <ostream>

namespace cookbook
{

/// Writes a file whole or not at all: what was there before stays until the last byte is written.
///
/// `write` fills a temporary file beside it, which is then renamed; a device is written directly.
/// Missing folders are made. Throws std::runtime_error that names the file where it cannot be
/// written.
void save_whole(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

/// The same for a text.
void save_whole(const std::filesystem::path& file, const std::string& text);

/// Throws what save_whole would throw, as far as that can be known before there is anything to
/// write; makes missing folders.
void check_place(const std::filesystem::path& file);

} // namespace cookbook
