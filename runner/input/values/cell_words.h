#pragma once
// The cells that a text selects, in one grammar wherever a user selects some [biology/cell_selection.h]:
//
//   cell NAME        the cell of this name
//   clone NAME       the cell of this name and all that descend from her
//   path AAB         the cell with this path (A and B from the egg on); path AAB*: with all that descend from her
//   generation 3     all cells three divisions from the egg
//   substance s*     all cells that hold the substance, or one that begins so
//   WORD             a cell's name, a path, or a substance; refused if the word could mean two of them
#include <string>

#include "biology/cell_selection.h"
#include "biology/dna.h"
#include "observation/asked_measure.h"
#include "values/cell_names.h"

namespace morula {

inline constexpr const char* cellsAllowed =
    "cell NAME, clone NAME, path AAB, path AAB*, generation N, or a substance (skin, s*)";

/// Reads a selection and finds its path. Throws InputError "what is wrong; the remedy" for a name that no cell has, a
/// substance that the DNA does not have, and a word that could mean two.
CellSelection selectionOf(const std::string& text, const CellNames& names, const Dna& dna);

/// Returns a selection by path or substance, which the core can use. Throws InputError as selectionOf does.
AskedCells resolved(const AskedCells& asked, const CellNames& names, const Dna& dna);

/// Returns the measure with its cells by path, under the name that the core reads: "volume of AAB" for "volume of cell
/// ABp". Throws InputError as selectionOf does.
AskedMeasure resolved(const AskedMeasure& measure, const CellNames& names, const Dna& dna);

/// The text that selectionOf reads as this selection, whatever names there are.
std::string selectionText(const CellSelection& selection);

}  // namespace morula
