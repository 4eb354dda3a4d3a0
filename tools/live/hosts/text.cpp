#include "tools/live/hosts/text.hpp"

#include <cmath>
#include <fstream>
#include <iterator>

#if __has_include(<stb/stb_truetype.h>)
#define COOKBOOK_TRUETYPE
#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop
#endif

namespace cookbook::live
{

#ifdef COOKBOOK_TRUETYPE

/// A font's file, and what stb_truetype knows of it.
struct Text::Font
{
  std::vector<unsigned char> file;
  stbtt_fontinfo info;
  float scale;
  int ascent;
};

namespace
{

/// Where systems have a plain font.
constexpr const char* places[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/System/Library/Fonts/Helvetica.ttc"};

/// A file's bytes; none where it cannot be read.
std::vector<unsigned char> bytes_of(const char* path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

Text::Text(SDL_Renderer* renderer, double height) : renderer_(renderer), height_(height)
{
  for (const char* const place : places)
  {
    auto font = std::make_unique<Font>();
    font->file = bytes_of(place);
    const unsigned char* const data = font->file.data();
    if (!font->file.empty() &&
        stbtt_InitFont(&font->info, data, stbtt_GetFontOffsetForIndex(data, 0)) != 0)
    {
      font_ = std::move(font);
      scale(1);
      return;
    }
  }
}

void Text::scale(double scale)
{
  if (font_ == nullptr || (scale == scale_ && !glyphs_.empty()))
  {
    return;
  }
  forget();
  scale_ = scale;
  font_->scale = stbtt_ScaleForPixelHeight(&font_->info, float(height_ * scale));
  int descent = 0, gap = 0;
  stbtt_GetFontVMetrics(&font_->info, &font_->ascent, &descent, &gap);
}

Text::Glyph Text::made(int code) const
{
  Glyph glyph;
  int advance = 0, bearing = 0;
  stbtt_GetCodepointHMetrics(&font_->info, code, &advance, &bearing);
  glyph.advance = advance * double(font_->scale);
  unsigned char* const grey = stbtt_GetCodepointBitmap(
      &font_->info, font_->scale, font_->scale, code, &glyph.width, &glyph.height, &glyph.left,
      &glyph.top);
  if (grey == nullptr)
  {
    return glyph;
  }
  std::vector<unsigned char> pixels;
  for (int i = 0; i < glyph.width * glyph.height; ++i)
  {
    pixels.insert(pixels.end(), {255, 255, 255, grey[i]});
  }
  stbtt_FreeBitmap(grey, nullptr);
  glyph.texture = SDL_CreateTexture(
      renderer_, SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_STATIC, glyph.width, glyph.height);
  SDL_UpdateTexture(glyph.texture, nullptr, pixels.data(), 4 * glyph.width);
  SDL_SetTextureBlendMode(glyph.texture, SDL_BLENDMODE_BLEND);
  return glyph;
}

void Text::draw(const std::string& text, double x, double y, SDL_Color colour)
{
  if (font_ == nullptr)
  {
    return;
  }
  double pen = std::round(x * scale_);
  const double base = std::round(y * scale_ + font_->ascent * double(font_->scale));
  for (const int code : code_points(text))
  {
    const Glyph& one = glyph(code);
    const SDL_FRect place = {
        float((pen + one.left) / scale_), float((base + one.top) / scale_),
        float(one.width / scale_), float(one.height / scale_)};
    SDL_SetTextureColorMod(one.texture, colour.r, colour.g, colour.b);
    SDL_RenderCopyF(renderer_, one.texture, nullptr, &place);
    pen += std::round(one.advance);
  }
}

#else

struct Text::Font
{
};

Text::Text(SDL_Renderer* renderer, double height) : renderer_(renderer), height_(height) {}

void Text::scale(double scale)
{
  scale_ = scale;
}

Text::Glyph Text::made(int) const
{
  return {};
}

void Text::draw(const std::string&, double, double, SDL_Color) {}

#endif

Text::~Text()
{
  forget();
}

void Text::forget()
{
  for (const auto& [code, one] : glyphs_)
  {
    SDL_DestroyTexture(one.texture);
  }
  glyphs_.clear();
}

const Text::Glyph& Text::glyph(int code)
{
  const auto known = glyphs_.find(code);
  return known != glyphs_.end() ? known->second : glyphs_.emplace(code, made(code)).first->second;
}

double Text::width(const std::string& text)
{
  double sum = 0;
  for (const int code : there() ? code_points(text) : std::vector<int>())
  {
    sum += std::round(glyph(code).advance);
  }
  return sum / scale_;
}

std::vector<int> code_points(const std::string& text)
{
  std::vector<int> codes;
  for (std::size_t i = 0; i < text.size();)
  {
    const auto lead = static_cast<unsigned char>(text[i++]);
    int code = lead, more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : 0;
    if (more > 0)
    {
      code = lead & (0x3F >> more);
    }
    for (; more > 0 && i < text.size() && (text[i] & 0xC0) == 0x80; --more)
    {
      code = code << 6 | (text[i++] & 0x3F);
    }
    codes.push_back(code);
  }
  return codes;
}

} // namespace cookbook::live
