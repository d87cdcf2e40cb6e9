#pragma once
// What accuracy has found, as tables for a terminal and for pages.
#include "accuracy/accuracy.h"
#include "document/document.h"

namespace morula {

/// "1/128", or as a number; of steps that the scene chooses a share of them.
std::string stepText(double timeStep);
std::string stepText(const Setting& setting);

/// Every setting, and what its error is made of; below it those that failed with their reasons.
Document settingTables(const AccuracyReport& report);
/// How fast errors fall with the time step.
Table orderTable(const AccuracyReport& report);
/// The least CPU time for an error, ours and Bullet's.
Table bulletTable(const AccuracyReport& report);

}  // namespace morula
