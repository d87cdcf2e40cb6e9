#include <algorithm>

#include "base/hash.h"
#include "store/build_info.h"

namespace morula {

std::string librariesText(const BuildInfo& build) {
  std::string text;
  for (const auto& [library, version] : build.libraries) text += (text.empty() ? "" : "; ") + library + ' ' + version;
  return text;
}

std::vector<std::pair<std::string, std::string>> librariesFrom(const std::string& text) {
  std::vector<std::pair<std::string, std::string>> libraries;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find("; ", begin), text.size());
    const std::size_t space = text.rfind(' ', end - 1);
    libraries.emplace_back(text.substr(begin, space - begin), text.substr(space + 1, end - space - 1));
    begin = end + 2;
  }
  return libraries;
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
