#pragma once
// Which cells a text means, wherever a scenario selects some: one grammar.
//
//   cell NAME        the cell of this name
//   clone NAME       the cell of this name and all that descend from her
//   path AAB         the cell with this path (A and B from the egg on); path AAB*: with all that descend from her
//   generation 3     all cells three divisions from the egg
//   substance s*     all cells that hold the substance, or one that begins so
//   WORD             a cell's name, or a substance; refused if the word could mean both
#include <string>

#include "biology/dna.h"
#include "biology/cell_selection.h"
#include "values/cell_names.h"

namespace morula {

inline constexpr const char* cellsAllowed =
    "cell NAME, clone NAME, path AAB, path AAB*, generation N, or a substance (skin, s*)";

/// Reads it. Throws InputError "what is wrong; the remedy" for a name that no cell has, a substance that the DNA does
/// not have, and a word that could be both.
CellSelection selectionOf(const std::string& text, const CellNames& names, const Dna& dna);

/// Returns a measure with its cells by path, as readMeasure takes them: "volume of AAB" for "volume of cell ABp". A text
/// that selects no cells by a word of this grammar is returned unchanged, as "volume of AAB" or "count of skin" is; but
/// a word that is both a path or a substance and the name of another cell is refused with both readings. Throws
/// InputError as selectionOf does.
std::string measureByPaths(const std::string& measure, const CellNames& names, const Dna& dna);

/// The text that selectionOf reads as this selection, whatever names there are.
std::string selectionText(const CellSelection& selection);

}  // namespace morula
