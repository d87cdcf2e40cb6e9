#pragma once
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "scenario/scenario.h"
#include "unit/scenario/every_part.h"
// Last, because of CHECK:
#include "catch.h"

namespace morula::test {

inline std::string readWhole(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline Scenario read(const std::string& text, const std::vector<Override>& overrides = {}) {
  return readScenario(text, "test.yaml", std::string(MORULA_SOURCE_DIR), overrides);
}

/// The messages that reading the text leads to; empty if it is a good scenario.
inline std::string complaints(const std::string& text, const std::vector<Override>& overrides = {}) {
  try {
    read(text, overrides);
    return "";
  } catch (const InputError& error) { return error.what(); }
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != text.npos);
  return text.replace(at, from.size(), to);
}

}  // namespace morula::test
