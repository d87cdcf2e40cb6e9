#pragma once
// The hashes of a run's states as JSON, as one program tells them another.
#include <string>

#include "explain/witness.h"

namespace morula {

std::string writeTrail(const Trail& trail);
/// Throws InputError for anything else.
Trail readTrail(const std::string& text);

}  // namespace morula
