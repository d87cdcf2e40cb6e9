#pragma once
// Between text and Dna: the parts of the text with their places, which diagnostics name. Private to this module.
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "biology/dna.h"

namespace morula::dna_text {

struct Place {
  int line = 1, column = 1;  // in the user's file, from 1
  bool isRepeated = false;   // in a line with a range, which is read for each of the range's numbers
};

struct Word {
  std::string text;
  Place place;
};

struct GeneLine {
  Word name, product;
  std::vector<Word> inputs;      // all must be present
  std::vector<Word> repressors;  // none may be present
};

struct Lines {
  Place begin;              // place of the whole text
  std::vector<Word> start;  // words of all START lines
  std::vector<GeneLine> genes;
  bool hasStartLine = false;              // also for a START line that could not be read
  bool areNamesKnown = true;              // false: START, or a range, may have said more than could be read
  std::set<std::string> unreadableWords;  // names in lines that could not be read: they may be anything
  std::size_t repeatedNames = 0;          // number of names that ranges wrote
};

/// Collects diagnostics, `file:line:column: [path: ]text`, in the order of places.
class Diagnostics {
 public:
  void add(Place place, std::string text) {
    if (isTold(place)) return;
    list_.push_back({place, std::move(text)});
    if (place.isRepeated) told_.insert({place.line, place.column});
  }
  /// True if the place is in a line with a range and has a diagnostic: one is enough for all numbers of the range.
  bool isTold(Place place) const { return place.isRepeated && told_.contains({place.line, place.column}); }
  /// Throws InputError if there are any diagnostics.
  void report(const std::string& file, const std::string& path);
  /// Returns all diagnostics, one line each.
  std::vector<std::string> lines(const std::string& file, const std::string& path);

 private:
  struct Diagnostic {
    Place place;
    std::string text;
  };
  std::vector<Diagnostic> list_;
  std::set<std::pair<int, int>> told_;  // line, column
};

/// Reads lines by the grammar: a START list, a gene or a comment each. A line with a range gives one for each number.
Lines readLines(std::string_view text, Place begin, Diagnostics& diagnostics);

/// Reports DNA that is well written but cannot work. `surroundings` may be null.
void checkMeaning(const Lines& lines, const DnaSurroundings* surroundings, Diagnostics& diagnostics);

/// Reports DNA that could work and yet has no effect: a gene whose inputs are never present, a substance that nothing
/// reads, an acting substance misspelt or in a scene that does nothing with it. `surroundings` may be null.
void checkEffect(const Lines& lines, const DnaSurroundings* surroundings, Diagnostics& diagnostics,
                 Diagnostics& warnings);

std::string quoted(const std::string& text);

}  // namespace morula::dna_text
