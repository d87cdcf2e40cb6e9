#pragma once
// A golden from three runs: the result, the same again by another way, and a twin that shows how far one unit
// in the last place grows.
#include <string>

#include "golden/accept.h"
#include "loop/simulate.h"

namespace morula {

struct AcceptedRun {
  bool done = false;
  // The run made again by another way came to another end: nothing is accepted
  bool nondeterministic = false;
  // Another result than this one waits for a review and was looked at: nothing is accepted, and this one waits now
  bool other = false;
  std::string text = {};  // for people: what was accepted and what it changed
};

/// Runs the scenario, again with another instruction set and number of threads, and together with that its twin
/// (loop/twin_run.h); writes the golden only if both agree to the last bit. Throws InputError if a run fails or the
/// golden cannot be accepted, Interrupted if a signal comes.
AcceptedRun acceptRun(const Scenario& scenario, const Execution& how, const Acceptance& acceptance, bool quiet);

}  // namespace morula
