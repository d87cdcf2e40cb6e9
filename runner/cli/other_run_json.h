#pragma once
// Questions and answers between the program and its other process, as JSON; doubles in their shortest exact
// form.
#include "cli/console.h"
#include "cli/other_run.h"

namespace morula::cli {

Json toJson(const OtherRun& run);
/// Throws nlohmann's exceptions for anything that toJson did not write.
OtherRun otherRunFrom(const Json& json);

}  // namespace morula::cli
