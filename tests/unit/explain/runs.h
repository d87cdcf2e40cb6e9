#pragma once
// Runs of scenes in this process, unchanged or changed on the way.
#include "explain/run_source.h"
#include "unit/simulation/worlds.h"

namespace morula {

using Change = std::function<void(World&)>;

/// Returns a function that steps, and makes the change once step number `when` is done.
inline Change changingAt(std::uint64_t when, const Change& change) {
  return [=](World& w) {
    step(w);
    if (w.clock.step == when) change(w);
  };
}

inline OwnRun runOf(
    const Scene& scene, const char* name, const Change& advance = [](World& w) { step(w); },
    const Execution& how = {Isa::scalar, 1}) {
  return {name, [=] { return makeWorld(scene, how); }, advance};
}

}  // namespace morula
