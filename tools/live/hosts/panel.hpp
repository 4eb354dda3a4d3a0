#pragma once

/// \file
/// \brief What stands in a window around the picture: inputs at the right, numbers and curves
/// below.

#include "tools/live/hosts/controls.hpp"
#include "tools/live/hosts/text.hpp"

namespace cookbook::live
{

/// Where the parts of a window are [logical pixels]; the picture begins in the upper left corner.
struct Parts
{
  int picture_width, picture_height;
  int width, height; ///< of the window
};

/// The parts for a picture and so many inputs; the picture alone where there is no text.
Parts parts_for(const Session& session, bool with_panel);

/// The row of the panel's inputs at a place: its index, and where in its width, from 0 to 1.
struct PanelHit
{
  int row; ///< -1: none
  double part;
};
PanelHit panel_hit(const Parts& parts, double x, double y);

/// Draws the panels.
void draw_panel(SDL_Renderer* renderer, Text& text, const Controls& controls, const Parts& parts);

} // namespace cookbook::live
