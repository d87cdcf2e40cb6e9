#pragma once
// PNG files, written from pixels and read back.
#include <string>
#include <string_view>

#include "image/image.h"

namespace morula {

/// The content of a PNG file, 8-bit RGB or RGBA, which says that Morula made it. Equal images give equal bytes
/// on one libpng.
std::string pngFile(const Image& image);

/// Returns true if a file that begins so is a PNG that pngFile made; the first 64 bytes are enough.
bool isOwnPng(std::string_view head);

/// The pixels of a PNG file's content; what shines through lies on `paper`. 16 bits a channel become 8. Throws
/// InputError that begins with `name` for another file, a damaged one, and one of more than 100 million pixels.
Image readPng(const std::string& bytes, const std::string& name);

}  // namespace morula
