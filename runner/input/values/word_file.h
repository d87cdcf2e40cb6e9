#pragma once
// Text files with a few words a line, where '#' begins a comment: names of cells, and references of organisms.
#include <string>
#include <vector>

#include "yaml/problems.h"

namespace morula::scenario {

struct WordLine {
  int line, column;                // place of the first word, 1-based; columns in bytes
  std::vector<std::string> words;  // at least one
};

/// Returns the lines that hold words. Line ends are LF, CR LF or CR; a byte order mark is skipped. A file that is not
/// UTF-8, and characters that pass for blanks, are problems that name the place in `file`. `place`: where the scenario
/// names the file.
std::vector<WordLine> readWordFile(std::string_view text, const std::string& file, const Place& place,
                                   Problems& problems);

}  // namespace morula::scenario
