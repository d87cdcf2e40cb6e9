#include "golden/accept.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "base/error.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

bool isOneLine(const std::string& text) {
  return text.find_first_not_of(" \t") != std::string::npos &&
         text.find_first_of("\r\n") == std::string::npos;
}

/// The text is on the disk under a name of its own before it takes the golden's place: whoever reads sees the
/// old file or the new one, never half of one.
void writeAtomically(const fs::path& file, const std::string& text) {
  const fs::path draft = file.string() + ".new" + std::to_string(getpid());
  std::ofstream stream(draft, std::ios::binary);
  stream << text << std::flush;
  stream.close();
  std::error_code error;
  if (stream) fs::rename(draft, file, error);
  else error = std::make_error_code(std::errc::io_error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(draft, ignored);
  throw FileError(file.string() + ": cannot write the golden (" + error.message() +
                  "); is the folder there and writable?");
}

/// The part of the path after its last folder of this name; empty if there is none.
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
                     ": goldens are accepted by people; with CI set in the environment none is written");
}

void acceptGolden(const fs::path& file, Golden golden, const Acceptance& acceptance) {
  refuseWithinCi(file);
  if (!isOneLine(acceptance.why))
    throw InputError(file.string() +
                     ": a golden is accepted with a reason; say in one line what changed and why the "
                     "new result is right: --why \"…\"");
  if (!isOneLine(acceptance.by))
    throw InputError(file.string() + ": who accepts the golden? a name is expected");
  golden.acceptedBy = acceptance.by, golden.why = acceptance.why, golden.file = file.string();
  const std::string text = writeGolden(golden);
  // What is written must be readable and must hold for the very run it was taken from.
  const CheckReport report = compareGolden(readGolden(text, file.string()), golden.data);
  if (!report.passed()) throw InputError("the golden cannot be accepted as it is:\n" + describe(report));
  std::error_code ignored;  // a folder that cannot be made shows when the file is written
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
  writeAtomically(file, text);
}

std::string goldenName(const fs::path& scenario) {
  const fs::path inside = below(fs::absolute(scenario).lexically_normal(), "scenarios");
  return (inside.empty() ? scenario.stem() : fs::path(inside).replace_extension()).generic_string();
}

bool liesInScenarios(const fs::path& scenario) {
  return !below(fs::absolute(scenario).lexically_normal(), "scenarios").empty();
}

fs::path goldenPath(const fs::path& scenario) {
  fs::path inside = below(scenario, "scenarios");
  fs::path root = scenario;  // as it was given if it tells where it lies, absolute if not
  if (inside.empty()) root = fs::absolute(scenario).lexically_normal(), inside = below(root, "scenarios");
  if (inside.empty()) return fs::path(scenario).replace_extension(".golden");
  for (auto part = inside.begin(); part != inside.end(); ++part) root = root.parent_path();
  return root.parent_path() / "golden" / fs::path(inside).replace_extension(".golden");
}

std::vector<fs::path> goldensWithoutScenario(const fs::path& goldenFolder, const fs::path& scenarioFolder) {
  std::vector<fs::path> orphans;
  for (const auto& entry : fs::recursive_directory_iterator(goldenFolder)) {
    if (entry.path().extension() != ".golden") continue;
    const fs::path name = entry.path().lexically_relative(goldenFolder);
    if (!fs::exists(scenarioFolder / fs::path(name).replace_extension(".yaml")))
      orphans.push_back(entry.path());
  }
  std::sort(orphans.begin(), orphans.end());
  return orphans;
}

}  // namespace morula
