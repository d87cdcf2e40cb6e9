#pragma once
// What draws organisms here: only pictures of one renderer, without words, are the same to the pixel.
#include <string>

namespace morula {

/// "mesa-22.3.6/x86_64": one word.
std::string rendererName();

}  // namespace morula
