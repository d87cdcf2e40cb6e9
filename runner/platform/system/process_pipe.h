#pragma once
// What a process says through a pipe, and what to say when there is none.
#include <string>

#include "base/error.h"

namespace morula {

/// That a process could not be made or waited for, with the reason that errno holds.
FileError processError(const std::string& what);

/// What is written to the other end until it is closed.
std::string readToEnd(int from);

}  // namespace morula
