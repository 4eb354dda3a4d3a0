/// \file
/// \brief Two triangles that cross, as letters.

// [example]
#include "02_primitives/plain_picture/plain_picture.hpp"

#include <iostream>

using namespace cookbook;

int main()
{
  const Colour a{28, 95, 168}, b{224, 123, 0};
  Picture picture = make_picture(48, 12);
  fill_triangle(picture, {2, 1, 0.2}, {46, 6, 0.8}, {2, 11, 0.2}, a);  // deeper to the right
  fill_triangle(picture, {46, 1, 0.2}, {46, 11, 0.2}, {2, 6, 0.8}, b); // deeper to the left
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
  {
    const std::uint32_t pixel = picture.pixels[i];
    std::cout << (pixel == to_pixel(a) ? 'A' : pixel == to_pixel(b) ? 'B' : '.');
    std::cout << (i % 48 == 47 ? "\n" : "");
  }
}
// [example]
