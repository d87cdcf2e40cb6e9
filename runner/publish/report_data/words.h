#pragma once
// The words that a page has for what results call by names.
#include <string>
#include <vector>

#include "document/document.h"
#include "drawing/drawing.h"
#include "files/text.h"
#include "report_data/run_facts.h"

namespace morula {

/// Why a run failed: what happened, and below it what was found out about it.
Finding failedBecause(Finding::Kind kind, const std::string& before, const std::string& failure);

/// How the run is called on its page (nameRuns).
const std::string& titleOf(const RunFacts& run);

/// Gives each run its title: "unique-four, seed 5"; runs of the same scenario and seed also say what their scenarios
/// differ in, "physics.pressure.constant 180" (that alone where all runs of the page are such), and where that is no
/// answer their id.
void nameRuns(std::vector<RunFacts>& runs);

Picture pngPicture(const Image& image, const std::string& what, const std::string& caption,
                   const std::string& name = {}, Picture::Size size = Picture::Size::usual);
Picture svgPicture(const Drawing& drawing, const std::string& what, const std::string& caption,
                   Picture::Size size = Picture::Size::usual);

/// The scenario file that the run was read from, as it was given.
std::string sourceOf(const RunFacts& run);

/// "./morula render FILE --run ID …"
std::string commandFor(const RunFacts& run, const std::string& verb, const std::string& options = {});

}  // namespace morula
