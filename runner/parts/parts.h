#pragma once
// The parts of the program that a scenario engages, and which of its lines asks for each. A part that none
// asks for does not exist in the run and costs nothing.
#include <cstdint>
#include <string>
#include <vector>

#include "contacts/contact_search.h"
#include "scenario/scenario.h"

namespace morula {

struct Part {
  std::string name;
  bool engaged = false;
  std::string what;  // how it is done: "pair law", "velocity Verlet"; "" if there is but one way
  std::string
      why;  // "file:line:column: key", an option, or "default"; of an absent part what would ask for it
};

/// What a run does besides the scene itself.
struct RunAsk {
  ContactSearch search = ContactSearch::grid;
  bool pictures = true;
  std::string golden = {};  // the file that the result is held against; "": none
};

/// All parts there are, in the order of a run, absent ones among them. Names are unique.
std::vector<Part> partsOf(const Scenario& scenario, const RunAsk& ask);

/// [steps] from one hash of the state to the next, where the states on the way are hashed. Enough to tell at
/// which step two runs part; a hash costs about as much as a step. A lineage is hashed at every step.
constexpr std::uint64_t stepsPerHash = 64;

/// Whether the states on the way are hashed where the run is checked: to be held against a golden file, or as
/// `check` asks.
bool wantsHashes(const Scenario& scenario, bool hasGolden);

}  // namespace morula
