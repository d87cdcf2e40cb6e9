#pragma once
// Questions and answers between the program and its other process, as JSON; doubles in their shortest exact
// form.
#include "engines/external_run.h"
#include "system/console.h"

namespace morula {

Json toJson(const OtherRun& run);
/// Throws nlohmann's exceptions for anything that toJson did not write.
OtherRun otherRunFrom(const Json& json);

}  // namespace morula
