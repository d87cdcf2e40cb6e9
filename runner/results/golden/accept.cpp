#include "golden/accept.h"

#include <algorithm>
#include <cstdlib>

#include "base/error.h"
#include "files/folders.h"
#include "files/printable.h"
#include "files/write_file.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

/// Throws InputError for a text that a golden cannot carry. `form`: the correct form, for the message.
void requireOneLine(const std::string& place, const std::string& text, const std::string& form) {
  constexpr std::size_t maxLetters = 1000;
  const auto isFirstByte = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  if (text.find_first_not_of(" \t") == text.npos || text.find_first_of("\r\n") != text.npos)
    throw InputError(place + ": " + form);
  if (const std::string seen = printableLine(text); seen != text)
    throw InputError(
        place + ": '" + seen.substr(0, 200) +
        "' holds control characters, characters that change the direction of a text, or bytes that are not "
        "UTF-8; leave them out");
  if (const auto letters = std::ranges::count_if(text, isFirstByte); letters > std::ptrdiff_t(maxLetters))
    throw InputError(place + ": a text of " + std::to_string(letters) + " letters; at most " +
                     std::to_string(maxLetters) + " are allowed; write the rest into the commit");
}

/// Returns the part of the path after its last folder of this name; empty if there is no such folder.
fs::path below(const fs::path& path, const char* folder) {
  fs::path rest;
  for (fs::path p = path; p.has_relative_path(); p = p.parent_path()) {
    if (p.filename() == folder && p != path) return rest;
    rest = rest.empty() ? p.filename() : p.filename() / rest;
  }
  return {};
}

}  // namespace

void refuseWithinCi(const fs::path& file) {
  if (const char* ci = std::getenv("CI"); ci && *ci)
    throw InputError(file.string() +
                     ": only people accept goldens, so none is written while CI is set in the environment; accept "
                     "it on your own machine");
}

void requireAcceptable(const std::string& place, const Acceptance& acceptance) {
  requireOneLine(place, acceptance.why,
                 "a golden is accepted with a reason; say in one line what changed and why the new result is right: "
                 "--why \"…\"");
  requireOneLine(place, acceptance.by, "the name of who accepts the golden is missing; give --by NAME");
}

void acceptGolden(const fs::path& file, Golden golden, const Acceptance& acceptance) {
  refuseWithinCi(file);
  requireAcceptable(file.string(), acceptance);
  golden.acceptedBy = acceptance.by, golden.why = acceptance.why, golden.file = file.string();
  const std::string text = writeGolden(golden);
  // The written text must be readable and must hold for the very run that it was taken from.
  const CheckReport report = compareGolden(readGolden(text, file.string()), golden.data);
  if (!report.passed()) throw InputError("the golden cannot be accepted as it is:\n" + describe(report));
  makeFolder(file.parent_path());
  writeFile(file, text, Content::golden);
}

std::string goldenName(const fs::path& scenario) {
  const fs::path inside = below(absolutePath(scenario), "scenarios");
  return (inside.empty() ? scenario.stem() : fs::path(inside).replace_extension()).generic_string();
}

bool liesInScenarios(const fs::path& scenario) { return !below(absolutePath(scenario), "scenarios").empty(); }

fs::path goldenFolder(const fs::path& scenario) {
  fs::path inside = below(scenario, "scenarios");
  fs::path root = scenario;  // the path as given if it contains `scenarios`, otherwise absolute
  if (inside.empty()) root = absolutePath(scenario), inside = below(root, "scenarios");
  if (inside.empty()) return scenario.parent_path();
  for (auto part = inside.begin(); part != inside.end(); ++part) root = root.parent_path();
  return root.parent_path() / "golden";
}

fs::path goldenPath(const fs::path& scenario) {
  fs::path inside = below(scenario, "scenarios");
  if (inside.empty()) inside = below(absolutePath(scenario), "scenarios");
  if (inside.empty()) inside = scenario.filename();
  return goldenFolder(scenario) / inside.replace_extension(".golden");
}

}  // namespace morula
