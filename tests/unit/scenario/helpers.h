#pragma once
#include "scenario/scenario.h"
#include "temporary_folder.h"
#include "unit/scenario/every_part.h"
// Included last, because of CHECK:
#include "catch.h"

namespace morula::test {

/// A lineage alone, with required keys only.
inline const std::string small = "morula: 1\nname: x\ndna: 'START: a0'\nstop: {cells: 1}\n";

inline Scenario read(const std::string& text, const std::vector<Override>& overrides = {}) {
  return readScenario(text, "test.yaml", std::string(MORULA_SOURCE_DIR), overrides);
}

/// Returns the message with which `read` fails; empty if it succeeds.
template <class Read>
std::string refusalOf(Read read) {
  try {
    read();
    return "";
  } catch (const InputError& error) { return error.what(); }
}

/// Returns the messages that reading the text gives; empty for a good scenario.
inline std::string complaints(const std::string& text, const std::vector<Override>& overrides = {}) {
  return refusalOf([&] { read(text, overrides); });
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != text.npos);
  return text.replace(at, from.size(), to);
}

}  // namespace morula::test
