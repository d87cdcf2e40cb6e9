#pragma once
// The sections of a page of an accuracy run.
#include "accuracy/accuracy.h"
#include "document/document.h"

namespace morula {

/// Error against CPU time: a line a series, a point a time step; the mesh's own error across, and the scenario as it is.
PageSection accuracyChartSection(const AccuracyReport& report);
/// For errors of 0.1, 0.01, … the settings that hold them for the least CPU time, ours and Bullet's, and what the mesh adds.
/// `scenario`: its file, as a word of a command.
PageSection cheapestSection(const AccuracyReport& report, const std::string& scenario);
/// What errors are held against: the reference, finer meshes, and how fast errors fall with the time step.
PageSection referenceSection(const AccuracyReport& report);

}  // namespace morula
