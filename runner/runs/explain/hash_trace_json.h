#pragma once
// The hashes of a run's states as JSON, as one program tells them another.
#include <string>

#include "explain/run_source.h"

namespace morula {

std::string writeHashTrace(const HashTrace& trace);
/// Throws InputError for anything else.
HashTrace readHashTrace(const std::string& text);

}  // namespace morula
