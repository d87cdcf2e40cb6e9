#pragma once
// A check's result as JSON: what `morula check --json` shows of it, and its message.
#include "golden/check_result.h"
#include "system/json.h"

namespace morula {

Json toJson(const CheckResult& result);
/// Throws Json::exception for anything that toJson did not write.
CheckResult checkResultFrom(const Json& json);

}  // namespace morula
