#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cookbook::plot
{

/// A stretch of a text: on the line (0), raised (1) or lowered (-1).
struct TextRun
{
  std::string text;
  int shift;
};

/// Size of a raised or lowered run, relative to the line's.
inline constexpr double script_scale = 0.75;

/// Splits a text at its `_{sub}` and `^{super}` marks; a mark without its brace is plain text.
std::vector<TextRun> text_runs(std::string_view text);

/// Estimates the width of a text [pixels], `_{sub}` and `^{super}` counted smaller.
double text_width(std::string_view text, double font_size);

/// Breaks a text at its spaces into lines of at most `width` pixels, where words allow it.
std::vector<std::string> wrapped(std::string_view text, double font_size, double width);

} // namespace cookbook::plot
