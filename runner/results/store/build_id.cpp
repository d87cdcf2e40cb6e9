#include "base/hash.h"
#include "store/build_info.h"

namespace morula {

std::string librariesText(const BuildInfo& build) {
  std::string text;
  for (const auto& [library, version] : build.libraries)
    text += (text.empty() ? "" : "; ") + library + ' ' + version;
  return text;
}

std::string buildId(const BuildInfo& build) {
  Hasher hasher;
  hasher.field("sources").add(build.sources);
  hasher.field("compiler").add(build.compiler);
  hasher.field("flags").add(build.flags);
  hasher.field("target").add(build.target);
  hasher.field("libraries");
  for (const auto& [library, version] : build.libraries) hasher.add(library).add(version);
  return hasher.digest().text();
}

}  // namespace morula
