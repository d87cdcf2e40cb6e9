#pragma once
// Between text and Dna: what stands where, so that every diagnostic can name its place. Private to this room.
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "biology/dna.h"

namespace morula::dna_text {

struct Place {
  int line = 1, column = 1;  // in the user's file, from 1
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
  bool isStartReadable = true;            // false: the egg may hold more than `start`
  std::set<std::string> unreadableWords;  // names in lines that could not be read: they may be anything
};

/// Collects diagnostics; `file:line:column: [path: ]text` in the order of places.
class Diagnostics {
 public:
  void add(Place place, std::string text) { list_.push_back({place, std::move(text)}); }
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
};

/// The grammar: one line, one START list, gene or comment.
Lines readLines(std::string_view text, Place begin, Diagnostics& diagnostics);

/// The meaning: whatever is well written but cannot work. `surroundings` may be null.
void checkMeaning(const Lines& lines, const DnaSurroundings* surroundings, Diagnostics& diagnostics);

/// What could work and yet has no effect: a gene whose inputs are never present, a substance that nothing
/// reads, an acting substance misspelt or in a scene that does nothing with it. `surroundings` may be null.
void checkEffect(const Lines& lines, const DnaSurroundings* surroundings, Diagnostics& diagnostics,
                 Diagnostics& warnings);

std::string quoted(const std::string& text);

}  // namespace morula::dna_text
