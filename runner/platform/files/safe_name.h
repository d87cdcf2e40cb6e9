#pragma once
// File names made from data.
#include <string>
#include <string_view>

namespace morula {

/// A file name made from a text of unknown origin: what follows its last '/', with '_' in place of everything but
/// letters, digits, blanks and . - _ + ( ), and without leading dots. At most 100 bytes, of which the extension is kept.
/// `fallback` if nothing is left. Never "." or "..", never a path.
std::string safeName(std::string_view text, std::string_view fallback);

}  // namespace morula
