#pragma once
// The parts of the program that a scenario engages, and which of its lines asks for each. A part that none
// asks for does not exist in the run and costs nothing.
#include <string>
#include <vector>

#include "contacts/contact_search.h"
#include "scenario/scenario.h"

namespace morula {

struct Part {
  std::string name;
  bool engaged = false;
  std::string what;  // how it is done: "pair law", "velocity Verlet"; "" if there is but one way
  // "file:line:column: key", an option, or "default"; of an absent part what would ask for it
  std::string why;
};

/// The requests of a run besides the scene itself.
struct RunAsk {
  ContactSearch search = ContactSearch::grid;
  bool pictures = true;
  std::string golden = {};  // the file that the result is held against; "": none
};

/// All parts there are, in the order of a run, absent ones among them. Names are unique.
std::vector<Part> partsOf(const Scenario& scenario, const RunAsk& ask);

}  // namespace morula
