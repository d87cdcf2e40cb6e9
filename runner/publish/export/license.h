#pragma once
// Licences by the names that people know them by.
#include <string>

namespace morula {

/// The URI of a licence: a URI as it is, an SPDX identifier (case does not count) as
/// https://spdx.org/licenses/…; "" for "". Throws InputError for anything else, with what was probably meant.
std::string licenseUri(const std::string& license);

}  // namespace morula
