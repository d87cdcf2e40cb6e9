#pragma once
// The cause of a failure, and remedies, as measured in a rerun.
#include <string>

#include "simulation/body_failure.h"
#include "simulation/simulation.h"

namespace morula {

/// Max cost of a diagnosis [vertices times evaluations of the forces]: about ten seconds. The cost is counted and not
/// timed, so that a failure reads the same on every machine.
constexpr double diagnosisLimit = 2e8;

/// Returns the failure's text, with measurements of a rerun of the same scene in place of a guess: which force did the
/// work in the last steps, which stability limit comes first, what was tried from the last good state, and which of it
/// helped. The rerun starts anew, bit for bit, so runs without failure pay nothing. If `diagnosisLimit` is reached, the
/// text says so.
std::string diagnose(const Scene& scene, const Execution& execution, const BodyFailure& failure);

}  // namespace morula
