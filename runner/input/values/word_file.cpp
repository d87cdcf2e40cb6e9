#include "values/word_file.h"

#include <algorithm>

#include "base/text_marks.h"
#include "base/utf8.h"
#include "files/text.h"

namespace morula::scenario {
namespace {

/// Returns the column, in characters, of the first byte that is not UTF-8; 0 if there is none.
int columnOfBadByte(std::string_view line) {
  for (int column = 1; !line.empty(); ++column) {
    const int length = utf8Length(line);
    if (length == 0) return column;
    line.remove_prefix(static_cast<std::size_t>(length));
  }
  return 0;
}

}  // namespace

std::vector<WordLine> readWordFile(std::string_view text, const std::string& file, const Place& place,
                                   Problems& problems) {
  const auto complain = [&](int line, int column, const std::string& what) {
    problems.addForeign(place, file + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + what);
  };
  if (isUtf16(text)) {
    complain(1, 1, "the file is UTF-16; save it as UTF-8");
    return {};
  }
  text = withoutByteOrderMark(text);
  std::vector<WordLine> lines;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
    if (const int column = columnOfBadByte(line)) {
      complain(number, column, "a byte is not UTF-8; save the file as UTF-8");
      return {};
    }
    if (const auto found = findInvisible(line.substr(0, line.find('#')))) {
      complain(number, found->column, found->name + " stands in the line; remove it, or replace it by a space");
      continue;
    }
    WordLine read{number, 1, wordsOf(line)};
    if (read.words.empty()) continue;
    read.column = static_cast<int>(line.find(read.words[0])) + 1;
    lines.push_back(std::move(read));
  }
  return lines;
}

}  // namespace morula::scenario
