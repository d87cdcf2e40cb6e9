#pragma once
// Titles, sentences, pictures and commands for runs on a page.
#include <string>
#include <vector>

#include "document/document.h"
#include "drawing/drawing.h"
#include "files/text.h"
#include "report_data/run_facts.h"

namespace morula {

/// Makes the finding on a failed run: what happened, and below it the diagnosis.
Finding failedBecause(Finding::Kind kind, const std::string& before, const std::string& failure);

/// Returns the run's title on its page (nameRuns).
const std::string& titleOf(const RunFacts& run);

/// Gives each run a title: "unique-four, seed 5". Titles of runs with the same scenario and seed also tell their
/// differing parameters, "physics.pressure.constant 180" (only these if all runs of the page are such), or else their
/// ids.
void nameRuns(std::vector<RunFacts>& runs);

Picture pngPicture(const Image& image, const std::string& what, const std::string& caption,
                   const std::string& name = {}, Picture::Size size = Picture::Size::usual);
Picture svgPicture(const Drawing& drawing, const std::string& what, const std::string& caption,
                   Picture::Size size = Picture::Size::usual);

/// Returns the scenario file of the run, as it was given.
std::string sourceOf(const RunFacts& run);

/// Returns a command "./morula render FILE --run ID …".
std::string commandFor(const RunFacts& run, const std::string& verb, const std::string& options = {});

}  // namespace morula
