#pragma once
// A trail as text: how one program tells another where its run went.
#include <string>

#include "explain/witness.h"

namespace morula {

/// A line per state, `link STEP WHOLE CLOCK CONNECTIONS LINEAGE [PATH:HASH …]` (`-` for the egg's path), and
/// last `end STEP [FAILURE]`.
std::string writeTrail(const Trail& trail);
/// Throws InputError for anything else, which names the line.
Trail readTrail(const std::string& text);

}  // namespace morula
