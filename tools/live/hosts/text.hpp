#pragma once

/// \file
/// \brief Text in a window: the glyphs of a font of the system.

#include <SDL.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace cookbook::live
{

/// A font in a window; without stb_truetype or a font it draws nothing.
class Text
{
public:
  /// `height` is that of a line [logical pixels].
  Text(SDL_Renderer* renderer, double height);
  ~Text();
  Text(const Text&) = delete;
  Text& operator=(const Text&) = delete;

  /// Whether there is a font.
  bool there() const { return font_ != nullptr; }

  /// How many pixels of the screen make one logical pixel; glyphs are drawn anew where it changes.
  void scale(double scale);

  /// How wide a text is [logical pixels].
  double width(const std::string& text);

  /// Draws UTF-8 from its left end and the upper edge of its line.
  void draw(const std::string& text, double x, double y, SDL_Color colour);

private:
  struct Font;
  struct Glyph
  {
    SDL_Texture* texture = nullptr;
    int width = 0, height = 0, left = 0, top = 0; ///< [pixels of the screen]
    double advance = 0;                           ///< [pixels of the screen]
  };
  const Glyph& glyph(int code);
  Glyph made(int code) const;
  void forget();

  SDL_Renderer* renderer_;
  std::unique_ptr<Font> font_;
  std::map<int, Glyph> glyphs_;
  double height_, scale_ = 1;
};

/// The code points of UTF-8; a byte that is none counts as one.
std::vector<int> code_points(const std::string& text);

} // namespace cookbook::live
