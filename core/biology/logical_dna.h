#pragma once
// The logical-gene model of cell control [Nilsson 2008, §4.4.1], compiled.
//
// A cell's state is the set of substances present. A cell cycle walks the genes once and builds the next
// state from their products alone: a substance must be produced in every cycle to stay. Division copies the
// state to both daughters and adds A to one and B to the other, so these and `divide` are gone after the
// daughters' next cycle, unless `divide` is produced again:
//
//   {a0} → cycle → {a1, divide} → division → {a1, divide, A} → cycle → {a2, divide} → …
//                                            {a1, divide, B} → cycle → {a3, divide} → …
//
// Compiled: each gene is looked up by its rarest input only, and the successor of each state is computed once and
// kept, so that a cell cycle is a table look-up however many genes there are.
#include <memory>

#include "biology/biological_unit.h"
#include "biology/dna.h"
#include "biology/parameters.h"

namespace morula {

/// Ids of states are given in the order in which states are first met: compare and store states by
/// `describe`, not by id, across runs. Not for several threads at once. Throws InputError if `cycle` names a
/// substance that the DNA does not.
std::unique_ptr<BiologicalUnit> makeLogicalDna(const Dna& dna, const CycleParameters& cycle);

}  // namespace morula
