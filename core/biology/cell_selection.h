#pragma once
// The living cells that a measure is taken of: the text behind "of" in "shell_share of AAA*".
#include <array>
#include <string>
#include <string_view>

#include "base/cell_path.h"
#include "base/members.h"

namespace morula {

constexpr int cloneDepth = 2;  // [divisions] default, from the egg to a clone's founder: four clones at most

/// A selection, in one grammar wherever a measure may be of some cells alone:
///
///   AAA, path AAA  the cell with this path, A and B from the egg on; path egg is the egg
///   AAA*           that cell and all that descend from it
///   generation 3   all cells three divisions from the egg
///   skin, s*       all cells that hold the substance, or one that begins so; also substance skin
///   clones         the descendants of each cell two divisions from the egg
///   cell NAME      the cell of this name
///   clone NAME     that cell and all that descend from it
struct CellSelection {
  enum class Kind { cell, clone, generation, substance, clones };
  Kind kind = Kind::substance;
  CellPath path{};          // of a cell or a clone
  int generation = 0;       // [divisions] from the egg
  std::string substance{};  // a pattern (biology/substance_pattern.h)

  /// Returns true if the selection has a cell with this path and these substances, as a state's text gives them.
  bool has(const CellPath& cell, std::string_view substances) const;
};
MORULA_MEMBERS(CellSelection, kind, path, generation, substance)

/// A selection as a text asks for it. The core knows no names: who knows them replaces a selection that isNamed() by
/// one with a path before use.
struct AskedCells : CellSelection {
  std::string name{};       // of a cell or a clone whose path is not known yet
  bool isExplicit = false;  // after the word "path" or "substance", so that no cell's name is meant

  bool isNamed() const { return !name.empty(); }
  /// Does what CellSelection::has does; throws BugError if the selection isNamed().
  bool has(const CellPath& cell, std::string_view substances) const;
  /// The selection as a scenario writes it.
  std::string text() const;
};

/// The words of a selection that another word follows.
inline constexpr std::array selectionWords{"generation", "cell", "clone", "path", "substance"};

/// The selections that may stand behind "of", for messages.
inline constexpr const char* selectionAllowed =
    "a path (AAA, or AAA* with all that descend from it), cell NAME, clone NAME, generation N, clones, or a substance "
    "(skin, s*)";

/// Reads a selection; the words "cell" and "clone" give one that isNamed(). Throws InputError that says what is wrong.
AskedCells parseSelection(const std::string& text);

}  // namespace morula
