#pragma once
// The living cells that a measure is taken of: the text behind "of" in "shell_share of AAA*".
#include <string>
#include <string_view>

#include "base/cell_path.h"
#include "base/members.h"

namespace morula {

constexpr int cloneDepth = 2;  // [divisions] default, from the egg to a clone's founder: four clones at most

/// A selection, in one grammar wherever a measure may be of some cells alone:
///
///   AAA            the cell with this path, A and B from the egg on
///   AAA*           that cell and all that descend from it
///   generation 3   all cells three divisions from the egg
///   skin, s*       all cells that hold the substance, or one that begins so
///   clones         the descendants of each cell two divisions from the egg
struct CellSelection {
  enum class Kind { cell, clone, generation, substance, clones };
  Kind kind = Kind::substance;
  CellPath path{};          // of a cell or a clone
  int generation = 0;       // [divisions] from the egg
  std::string substance{};  // a pattern (biology/substance_pattern.h)

  /// The selection as a scenario writes it.
  std::string text() const;
  /// Returns true if the selection has a cell with this path and these substances, as a state's text gives them.
  bool has(const CellPath& cell, std::string_view substances) const;
};
MORULA_MEMBERS(CellSelection, kind, path, generation, substance)

/// The selections that may stand behind "of", for messages.
inline constexpr const char* selectionAllowed =
    "a path (AAA, or AAA* with all that descend from it), generation N, clones, or a substance (skin, s*)";

/// Reads a selection. Throws InputError that says what is wrong.
CellSelection parseSelection(const std::string& text);

}  // namespace morula
