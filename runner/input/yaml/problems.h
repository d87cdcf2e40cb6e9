#pragma once
// Mistakes in a user's input, collected, sorted and told all at once.
#include <string>
#include <string_view>
#include <vector>

namespace morula::scenario {

/// The place at which something was written: a line and column of the file (from 1, columns in characters), or an
/// option.
struct Place {
  int line = 1, column = 1;
  std::string option;  // "--set physics.time_step"; not empty: line and column mean nothing
};

/// Returns "file:line:column", or the option.
std::string placeText(const std::string& file, const Place& place);

/// Collects mistakes, each one line: "<place>: <path>: <what>; <right>". Path and right may be empty. Control
/// characters become visible, so that no text of a file can pass for a line of the program.
class Problems {
 public:
  explicit Problems(const std::string& file);

  void add(const Place& place, std::string_view path, std::string what, std::string right = "");
  /// Takes over the lines of another reader's InputError, each "file:line:column: …"; `fallback` is the place
  /// of lines that name another file or none.
  void addForeign(const Place& fallback, std::string_view text);

  bool empty() const { return lines_.empty(); }
  std::size_t size() const { return lines_.size(); }
  const std::string& file() const { return file_; }
  /// Throws InputError with all lines, options last, if there are any.
  void throwIfAny() const;

 private:
  struct Line {
    bool fromOption;
    int line, column;
    std::string text;
  };
  std::string file_;
  std::vector<Line> lines_;
};

}  // namespace morula::scenario
