#pragma once
// Small things that are done to texts.
#include <string>
#include <string_view>
#include <vector>

namespace morula {

/// "a, b, c", or "a, b or c" with " or " before the last one.
std::string join(const std::vector<std::string>& words, const std::string& last = ", ");

/// Without their ends.
std::vector<std::string> linesOf(const std::string& text);
std::string firstLine(const std::string& text);
/// What stands between blanks and tabs, up to a '#', which begins a comment.
std::vector<std::string> wordsOf(std::string_view line);

/// As a cell of a Markdown table: a bar does not end it.
std::string markdownCell(std::string text);

}  // namespace morula
