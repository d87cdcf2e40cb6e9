#pragma once
// The logical-gene model of cell control [Nilsson 2008, §4.4.1], compiled.
//
// A cell's state is the set of substances present. A cell cycle walks the genes once and builds the next state from
// their products alone: a substance must be produced in every cycle to stay. Division copies the state to both
// daughters and adds A to one and B to the other. So A, B and `divide` are gone after the daughters' next cycle, unless
// `divide` is produced again:
//
//   {a0} → cycle → {a1, divide} → division → {a1, divide, A} → cycle → {a2, divide} → …
//                                            {a1, divide, B} → cycle → {a3, divide} → …
//
// Compiled: each gene is looked up by its rarest input only, and the successor of each state is computed once and kept.
// A cell cycle is a table look-up however many genes there are.
//
// With senses a cycle reads the state without what was sensed before, and with what is sensed now. The next state holds
// the genes' products and what is sensed now. So a state shows what its cell perceived at its last cycle, and daughters
// inherit that until their own first cycle. The successor of a state depends on what is sensed, too:
//
//   {a1, touched} → cycle, nothing touches it → genes run on {a1}; → cycle, crowded → genes run on {a1, crowded}
#include <memory>
#include <span>

#include "biology/biological_unit.h"
#include "biology/dna.h"
#include "biology/parameters.h"

namespace morula {

/// Ids of states are given in the order in which states are first met: across runs, compare and store states by
/// `describe`, not by id. Only one thread may use the unit at a time. Throws InputError if `cycle` or a sense names a
/// substance that the DNA does not, and for more than 64 senses.
std::unique_ptr<BiologicalUnit> makeLogicalDna(const Dna& dna, const CycleParameters& cycle,
                                               std::span<const SenseParameters> senses = {});

}  // namespace morula
