#pragma once
// A scenario's run as a witness that can be asked about its states (runner/explain).
#include "explain/witness.h"
#include "loop/simulate.h"

namespace morula {

/// A signal has come while runs were made that leave nothing behind.
struct Interrupted {
  int signal;
};

/// Throws Interrupted if a signal has come, while a SignalWatch lives.
void stopAtSignal();

/// The scenario, which must outlive it, computed so; stops at signals.
OwnRun scenarioRun(const Scenario& scenario, const Execution& how);

}  // namespace morula
