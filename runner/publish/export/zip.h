#pragma once
// Zip files without compression, whose bytes depend on nothing but the files in them.
#include <string>
#include <utility>
#include <vector>

namespace morula {

/// Returns a zip of files, each a name in UTF-8 and its bytes, in this order. Throws FileError with the remedy if they
/// are larger than 4 GB together, or more than 65535.
std::string zipOf(const std::vector<std::pair<std::string, std::string>>& files, const std::string& remedy);

}  // namespace morula
