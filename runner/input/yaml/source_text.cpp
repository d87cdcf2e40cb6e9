#include "yaml/source_text.h"

#include <algorithm>

#include "base/text_marks.h"
#include "base/utf8.h"

namespace morula::scenario {
namespace {

bool isContinuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

std::string hex(unsigned char c) {
  constexpr char digits[] = "0123456789abcdef";
  return {'0', 'x', digits[c >> 4], digits[c & 15]};
}

}  // namespace

SourceText::SourceText(std::string_view bytes, Problems& problems) {
  bytes = withoutByteOrderMark(bytes);
  if (isUtf16(bytes)) {
    problems.add({}, "", "the file is UTF-16", "save it as UTF-8");
    return;
  }
  Place at;
  bool indenting = true;
  while (!bytes.empty()) {
    const int length = utf8Length(bytes);
    const char c = bytes[0];
    if (length == 0) {
      problems.add(at, "", "byte " + hex(static_cast<unsigned char>(c)) + " is not UTF-8", "save the file as UTF-8");
      text_.clear();
      lineStarts_ = {0};
      return;
    }
    const bool lineEnd = c == '\n' || bytes.starts_with("\r\n");
    if (length == 1 && !lineEnd && c != '\t' && (static_cast<unsigned char>(c) < 0x20 || c == 0x7F))
      problems.add(at, "", "control character " + hex(static_cast<unsigned char>(c)), "remove it");
    if (indenting && c == '\t') problems.add(at, "", "a tab indents", "YAML indents with spaces only");
    if (at.column == 1 && c == '%') problems.add(at, "", "a YAML directive", "scenarios do without; remove the line");
    if (lineEnd) {
      bytes.remove_prefix(c == '\r' ? 2 : 1);
      text_ += '\n';
      lineStarts_.push_back(text_.size());
      ++at.line;
      at.column = 1;
      indenting = true;
      continue;
    }
    // Invisible characters are allowed in texts. At the beginning of a line, and behind the colon of a key, they pass
    // for blanks.
    if (length > 1 && (indenting || text_.ends_with(':')))
      if (const std::string name = nameOfInvisible(utf8Value(bytes, length)); !name.empty())
        problems.add(at, "", name + " stands where a blank should be", "replace it by a space");
    indenting = indenting && c == ' ';
    text_.append(bytes.substr(0, length));
    bytes.remove_prefix(length);
    ++at.column;
  }
  std::size_t inside = 0;
  for (std::size_t i = 0; i < text_.size(); ++i) {
    inside += isContinuation(text_[i]);
    if ((i + 1) % blockBytes == 0) continuations_.push_back(inside);
  }
}

std::string_view SourceText::line(int line) const {
  if (!hasLine(line)) return {};
  const std::size_t begin = lineStarts_[line - 1];
  const std::size_t end = hasLine(line + 1) ? lineStarts_[line] - 1 : text_.size();
  return std::string_view(text_).substr(begin, end - begin);
}

std::size_t SourceText::continuationsBefore(std::size_t place) const {
  const std::size_t block = place / blockBytes;
  const auto begin = text_.begin() + static_cast<std::ptrdiff_t>(block * blockBytes);
  const auto end = text_.begin() + static_cast<std::ptrdiff_t>(place);
  return continuations_[block] + static_cast<std::size_t>(std::count_if(begin, end, isContinuation));
}

Place SourceText::place(int lineNumber, int byte) const {
  const auto before = line(lineNumber).substr(0, byte);
  const std::size_t begin = before.empty() ? 0 : static_cast<std::size_t>(before.data() - text_.data());
  const auto inside = continuationsBefore(begin + before.size()) - continuationsBefore(begin);
  return {lineNumber, byte + 1 - static_cast<int>(inside), ""};
}

}  // namespace morula::scenario
