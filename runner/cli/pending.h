#pragma once
// Results that differ from their goldens and wait for a review. They lie beside the program, never beside
// sources.
#include <filesystem>
#include <optional>
#include <vector>

#include "cli/simulate.h"
#include "golden/golden.h"

namespace morula::cli {

/// …/build/release/pending for …/build/release/morula.
std::filesystem::path pendingFolder();

/// Writes what a run showed, with a picture of its end, as pending/<family>/<name>.golden and .png. Where the
/// folder cannot be written it says so and goes on: nothing is lost but the convenience.
void putPending(const Scenario& scenario, const Simulation& run, const GoldenData& observed, bool quiet);
/// What waits for this scenario.
std::optional<Golden> findPending(const Scenario& scenario);
/// The picture that was written with it; the path may not exist.
std::filesystem::path pendingPicture(const Scenario& scenario);
/// Takes it away, accepted or rejected.
void removePending(const Scenario& scenario);
/// Names of the scenarios with results that wait, "thesis/unique-four", sorted.
std::vector<std::string> allPending();

}  // namespace morula::cli
