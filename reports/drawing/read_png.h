#pragma once
// PNG files read back as pixels.
#include <string>

#include "image/image.h"

namespace morula {

/// The pixels of a PNG file's content; what shines through lies on `paper`. 16 bits a channel become 8. Throws
/// InputError that begins with `name` for another file, a damaged one, and one of more than 100 million pixels.
Image readPng(const std::string& bytes, const std::string& name);

}  // namespace morula
