#pragma once
// Results that differ from their goldens and wait for a review: <family>/<name>-<hash of its place>.golden, a .png with
// the end beside the golden's, and a .from with the scenario's file and the build. They lie in .pending of the
// project's golden folder. Places are relative to the project, so that they hold in a project that was copied or moved.
#include <filesystem>
#include <optional>
#include <vector>

#include "golden/golden.h"
#include "loop/simulate.h"

namespace morula {

/// Keeps what a run showed for a review, with a picture of the golden, of the run and of how far they are apart
/// (beside_golden.h). If the folder cannot be written, the call says so and goes on. Throws Interrupted if a signal comes
/// while the picture is made.
void putPending(const Scenario& scenario, const Simulation& run, const GoldenData& observed, const Execution& how,
                bool quiet);
/// Returns the result that waits for this scenario as it is now, if this build made it.
std::optional<GoldenData> findPending(const Scenario& scenario);
/// Returns the result that waits for this scenario, whatever build made it and whatever the scenario was then: the one
/// that people were shown. Throws InputError if its file was damaged.
std::optional<GoldenData> waitingResult(const Scenario& scenario);
/// Return the paths of the waiting result and of its picture, which may not exist.
std::filesystem::path pendingFile(const Scenario& scenario);
std::filesystem::path pendingPicture(const Scenario& scenario);
/// Takes it away: accepted, rejected, or the golden is met again.
void removePending(const Scenario& scenario);
/// The results that wait in the project of the current folder. Looking at them changes nothing.
struct PendingResults {
  std::vector<std::filesystem::path> scenarios;  // their files, sorted
  std::vector<std::filesystem::path> gone;       // results whose scenario is not there, sorted
};
PendingResults pendingResults();

}  // namespace morula
