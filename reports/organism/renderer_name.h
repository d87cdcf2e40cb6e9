#pragma once
// What draws the pictures here: only pictures of one renderer are the same to the pixel.
#include <string>

namespace morula {

/// "mesa-22.3.6/freetype-2.12.1/x86_64": one word.
std::string rendererName();

}  // namespace morula
