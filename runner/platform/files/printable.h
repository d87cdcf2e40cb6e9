#pragma once
// Text of unknown origin made safe to show, and file names made from it. Names, keys, file names, DNA and databases may
// hold bytes that a terminal obeys: they could move the cursor, rewrite earlier lines, change the window's title, or
// reverse the text.
#include <string>
#include <string_view>

namespace morula {

/// Returns the text with visible escapes for control characters (\x1b; from DEL on \u009b), characters that change the
/// direction or the lines of the text after them (U+061C, U+200E, U+200F, U+2028 to U+202E, U+2066 to U+2069), and
/// bytes that are not UTF-8 (\xff). Line ends and tabs stay.
std::string printable(std::string_view text);

/// Makes a text of one line printable: line ends and tabs become \n, \r and \t, so that data cannot add lines to a
/// message.
std::string printableLine(std::string_view text);

/// Returns a file name made from a text of unknown origin: the part after its last '/', with '_' for everything but
/// letters, digits, blanks and . - _ + ( ), and without leading dots. It has at most 100 bytes, and keeps its
/// extension. `fallback` if nothing is left. It is never "." or "..", never a path.
std::string safeName(std::string_view text, std::string_view fallback);

}  // namespace morula
