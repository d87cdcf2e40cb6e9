#pragma once
// An accuracy report as other programs read it.
#include "accuracy/accuracy.h"
#include "cli/console.h"

namespace morula::cli {

Json toJson(const Setting& setting);
/// `picture`: where it lies.
Json toJson(const AccuracyReport& report, const std::string& picture);

}  // namespace morula::cli
