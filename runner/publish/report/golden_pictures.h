#pragma once
// Golden, now and their distance, on a page.
#include <string>

#include "check/beside_golden.h"
#include "document/document.h"

namespace morula {

/// The three pictures, or the only one that there is, and what is to be known of them. Where programs run, golden and now lie
/// over each other, too, to be swiped and blinked between. `name`: of what.
Document goldenPictures(const BesideGolden& beside, const std::string& name);

}  // namespace morula
