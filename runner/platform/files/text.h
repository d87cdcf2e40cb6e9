#pragma once
// Splits and joins texts, and writes texts of any content for CSV, SQL, shells and YAML so that they read back
// unchanged. HTML: reports/page/page.h.
#include <string>
#include <string_view>
#include <vector>

namespace morula {

/// Returns "a, b, c", or "a, b or c" if `last` is " or ".
std::string join(const std::vector<std::string>& words, const std::string& last = ", ");

/// Returns the texts between separators, including empty ones, but none after a separator at the end.
std::vector<std::string> partsOf(std::string_view text, char separator);
/// Splits a text into lines, without their line feeds.
std::vector<std::string> linesOf(std::string_view text);
std::string firstLine(const std::string& text);
/// Splits a line into words at blanks and tabs, up to a '#', which begins a comment.
std::vector<std::string> wordsOf(std::string_view line);

/// Returns true if the text is not empty and holds only letters and digits of ASCII and the characters of `others`.
bool isMadeOf(std::string_view text, std::string_view others);

/// Escapes the bars in a text, which would end a cell of a Markdown table.
std::string markdownCell(std::string text);
/// Writes a text of unknown origin in Markdown. Characters that would begin HTML, a link or an image are escaped.
std::string markdownText(std::string_view text);
/// Writes a text of unknown origin as code in Markdown: `text`, between more backticks than it holds in a row.
std::string markdownCode(std::string_view text);

/// Writes a field of CSV by RFC 4180, in quotes if needed. An empty text is "", which differs from a missing one.
std::string csvField(std::string_view text);

/// Quotes the name of a table or a column for SQL.
std::string sqlName(std::string_view name);

/// Writes a text as a word of a POSIX shell. For a comment of the shell, which a line end ends, use `oneLine`.
std::string shellWord(std::string_view text);

/// Writes a text as a scalar of YAML, in quotes unless all letters are harmless. The text must hold no zero bytes.
std::string yamlText(std::string_view text);

}  // namespace morula
