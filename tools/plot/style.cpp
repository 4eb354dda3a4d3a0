#include "tools/plot/style.hpp"

#include <array>

namespace cookbook::plot
{
namespace
{

// The colours of one scheme: paper first, then the inks in the order of the enumeration.
#define COOKBOOK_LIGHT                                                                             \
  "--cb-paper:var(--page-background-color,#ffffff);--cb-a:#1c5fa8;--cb-b:#e07b00;"                 \
  "--cb-overlap:#c8102e;--cb-ink:#1d2733;--cb-muted:#5d6875;--cb-good:#23803f;"                    \
  "--cb-faint:#d8dde3;--cb-series1:#1c5fa8;--cb-series2:#e07b00;--cb-series3:#23803f;"             \
  "--cb-series4:#8a4fbf;--cb-series5:#0b8a94;--cb-series6:#c2307c;--cb-series7:#857000;"           \
  "--cb-series8:#4f5b69;"
#define COOKBOOK_DARK                                                                              \
  "--cb-paper:var(--page-background-color,#16191d);--cb-a:#6db1ff;--cb-b:#ffab4a;"                 \
  "--cb-overlap:#ff6b7f;--cb-ink:#e8ecf1;--cb-muted:#9aa6b3;--cb-good:#62cf84;"                    \
  "--cb-faint:#3a424b;--cb-series1:#6db1ff;--cb-series2:#ffab4a;--cb-series3:#62cf84;"             \
  "--cb-series4:#c39bf0;--cb-series5:#4fd0d9;--cb-series6:#ff86bf;--cb-series7:#d9c34a;"           \
  "--cb-series8:#b3bfcc;"

constexpr std::string_view sheet =
    ".cookbook-figure{" COOKBOOK_LIGHT "display:block;max-width:100%;height:auto;margin:0 auto;"
    "font-family:system-ui,-apple-system,\"Segoe UI\",Roboto,\"Helvetica Neue\",Arial,"
    "sans-serif;font-variant-numeric:tabular-nums}\n"
    "@media (prefers-color-scheme:dark){.cookbook-figure{" COOKBOOK_DARK "}}\n"
    "html.light-mode .cookbook-figure{" COOKBOOK_LIGHT "}\n"
    "html.dark-mode .cookbook-figure{" COOKBOOK_DARK "}\n"
    ".cookbook-figure .cb-paper{fill:var(--cb-paper)}\n"
    ".cookbook-figure .cb-line{fill:none;stroke:var(--c);stroke-linejoin:round;"
    "stroke-linecap:round}\n"
    ".cookbook-figure .cb-fill{fill:var(--c)}\n"
    ".cookbook-figure .cb-wash{fill:var(--c);fill-opacity:.17;stroke:var(--c);"
    "stroke-linejoin:round;stroke-linecap:round}\n"
    ".cookbook-figure .cb-solid{fill:var(--c);stroke:var(--c);stroke-linejoin:round}\n"
    ".cookbook-figure .cb-open{fill:var(--cb-paper);stroke:var(--c);stroke-linejoin:round}\n"
    ".cookbook-figure .cb-shade{stop-color:var(--c)}\n"
    ".cookbook-figure .cb-text{fill:var(--c);stroke:var(--cb-paper);stroke-width:3px;"
    "stroke-opacity:.8;paint-order:stroke;stroke-linejoin:round}\n"
    ".cookbook-figure .cb-a{--c:var(--cb-a)}\n"
    ".cookbook-figure .cb-b{--c:var(--cb-b)}\n"
    ".cookbook-figure .cb-overlap{--c:var(--cb-overlap)}\n"
    ".cookbook-figure .cb-ink{--c:var(--cb-ink)}\n"
    ".cookbook-figure .cb-muted{--c:var(--cb-muted)}\n"
    ".cookbook-figure .cb-good{--c:var(--cb-good)}\n"
    ".cookbook-figure .cb-faint{--c:var(--cb-faint)}\n"
    ".cookbook-figure .cb-series1{--c:var(--cb-series1)}\n"
    ".cookbook-figure .cb-series2{--c:var(--cb-series2)}\n"
    ".cookbook-figure .cb-series3{--c:var(--cb-series3)}\n"
    ".cookbook-figure .cb-series4{--c:var(--cb-series4)}\n"
    ".cookbook-figure .cb-series5{--c:var(--cb-series5)}\n"
    ".cookbook-figure .cb-series6{--c:var(--cb-series6)}\n"
    ".cookbook-figure .cb-series7{--c:var(--cb-series7)}\n"
    ".cookbook-figure .cb-series8{--c:var(--cb-series8)}\n";

#undef COOKBOOK_LIGHT
#undef COOKBOOK_DARK

} // namespace

std::string_view css_name(Ink ink)
{
  constexpr std::array<std::string_view, 15> names{
      "a",       "b",       "overlap", "ink",     "muted",   "good",    "faint",  "series1",
      "series2", "series3", "series4", "series5", "series6", "series7", "series8"};
  return names[static_cast<std::size_t>(ink)];
}

Ink series_ink(std::size_t index)
{
  return static_cast<Ink>(static_cast<std::size_t>(Ink::series1) + index % 8);
}

Marker series_marker(std::size_t index)
{
  return static_cast<Marker>(static_cast<std::size_t>(Marker::circle) + (index + index / 8) % 8);
}

Stroke series_stroke(std::size_t index)
{
  return static_cast<Stroke>((index + index / 8) % 4);
}

std::string_view dash_array(Stroke stroke)
{
  constexpr std::array<std::string_view, 4> dashes{"", "6 4", "1.5 4", "9 4 1.5 4"};
  return dashes[static_cast<std::size_t>(stroke)];
}

std::string_view style_sheet()
{
  return sheet;
}

} // namespace cookbook::plot
