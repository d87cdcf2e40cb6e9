#pragma once
// An accuracy report as other programs read it.
#include "accuracy/accuracy.h"
#include "system/console.h"

namespace morula {

Json toJson(const Setting& setting);
/// `picture`: where it lies.
Json toJson(const AccuracyReport& report, const std::string& picture);

}  // namespace morula
