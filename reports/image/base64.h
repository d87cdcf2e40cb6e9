#pragma once
// Bytes as text, for files that hold pictures.
#include <string>
#include <string_view>

namespace morula {

/// Returns the base64 of bytes [RFC 4648], with padding.
std::string base64(std::string_view bytes);

}  // namespace morula
