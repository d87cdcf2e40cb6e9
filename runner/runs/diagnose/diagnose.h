#pragma once
// Why a run failed, and what helps: measured in a rerun, not guessed.
#include <string>

#include "simulation/body_failure.h"
#include "simulation/world.h"

namespace morula {

/// Vertices times evaluations of the forces that a diagnosis takes at most: about ten seconds. Counted, not
/// timed, so that a failure reads the same on every machine.
constexpr double diagnosisLimit = 2e8;

/// The failure's text with what a rerun of the same scene has measured in place of a guess: which force did
/// the work in the last steps, which stability limit comes first, what was tried from the last good state,
/// and which of it helped. A run that went well pays nothing: this one is made again from its start, bit for
/// bit, as far as `diagnosisLimit` allows; otherwise the text says that nothing was tried.
std::string diagnose(const Scene& scene, const Execution& execution, const BodyFailure& failure);

}  // namespace morula
