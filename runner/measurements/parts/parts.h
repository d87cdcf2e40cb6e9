#pragma once
// The parts of the program that a scenario engages, and the line of the scenario that asks for each. Other parts are
// not made in the run and cost nothing.
#include <string>
#include <vector>

#include "contacts/contact_search.h"
#include "scenario/scenario.h"

namespace morula {

struct Part {
  std::string name;
  bool engaged = false;
  std::string what;  // the method: "pair law", "velocity Verlet"; "" if there is only one
  // "file:line:column: key", an option, or "default"; for an absent part its possible request
  std::string why;
};

/// The requests of a run besides the scene itself.
struct RunAsk {
  ContactSearch search = ContactSearch::grid;
  bool pictures = true;
  std::string golden = {};  // the file that the result is compared with; "": none
};

/// Returns all parts, also absent ones, in the order of a run. Names are unique.
std::vector<Part> partsOf(const Scenario& scenario, const RunAsk& ask);

}  // namespace morula
