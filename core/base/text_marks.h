#pragma once
// Marks that editors leave in text files: byte order marks, and characters that show as nothing or as a blank.
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace morula {

/// Returns the text behind a byte order mark of UTF-8, or the whole text.
std::string_view withoutByteOrderMark(std::string_view text);

/// True if the text begins with a byte order mark of UTF-16, in either order of bytes.
bool isUtf16(std::string_view text);

/// Returns "U+00A0 no-break space" for a character beyond ASCII that shows as nothing or as a blank, or that changes
/// the direction of the text behind it; "" for all others.
std::string nameOfInvisible(char32_t c);

struct InvisibleCharacter {
  std::size_t at;  // byte of the text
  int column;      // 1-based, in characters
  std::string name;
};

/// Finds the first invisible character of a line; absent without one, or if bytes before it are not UTF-8.
std::optional<InvisibleCharacter> findInvisible(std::string_view line);

}  // namespace morula
