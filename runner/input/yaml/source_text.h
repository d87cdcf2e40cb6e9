#pragma once
// The bytes of a scenario as text for YAML: UTF-8, lines end with LF, only spaces indent.
#include <string>
#include <string_view>
#include <vector>

#include "yaml/problems.h"

namespace morula::scenario {

class SourceText {
 public:
  /// Drops a UTF-8 byte order mark and turns CRLF into LF. Adds a problem for what YAML would misread: bytes that are
  /// not UTF-8, UTF-16, control characters (yaml-cpp takes some for the end of the file), tabs that indent, directives.
  SourceText(std::string_view bytes, Problems& problems);

  const std::string& text() const { return text_; }
  /// Returns line number `line`, from 1, without its end; empty beyond the last.
  std::string_view line(int line) const;
  bool hasLine(int line) const { return line >= 1 && static_cast<std::size_t>(line) <= lineStarts_.size(); }
  /// Returns the place, with the column in characters, of byte number `byte` (from 0) of a line.
  Place place(int line, int byte) const;

 private:
  std::size_t continuationsBefore(std::size_t place) const;
  std::string text_;
  std::vector<std::size_t> lineStarts_{0};
  // The number of UTF-8 continuation bytes before each block of bytes. A line may be as long as the file, and columns
  // are asked for at each of its words.
  static constexpr std::size_t blockBytes = 256;
  std::vector<std::size_t> continuations_{0};
};

}  // namespace morula::scenario
