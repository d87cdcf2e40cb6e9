#pragma once
// Between text and Dna: what stands where, so that every diagnostic can name its place. Private to this module.
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "biology/dna.h"

namespace morula::dna_text {

struct Place {
  int line = 1, column = 1;  // in the user's file, from 1
  bool isRepeated = false;   // in a line with a range: what stands here is read for each of its numbers
};

struct Word {
  std::string text;
  Place place;
};

struct GeneLine {
  Word name, product;
  std::vector<Word> inputs;      // that must be present
  std::vector<Word> repressors;  // that must not
};

struct Lines {
  Place begin;              // of the whole text
  std::vector<Word> start;  // of all START lines
  std::vector<GeneLine> genes;
  bool hasStartLine = false;              // even one that could not be read
  bool areNamesKnown = true;              // false: START, or a range, may have said more than could be read
  std::set<std::string> unreadableWords;  // names in lines that could not be read: they may be anything
  std::size_t repeatedNames = 0;          // that ranges wrote
};

/// Collects diagnostics; `file:line:column: [path: ]text` in the order of places.
class Diagnostics {
 public:
  void add(Place place, std::string text) {
    if (isTold(place)) return;
    list_.push_back({place, std::move(text)});
    if (place.isRepeated) told_.insert({place.line, place.column});
  }
  /// One diagnostic is enough for all that a range makes of one word.
  bool isTold(Place place) const { return place.isRepeated && told_.contains({place.line, place.column}); }
  /// Throws InputError if there are any.
  void report(const std::string& file, const std::string& path);
  /// All of them, one line each.
  std::vector<std::string> lines(const std::string& file, const std::string& path);

 private:
  struct Diagnostic {
    Place place;
    std::string text;
  };
  std::vector<Diagnostic> list_;
  std::set<std::pair<int, int>> told_;  // line, column
};

/// The grammar: one line, one START list, gene or comment; a line with a range gives as many as it has numbers.
Lines readLines(std::string_view text, Place begin, Diagnostics& diagnostics);

/// The meaning: whatever is well written but cannot work. `surroundings` may be null.
void checkMeaning(const Lines& lines, const DnaSurroundings* surroundings, Diagnostics& diagnostics);

/// Reports what could work and yet has no effect: a gene whose inputs are never present, a substance that nothing
/// reads, an acting substance misspelt or in a scene that does nothing with it. `surroundings` may be null.
void checkEffect(const Lines& lines, const DnaSurroundings* surroundings, Diagnostics& diagnostics,
                 Diagnostics& warnings);

std::string quoted(const std::string& text);

}  // namespace morula::dna_text
