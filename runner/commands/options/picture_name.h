#pragma once
// Whether a verb can write what a picture's name promises.
#include <string>

#include "options/verb.h"

namespace morula::cli {

/// Throws InputError unless the file's ending asks for what `verb` writes: PNG, and where it is a `drawing` (a chart or a
/// tree) SVG and PDF.
void checkPictureName(const std::string& verb, const std::string& file, bool drawing);

/// A file's name for which checkPictureName holds.
Reader<std::string> pictureName(const std::string& verb, bool drawing);

/// The name of a page. Throws InputError unless it ends in .html.
std::string readPageName(const std::string& name);

}  // namespace morula::cli
