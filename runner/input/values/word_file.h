#pragma once
// Text files with a few words a line, where '#' begins a comment: names of cells, and what an organism is compared
// with.
#include <string>
#include <vector>

#include "yaml/problems.h"

namespace morula::scenario {

struct WordLine {
  int line, column;                // 1-based, of the first word; columns in bytes
  std::vector<std::string> words;  // one at least
};

/// The lines that hold words. Line ends are LF, CR LF or CR; a byte order mark is passed over. A file that is not
/// UTF-8, and a line with characters that show as blanks and are none, are problems that name the place in `file`;
/// `place` is where the scenario names the file.
std::vector<WordLine> readWordFile(std::string_view text, const std::string& file, const Place& place,
                                   Problems& problems);

}  // namespace morula::scenario
