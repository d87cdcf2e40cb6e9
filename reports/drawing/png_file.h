#pragma once
// PNG files, written from pixels and read back.
#include <string>
#include <string_view>

#include "image/image.h"

namespace morula {

/// Returns the content of a PNG file, 8-bit RGB or RGBA, marked as made by Morula. Equal images give equal bytes with
/// one version of libpng. `perInch`: dots per inch that the file asks for in print; 0: it says nothing.
std::string pngFile(const Image& image, double perInch = 0);

/// Returns true if a file that begins with `head` is a PNG of pngFile; the first 64 bytes are enough.
bool isOwnPng(std::string_view head);

/// Returns the pixels of a PNG file's content; translucent pixels lie on `paper`, and 16 bits a channel become 8.
/// Throws InputError that begins with `name` for other files, damaged files, and more than 100 million pixels.
Image readPng(const std::string& bytes, const std::string& name);

}  // namespace morula
