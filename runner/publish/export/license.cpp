#include "export/license.h"

#include <algorithm>
#include <vector>

#include "base/did_you_mean.h"
#include "base/error.h"

namespace morula {
namespace {

/// Those of the SPDX list (https://spdx.org/licenses) that results are published under. The newest of a
/// family stands first.
const std::vector<std::string> identifiers{"CC0-1.0",
                                           "CC-BY-4.0",
                                           "CC-BY-SA-4.0",
                                           "CC-BY-NC-4.0",
                                           "CC-BY-NC-SA-4.0",
                                           "CC-BY-ND-4.0",
                                           "CC-BY-NC-ND-4.0",
                                           "CC-BY-3.0",
                                           "CC-BY-SA-3.0",
                                           "CC-PDDC",
                                           "PDDL-1.0",
                                           "ODC-By-1.0",
                                           "ODbL-1.0",
                                           "CDLA-Permissive-2.0",
                                           "CDLA-Sharing-1.0",
                                           "MIT",
                                           "MIT-0",
                                           "0BSD",
                                           "BSD-2-Clause",
                                           "BSD-3-Clause",
                                           "ISC",
                                           "Apache-2.0",
                                           "MPL-2.0",
                                           "EUPL-1.2",
                                           "Unlicense",
                                           "GPL-3.0-or-later",
                                           "GPL-3.0-only",
                                           "GPL-2.0-or-later",
                                           "GPL-2.0-only",
                                           "LGPL-3.0-or-later",
                                           "LGPL-3.0-only",
                                           "LGPL-2.1-or-later",
                                           "LGPL-2.1-only",
                                           "AGPL-3.0-or-later",
                                           "AGPL-3.0-only"};

/// "CC-BY" or "CC-BY-4" of CC-BY-4.0: the name without its version, or with half of it.
bool begins(const std::string& identifier, const std::string& word) {
  return identifier.size() > word.size() && equalButForCase(identifier.substr(0, word.size()), word) &&
         (identifier[word.size()] == '-' || identifier[word.size()] == '.');
}

std::string probablyMeant(const std::string& word) {
  const auto family =
      std::find_if(identifiers.begin(), identifiers.end(), [&](const std::string& id) { return begins(id, word); });
  return family != identifiers.end() ? *family : closest(word, identifiers);
}

}  // namespace

std::string licenseUri(const std::string& license) {
  if (license.empty() || license.starts_with("https://") || license.starts_with("http://")) return license;
  for (const std::string& id : identifiers)
    if (equalButForCase(id, license)) return "https://spdx.org/licenses/" + id;
  const std::string meant = probablyMeant(license);
  throw InputError("'" + license + "' is no SPDX identifier that is known here" +
                   (meant.empty() ? "" : "; did you mean " + meant + "?") +
                   " Give an identifier as CC-BY-4.0 or CC0-1.0, or the licence's address (https://…)");
}

}  // namespace morula
