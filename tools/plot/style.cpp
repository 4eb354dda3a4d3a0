#include "tools/plot/style.hpp"

#include <array>

namespace cookbook::plot
{
namespace
{

// The colours of one scheme, for figures that `where` selects. What is drawn takes them as its
// `color`, not from variables: viewers of pictures that know none would draw everything black.
// clang-format off
#define COOKBOOK_SCHEME(where, paper, a, b, good, overlap, ink, muted, faint, s4, s5, s6, s7, s8)  \
  where "{--cb-paper:" paper "}\n"                                                                 \
  where " .cb-paper," where " .cb-open{fill:" paper "}\n"                                          \
  where " .cb-text{stroke:" paper "}\n"                                                            \
  where " .cb-a," where " .cb-series1{color:" a "}\n"                                              \
  where " .cb-b," where " .cb-series2{color:" b "}\n"                                              \
  where " .cb-good," where " .cb-series3{color:" good "}\n"                                        \
  where " .cb-overlap{color:" overlap "}\n"                                                        \
  where " .cb-ink{color:" ink "}\n"                                                                \
  where " .cb-muted{color:" muted "}\n"                                                            \
  where " .cb-faint{color:" faint "}\n"                                                            \
  where " .cb-series4{color:" s4 "}\n"                                                             \
  where " .cb-series5{color:" s5 "}\n"                                                             \
  where " .cb-series6{color:" s6 "}\n"                                                             \
  where " .cb-series7{color:" s7 "}\n"                                                             \
  where " .cb-series8{color:" s8 "}\n"
#define COOKBOOK_LIGHT(where, paper)                                                               \
  COOKBOOK_SCHEME(                                                                                 \
      where, paper, "#1c5fa8", "#e07b00", "#23803f", "#c8102e", "#1d2733", "#5d6875", "#d8dde3",   \
      "#8a4fbf", "#0b8a94", "#c2307c", "#857000", "#4f5b69")
#define COOKBOOK_DARK(where, paper)                                                                \
  COOKBOOK_SCHEME(                                                                                 \
      where, paper, "#6db1ff", "#ffab4a", "#62cf84", "#ff6b7f", "#e8ecf1", "#9aa6b3", "#3a424b",   \
      "#c39bf0", "#4fd0d9", "#ff86bf", "#d9c34a", "#b3bfcc")
// clang-format on

constexpr std::string_view sheet =
    ".cookbook-figure{display:block;max-width:100%;height:auto;margin:0 auto;"
    "font-family:system-ui,-apple-system,\"Segoe UI\",Roboto,\"Helvetica Neue\",Arial,"
    "sans-serif;font-variant-numeric:tabular-nums}\n"
    ".cookbook-figure .cb-line{fill:none;stroke:currentColor;stroke-linejoin:round;"
    "stroke-linecap:round}\n"
    ".cookbook-figure .cb-fill{fill:currentColor}\n"
    ".cookbook-figure .cb-wash{fill:currentColor;fill-opacity:.17;stroke:currentColor;"
    "stroke-linejoin:round;stroke-linecap:round}\n"
    ".cookbook-figure .cb-solid{fill:currentColor;stroke:currentColor;stroke-linejoin:round}\n"
    ".cookbook-figure .cb-open{stroke:currentColor;stroke-linejoin:round}\n"
    ".cookbook-figure .cb-shade{stop-color:currentColor}\n"
    ".cookbook-figure .cb-text{fill:currentColor;stroke-width:3px;"
    "stroke-opacity:.8;paint-order:stroke;stroke-linejoin:round}\n"                            //
    COOKBOOK_LIGHT(".cookbook-figure", "#ffffff")                                              //
    "@media (prefers-color-scheme:dark){\n" COOKBOOK_DARK(".cookbook-figure", "#16191d") "}\n" //
    COOKBOOK_LIGHT("html.light-mode .cookbook-figure", "var(--page-background-color,#ffffff)") //
    COOKBOOK_DARK("html.dark-mode .cookbook-figure", "var(--page-background-color,#16191d)");

#undef COOKBOOK_SCHEME
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
