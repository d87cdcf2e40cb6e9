#pragma once
// A trail as JSON: how one program tells another where its run went.
#include <string>

#include "explain/witness.h"

namespace morula {

std::string writeTrail(const Trail& trail);
/// Throws InputError for anything else.
Trail readTrail(const std::string& text);

}  // namespace morula
