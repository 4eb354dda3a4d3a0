#include "tools/plot/text.hpp"

#include "tools/plot/svg.hpp"

#include <algorithm>
#include <array>

namespace cookbook::plot
{
namespace
{

// Widths of ASCII 32 … 126 in thousandths of the font size, on the generous side of common
// sans-serif faces.
constexpr std::array<int, 95> ascii_widths{
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};

double run_width(std::string_view text)
{
  int width = 0;
  for (const char c : text)
  {
    const auto code = static_cast<unsigned char>(c);
    if (code >= 32 && code < 127)
    {
      width += ascii_widths[static_cast<std::size_t>(code - 32)];
    }
    else if (code >= 0xC0) // the first byte of a longer character
    {
      width += 700;
    }
  }
  return width / 1000.0;
}

} // namespace

std::vector<TextRun> text_runs(std::string_view text)
{
  std::vector<TextRun> runs;
  std::size_t begin = 0;
  for (std::size_t k = 0; k + 1 < text.size(); ++k)
  {
    const bool marked = (text[k] == '_' || text[k] == '^') && text[k + 1] == '{';
    const std::size_t end = marked ? text.find('}', k) : std::string_view::npos;
    if (end == std::string_view::npos)
    {
      continue;
    }
    if (k > begin)
    {
      runs.push_back({std::string(text.substr(begin, k - begin)), 0});
    }
    runs.push_back({std::string(text.substr(k + 2, end - k - 2)), text[k] == '^' ? 1 : -1});
    begin = end + 1;
    k = end;
  }
  if (begin < text.size())
  {
    runs.push_back({std::string(text.substr(begin)), 0});
  }
  return runs;
}

double text_width(std::string_view text, double font_size)
{
  double width = 0;
  for (const TextRun& run : text_runs(text))
  {
    width += run_width(run.text) * (run.shift == 0 ? 1 : script_scale);
  }
  return width * font_size;
}

std::vector<std::string> wrapped(std::string_view text, double font_size, double width)
{
  std::vector<std::string> lines;
  while (!text.empty())
  {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!lines.empty() && text_width(lines.back() + " " + word, font_size) <= width)
    {
      lines.back() += " " + word;
    }
    else
    {
      lines.push_back(word);
    }
  }
  return lines;
}

namespace svg
{

std::string text(const Eigen::Vector2d& baseline, std::string_view content, const Type& type)
{
  std::string inner;
  double shift = 0;
  for (const TextRun& run : text_runs(content))
  {
    const double wanted = run.shift * (run.shift > 0 ? -0.38 : -0.22) * type.size;
    const double dy = wanted - shift;
    shift = wanted;
    const std::string size = run.shift == 0 ? "" : number(script_scale * type.size);
    if (run.shift == 0 && dy == 0)
    {
      inner += escaped(run.text);
      continue;
    }
    inner += "<tspan dy=\"" + number(dy) + "\"" +
             (size.empty() ? "" : " font-size=\"" + size + "\"") + ">" + escaped(run.text) +
             "</tspan>";
  }
  const std::string transform = type.rotation == 0
                                    ? ""
                                    : " transform=\"rotate(" + number(type.rotation) + " " +
                                          number(baseline.x()) + " " + number(baseline.y()) + ")\"";
  return "<text class=\"cb-text cb-" + std::string(css_name(type.ink)) + "\" x=\"" +
         number(baseline.x()) + "\" y=\"" + number(baseline.y()) + "\" font-size=\"" +
         number(type.size) + "\"" + (type.strong ? " font-weight=\"600\"" : "") +
         " text-anchor=\"" + std::string(type.anchor) + "\"" + transform + ">" + inner +
         "</text>\n";
}

} // namespace svg
} // namespace cookbook::plot
