#pragma once
// Text of unknown origin made safe to show, and file names made from it. Names, keys, file names, DNA and databases may
// hold bytes that a terminal obeys: they could move the cursor, rewrite earlier lines, change the window's title, or
// reverse what is read.
#include <string>
#include <string_view>

namespace morula {

/// The text with visible escapes in place of control characters (\x1b; from DEL on \u009b), of characters that change
/// the direction or the lines of what follows (U+061C, U+200E, U+200F, U+2028 to U+202E, U+2066 to U+2069) and of bytes
/// that are not UTF-8 (\xff). Line ends and tabs stay.
std::string printable(std::string_view text);

/// Makes a text of one line printable: line ends and tabs become \n, \r and \t, so that data cannot add lines of its
/// own to a message.
std::string printableLine(std::string_view text);

/// A file name made from a text of unknown origin: what follows its last '/', with '_' in place of everything but
/// letters, digits, blanks and . - _ + ( ), and without leading dots. At most 100 bytes, of which the extension is
/// kept. `fallback` if nothing is left. Never "." or "..", never a path.
std::string safeName(std::string_view text, std::string_view fallback);

}  // namespace morula
