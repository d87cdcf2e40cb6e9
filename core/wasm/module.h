#pragma once
// The state that the functions of a module share, and how they report errors.
#include <new>
#include <optional>
#include <string>

#include "base/error.h"
#include "base/hash.h"
#include "simulation/simulation.h"

#define MORULA_EXPORT(name) __attribute__((export_name(#name)))

namespace morula::module {

inline std::optional<World> world;
inline std::optional<Hash> link;  // the last link of the chain of hashes
inline std::string given, said;   // the last text that came in, and the answer

enum Outcome { good, wrongInput, noPhysics, noMemory, aBug };

/// Runs `act` and returns its outcome. If it fails, `said` holds the error.
template <class Act>
Outcome outcomeOf(const Act& act) {
  try {
    act();
    return good;
  } catch (const InputError& error) {
    said = error.what();
    return wrongInput;
  } catch (const NumericalError& error) {
    said = error.what();
    return noPhysics;
  } catch (const std::bad_alloc&) {
    said = "there is no more memory";
    return noMemory;
  } catch (const std::exception& error) {
    said = error.what();
    return aBug;
  }
}

inline void begin(const Scene& scene, double memoryLimit = INFINITY) {
  link.reset();
  world.reset();
  Execution execution;
  execution.memoryLimit = memoryLimit;
  world.emplace(makeWorld(scene, execution));
}

}  // namespace morula::module
