#pragma once
// Texts split and joined, and texts of any content written for CSV, SQL, shells and YAML, from which the same text is
// read back. HTML: reports/page/page.h.
#include <string>
#include <string_view>
#include <vector>

namespace morula {

/// "a, b, c", or "a, b or c" with " or " before the last one.
std::string join(const std::vector<std::string>& words, const std::string& last = ", ");

/// The texts between separators, empty ones too; but nothing for a separator at the end.
std::vector<std::string> partsOf(std::string_view text, char separator);
/// Splits a text into lines, without their line feeds.
std::vector<std::string> linesOf(std::string_view text);
std::string firstLine(const std::string& text);
/// Splits a line into words at blanks and tabs, up to a '#', which begins a comment.
std::vector<std::string> wordsOf(std::string_view line);

/// Returns true if the text is not empty and holds only letters and digits of ASCII and the characters of `others`.
bool isMadeOf(std::string_view text, std::string_view others);

/// Writes a text as a cell of a Markdown table, which a bar would end.
std::string markdownCell(std::string text);
/// A text of unknown origin in Markdown: what would begin HTML, a link or an image stands for itself.
std::string markdownText(std::string_view text);
/// A text of unknown origin as code in Markdown: `text`, with more backticks around it where it has some.
std::string markdownCode(std::string_view text);

/// A field of comma-separated values, by RFC 4180: in quotes where it needs them, and an empty text as "", which is not
/// a missing one.
std::string csvField(std::string_view text);

/// The name of a table or a column in SQL.
std::string sqlName(std::string_view name);

/// A word of a POSIX shell. Not for its comments, which a line end in the word would end: put `oneLine` there.
std::string shellWord(std::string_view text);

/// A scalar of YAML that is this text, in quotes unless it is made of harmless letters. Without zero bytes.
std::string yamlText(std::string_view text);

}  // namespace morula
