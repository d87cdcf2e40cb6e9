#pragma once
// Texts of any content as they may stand in files of others: each reads back as the same text. HTML: reports/page/html.h.
#include <string>
#include <string_view>

namespace morula {

/// A field of comma-separated values, by RFC 4180: in quotes where it needs them, and an empty text as "", which is not a
/// missing one.
std::string csvField(std::string_view text);

/// The name of a table or a column in SQL.
std::string sqlName(std::string_view name);

/// A word of a POSIX shell. Not for its comments, which a line end in the word would end: put `oneLine` there.
std::string shellWord(std::string_view text);

/// A scalar of YAML that is this text, in quotes unless it is made of harmless letters. Without zero bytes.
std::string yamlText(std::string_view text);

}  // namespace morula
