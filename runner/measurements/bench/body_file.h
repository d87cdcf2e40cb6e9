#pragma once
// Bodies kept between two calls of the program, so that what took minutes is there at once. A cache: where
// there is no file, or another one than expected, the bodies are made again.
#include <filesystem>
#include <optional>
#include <vector>

#include "base/hash.h"
#include "physics/bodies.h"

namespace morula {

/// Nothing if there is no such file, if it was written under another key, or if it is damaged.
std::optional<std::vector<Body>> readBodies(const std::filesystem::path& file, const Hash& key);

/// Makes the folder too. Throws FileError; no half-written file stays.
void writeBodies(const std::filesystem::path& file, const Hash& key, const std::vector<Body>& bodies);

}  // namespace morula
