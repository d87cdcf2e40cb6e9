#pragma once
// Pictures in memory and on disk.
#include <string>
#include <vector>

#include "base/error.h"
#include "image/colour.h"

namespace morula {

/// Opaque pixels, row by row from the top left.
struct Image {
  int width = 0, height = 0;
  std::vector<Colour> pixels;

  Image() = default;
  /// Throws InputError unless both sides are 1 to 16384.
  Image(int width, int height, Colour fill);

  Colour& at(int x, int y) { return pixels[std::size_t(y) * width + x]; }
  const Colour& at(int x, int y) const { return pixels[std::size_t(y) * width + x]; }
  friend bool operator==(const Image&, const Image&) = default;
};

/// What pictures are drawn on: near white, so that light cells still stand out against it.
inline constexpr Colour paper{0xfa, 0xfa, 0xf8};

/// Copies `source` into `target` with its top left corner at (x, y); what falls outside is cut off.
void paste(Image& target, const Image& source, int x, int y);

/// All images as tiles in rows of `columns` (0: as square as possible), with a gap of `gap` pixels. Tiles are
/// as large as the largest image; smaller ones stand centred. Throws InputError for no image.
Image contactSheet(const std::vector<Image>& images, int columns = 0, int gap = 8);

/// Writes an 8-bit RGB PNG, which says that Morula made it. Equal images give equal files on one libpng.
/// Replaces a picture, but no file of another kind. Throws FileError; no half-written file stays.
void writePng(const Image& image, const std::string& file);

/// True for a PNG that writePng wrote, by what it says of itself.
bool isOwnPng(const std::string& file);

/// Reads any PNG as opaque 8-bit RGB (transparent parts over white). Throws FileError.
Image readPng(const std::string& file);

}  // namespace morula
