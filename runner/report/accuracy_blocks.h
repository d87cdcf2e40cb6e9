#pragma once
// The sections of a page of an accuracy run.
#include "report_data/accuracy_read.h"
#include "report_data/words.h"

namespace morula {

/// Error against CPU time: a line a series, a point a time step; the mesh's own error across, and the scenario as it is.
Section accuracyChartSection(const AccuracyRead& read);
/// For errors of 0.1, 0.01, … the settings that hold them for the least CPU time, ours and Bullet's, and what the mesh adds.
Section cheapestSection(const AccuracyRead& read);
/// Every setting; those that failed with their reasons.
Section settingsSection(const AccuracyRead& read);
/// What errors are held against: the reference, finer meshes, and how fast errors fall with the time step.
Section referenceSection(const AccuracyRead& read);

/// "1/128", or as a number.
std::string stepText(double timeStep);

}  // namespace morula
