#pragma once
// UTF-8 [RFC 3629].
#include <string_view>

namespace morula {

/// Returns the length in bytes of the UTF-8 character at the start of `text`. Returns 0 if there is none: overlong
/// forms, surrogates and code points beyond U+10FFFF are no characters.
int utf8Length(std::string_view text);

/// The code point of the first `length` bytes, which utf8Length has found to be a character.
char32_t utf8Value(std::string_view text, int length);

}  // namespace morula
