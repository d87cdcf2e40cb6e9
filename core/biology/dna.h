#pragma once
// The DNA of an organism: the same list of genes in every cell [Nilsson 2008, §4.4.1 and §5.1.2].
//
//   # a comment                    also behind a gene
//   START: a0, a1                  the egg's substances; may repeat
//   g1(a3|a1, a2)                  gene g1 produces a3 in a cell cycle if a1 and a2 are present
//   g2(a4|a1, !a2)                 gene g2 produces a4 if a1 is present and a2 is not: a2 represses it (ours)
//   g{n+1}(a{n+1}|a{n}) for n in 0..4   a line with a range: one line for each number from 0 to 4. In braces
//                                  stand n, n+1 or n-1, with any number, within names (ours)
//
// Names are made of letters, digits and '_', at most 100 of them, and begin with a letter. Eight of them act
// on the cell, see substances.h.
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/members.h"
#include "biology/state.h"

namespace morula {

struct Gene {
  std::string name;
  SubstanceId product = 0;
  std::vector<SubstanceId> inputs;      // sorted; all must be present
  std::vector<SubstanceId> repressors;  // sorted; none may be present
};
MORULA_MEMBERS(Gene, name, product, inputs, repressors)

struct Dna {
  std::vector<std::string> substances;  // all names, and A and B; sorted: a SubstanceId is an index of this list
  std::vector<SubstanceId> start;       // the substances that the egg holds; sorted
  std::vector<Gene> genes;              // as written, ranges written out
  std::string source;                   // the text that this was read from
  std::vector<std::string> warnings;    // lines, as of an InputError, about DNA that works but may not be meant
};
MORULA_MEMBERS(Dna, substances, start, genes, source, warnings)

/// The scene's uses of substances outside its DNA.
struct DnaSurroundings {
  std::set<std::string> given;    // substances that start cells get instead of START
  std::vector<std::string> read;  // names that colours, cycle lengths … read; a name, or its beginning and '*'
  /// Acting substances without effect in this scene, each with the reason and the remedy: "needs x; add x".
  std::map<std::string, std::string> inert;
  std::set<std::string> sensed;  // substances that the simulator inserts for what cells perceive
};

/// Reads DNA in the syntax above. `file` and `path` only name the place in messages. `firstLine` and `firstColumn`
/// (from 1) tell where the text begins in the file, for DNA inside a YAML block, where every line is indented alike.
/// Throws InputError with all errors, one line each: "file:line:column: [path: ]what is wrong; what would be right".
/// DNA that could never have an effect, such as an input that no gene produces, is an error. Without `surroundings`
/// (null) only DNA that no scene could make work is an error.
Dna parseDna(std::string_view text, const std::string& file, int firstLine = 1, int firstColumn = 1,
             const std::string& path = "", const DnaSurroundings* surroundings = nullptr);

/// Returns the id of a name, if the DNA knows the name.
std::optional<SubstanceId> findSubstance(const Dna& dna, std::string_view name);

}  // namespace morula
