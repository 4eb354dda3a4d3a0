#include "tools/files/whole_file.hpp"
#include "tools/live/hosts.hpp"
#include "tools/plot/style.hpp"

#include <cstdint>

#if __has_include(<stb/stb_image_write.h>)
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define COOKBOOK_PNG
#include <stb/stb_image_write.h>
#endif

namespace cookbook::live
{

#ifdef COOKBOOK_PNG
namespace
{

std::string base64(std::span<const unsigned char> bytes)
{
  static constexpr char digits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      three = three << 8U | (i + k < bytes.size() ? bytes[i + k] : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      out += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63U];
    }
  }
  return out;
}

/// The picture that is shown, as an image within the page.
std::string picture_html(const Session& session, const std::string& name)
{
  std::vector<unsigned char> png;
  const auto take = [](void* context, void* data, int size)
  {
    const auto* bytes = static_cast<unsigned char*>(data);
    static_cast<std::vector<unsigned char>*>(context)->insert(
        static_cast<std::vector<unsigned char>*>(context)->end(), bytes, bytes + size);
  };
  const int width = session.picture_width(), height = session.picture_height();
  stbi_write_png_to_func(take, &png, width, height, 4, session.pixels().data(), 4 * width);
  return "<img class=\"live-picture\" width=\"" + std::to_string(width) + "\" height=\"" +
         std::to_string(height) + "\" alt=\"" + name +
         ": the first state\" src=\"data:image/png;base64," + base64(png) + "\"/>\n";
}

} // namespace
#endif

void write_still(const std::filesystem::path& path, const std::string& name, const Session& session)
{
  std::string html;
#ifdef COOKBOOK_PNG // where it is not there, a still has no picture
  if (session.picture_width() > 0)
  {
    html += picture_html(session, name);
  }
#endif
  if (session.svg().empty()) // what is drawn later, such as curves, needs it
  {
    html += "<style>\n" + std::string(plot::style_sheet()) + "</style>\n";
  }
  html += session.svg() + "<dl class=\"live-numbers\">\n";
  for (const Reading& one : session.readings())
  {
    html += "<div><dt>" + one.name + "</dt><dd>" + one.value +
            (one.unit.empty() ? "" : " " + one.unit) + "</dd></div>\n";
  }
  save_whole(path, html + "</dl>\n");
}

} // namespace cookbook::live
