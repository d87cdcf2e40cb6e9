#pragma once
// Whether a verb can write what a picture's name promises.
#include <string>

namespace morula::cli {

/// Throws UsageError that names --output unless the file's ending asks for what `verb` writes: PNG, and where
/// it is a `drawing` (a chart or a tree) SVG and PDF.
void checkPictureName(const std::string& verb, const std::string& file, bool drawing);

}  // namespace morula::cli
