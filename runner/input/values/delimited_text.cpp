#include "values/delimited_text.h"

#include <algorithm>
#include <functional>

#include "base/text_marks.h"
#include "base/utf8.h"

namespace morula::scenario {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

char separatorOf(std::string_view line) {
  for (const char c : {'\t', ';', ','})
    if (line.find(c) != line.npos) return c;
  return ' ';
}

}  // namespace

std::string headerWord(std::string_view header) {
  std::string word;
  for (const char c : header.substr(0, header.find_first_of("[(")))
    if (c >= 'A' && c <= 'Z') word += static_cast<char>(c - 'A' + 'a');
    else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) word += c;
  return word;
}

DelimitedText::DelimitedText(std::string_view text, Problems& problems)
    : text_(withoutByteOrderMark(text)), problems_(problems) {
  if (!isUtf16(text)) return;
  complain({}, "the file is UTF-16", "save it as UTF-8");
  text_ = {};
}

bool DelimitedText::next() {
  while (!text_.empty() && problems_.size() < maxProblems) {
    takeLine();
    if (trimmed(line_).empty() || line_.front() == '#' || !isClean()) continue;
    if (separator_ == 0) separator_ = separatorOf(line_);
    if (split()) return true;
  }
  return false;
}

void DelimitedText::complain(std::string_view field, std::string what, std::string right, std::string_view path) {
  const std::less_equal<const char*> precedes;
  const bool isInLine =
      field.data() && precedes(line_.data(), field.data()) && precedes(field.data(), line_.data() + line_.size());
  const int column = isInLine ? static_cast<int>(field.data() - line_.data()) + 1 : 1;
  problems_.add({std::max(number_, 1), column, ""}, path, std::move(what), std::move(right));
}

void DelimitedText::takeLine() {
  line_ = text_.substr(0, text_.find_first_of("\r\n"));
  text_.remove_prefix(line_.size());
  text_.remove_prefix(text_.starts_with("\r\n") ? 2 : text_.empty() ? 0 : 1);
  ++number_;
}

/// Returns false, and says so, if the line holds bytes that are not UTF-8, or characters that nobody sees.
bool DelimitedText::isClean() {
  if (std::ranges::all_of(line_, [](char c) { return (c >= ' ' && c < 0x7F) || c == '\t'; })) return true;
  for (std::string_view rest = line_; !rest.empty();) {
    const int length = utf8Length(rest);
    const bool isControl = length == 1 && (rest[0] < ' ' || rest[0] == 0x7F) && rest[0] != '\t';
    if (length == 0) complain(rest, "a byte is not UTF-8", "save the file as UTF-8");
    if (isControl) complain(rest, "a control character stands in the line", "save the table as plain text");
    if (length == 0 || isControl) return false;
    rest.remove_prefix(static_cast<std::size_t>(length));
  }
  const auto found = findInvisible(line_);
  if (found) complain(line_.substr(found->at), found->name + " stands in the line", "remove it");
  return !found;
}

/// Splits the line. Returns false, and says so, where quotes are wrong.
bool DelimitedText::split() {
  fields_.clear();
  std::string_view rest = line_;
  for (bool more = true; more;) {
    while (!rest.empty() && rest[0] != separator_ && (rest[0] == ' ' || rest[0] == '\t')) rest.remove_prefix(1);
    while (separator_ == ' ' && !rest.empty() && (rest[0] == ' ' || rest[0] == '\t')) rest.remove_prefix(1);
    if (separator_ == ' ' && rest.empty()) break;
    if (rest.starts_with('"')) {
      if (!takeQuoted(rest)) return false;
    } else {
      const std::size_t end = separator_ == ' ' ? rest.find_first_of(" \t") : rest.find(separator_);
      fields_.push_back(trimmed(rest.substr(0, end)));
      rest.remove_prefix(std::min(end, rest.size()));
    }
    more = !rest.empty();
    if (more) rest.remove_prefix(1);
  }
  return true;
}

/// Takes a field in quotes off the front, up to the separator behind it.
bool DelimitedText::takeQuoted(std::string_view& rest) {
  std::size_t close = rest.find('"', 1);
  bool holdsQuotes = false;
  while (close != rest.npos && rest.substr(close + 1).starts_with('"'))
    holdsQuotes = true, close = rest.find('"', close + 2);
  if (close == rest.npos) {
    complain(rest, "the quotes do not end in this line", "close them, and keep a row in one line");
    return false;
  }
  std::string_view field = rest.substr(1, close - 1);
  if (holdsQuotes) {
    std::string& text = unquoted_.emplace_back();
    for (std::size_t i = 0; i < field.size(); i += field[i] == '"' ? 2 : 1) text += field[i];
    field = text;
  }
  rest.remove_prefix(close + 1);
  const std::string_view behind = trimmed(rest.substr(0, rest.find(separator_)));
  rest.remove_prefix(std::min(rest.find(separator_), rest.size()));
  fields_.push_back(field);
  if (behind.empty()) return true;
  complain(behind, "text stands behind the quotes", "put all of the field in quotes");
  return false;
}

}  // namespace morula::scenario
