#pragma once
// Lines of fields: CSV, TSV, or fields with blanks between them.
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "yaml/problems.h"

namespace morula::scenario {

inline constexpr std::size_t maxProblems = 20;  // reading ends after so many

/// Returns a header in small letters, without anything but letters and digits, and without a unit in brackets.
std::string headerWord(std::string_view header);

/// Goes through a text line by line. A byte order mark, empty lines and lines that begin with '#' are passed over; line
/// ends are LF, CR LF or CR. The first line decides what separates fields: a tab, else ';', else ',', else blanks.
/// Fields may stand in quotes. A line that cannot be read is a problem with its place.
class DelimitedText {
 public:
  DelimitedText(std::string_view text, Problems& problems);

  /// Reads the next line into fields(). Returns false at the end of the text, and after some twenty problems.
  bool next();

  const std::vector<std::string_view>& fields() const { return fields_; }
  int line() const { return number_; }  // from 1
  char separator() const { return separator_; }

  /// Reports a mistake of the present line at one of its fields; with {} at its beginning.
  void complain(std::string_view field, std::string what, std::string right, std::string_view path = {});

  /// Fields that had quotes within quotes. Fields are views into these, or into the text.
  std::deque<std::string> takeUnquoted() { return std::move(unquoted_); }

 private:
  void takeLine();
  bool isClean();
  bool split();
  bool takeQuoted(std::string_view& rest);

  std::string_view text_, line_;
  Problems& problems_;
  int number_ = 0;
  char separator_ = 0;
  std::vector<std::string_view> fields_;
  std::deque<std::string> unquoted_;
};

}  // namespace morula::scenario
