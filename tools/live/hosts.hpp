#pragma once

/// \file
/// \brief Where a live figure is shown besides a page: a still, a window, a terminal.

#include "tools/live/session.hpp"

#include <filesystem>
#include <string>

namespace cookbook::live
{

/// Writes the first state as HTML: what the book shows in print and where there is no WebAssembly.
///
/// Throws std::runtime_error if it cannot be written.
void write_still(
    const std::filesystem::path& path, const std::string& name, const Session& session);

/// Opens a file for the input of a figure that asks for one.
///
/// Throws std::runtime_error where it cannot be read, or no input asks; what the figure throws.
void open_file(Session& session, const std::filesystem::path& path);

/// Runs a figure in a "window" or in the "terminal" until the reader closes it.
///
/// Throws std::runtime_error where this program was built without, or where none can be opened.
void run_host(const std::string& host, const std::string& name, Session& session);

} // namespace cookbook::live
