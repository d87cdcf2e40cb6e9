// A good scenario with one mistake is refused at the mistake's place. Any damage at all: fuzz/readers.cpp.
#include "helpers.h"
#include "scenario/loading.h"

using namespace morula;
using namespace morula::test;

namespace {

struct KeyInText {
  std::string path;
  std::size_t at;
  int line, column;
};

/// Returns where the keys of `everyPart` stand, found by a plain text search that knows the text's layout.
std::vector<KeyInText> keysInText() {
  std::vector<KeyInText> found;
  const auto add = [&](const std::string& path) {
    // Another map has a key `cells`, too; the one to find stands at the margin.
    std::size_t at = path == "cells" ? everyPart.find("\ncells:") : 0;
    for (std::size_t begin = 0; begin <= path.size();) {
      const auto end = std::min(path.find('.', begin), path.size());
      at = everyPart.find(path.substr(begin, end - begin) + ":", at);
      begin = end + 1;
    }
    if (at == std::string::npos) return;
    const auto lineStart = everyPart.rfind('\n', at) + 1;
    found.push_back({path, at, 1 + static_cast<int>(std::count(everyPart.begin(), everyPart.begin() + at, '\n')),
                     static_cast<int>(at - lineStart) + 1});
  };
  for (const auto& p : scenario::parameterTable().parameters) add(p.path);
  for (const auto& s : scenario::parameterTable().sections)
    if (!s.path.empty()) add(s.path);
  return found;
}

}  // namespace

TEST_CASE("a misspelt key is refused at its place, whichever it is") {
  const auto keys = keysInText();
  REQUIRE(keys.size() >= 50);
  for (const auto& key : keys) {
    auto text = everyPart;
    text.insert(key.at, "zq");
    const auto told = complaints(text);
    const auto dot = key.path.rfind('.') + 1;
    INFO(key.path);
    CHECK(told.find("test.yaml:" + std::to_string(key.line) + ":" + std::to_string(key.column) + ": " +
                    key.path.substr(0, dot) + "zq" + key.path.substr(dot) + ": unknown key") != told.npos);
  }
}

TEST_CASE("a value of the wrong kind is refused in its line, whichever it is") {
  for (const auto& key : keysInText()) {
    if (key.path == "summary") continue;  // any text is a summary
    auto text = everyPart;
    const auto value = text.find(':', key.at) + 1;
    const auto end = text.find_first_of(",}\n", value);
    const bool isBlock = text.substr(value, end - value).find_first_not_of(" |") == std::string::npos;
    if (isBlock || text[value + 1] == '{' || text[value + 1] == '[') continue;
    text.replace(value, end - value, " {zq: 1}");
    INFO(key.path);
    CHECK(complaints(text).find("test.yaml:" + std::to_string(key.line) + ":") != std::string::npos);
  }
}

TEST_CASE("a required key that is missing is named") {
  for (const auto* key : {"morula", "name"}) {
    auto text = everyPart;
    const auto at = text.find(std::string(key) + ":");
    text.erase(at, text.find('\n', at) + 1 - at);
    CHECK(complaints(text).find(std::string(key) + ": is missing") != std::string::npos);
  }
}
