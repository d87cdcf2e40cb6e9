#include "study/plan_folder.h"

#include "base/error.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "files/write_file.h"

namespace morula {
namespace {

constexpr std::uint64_t maxPlanBytes = std::uint64_t{1} << 30;

}  // namespace

std::filesystem::path planFile(const std::filesystem::path& folder) { return folder / "plan.json"; }

Plan loadPlan(const std::filesystem::path& folder) {
  const auto file = planFile(folder);
  return readPlan(readFile(file, maxPlanBytes), file.string());
}

bool keepPlan(const Plan& plan, const std::filesystem::path& folder) {
  const auto file = planFile(folder);
  if (fileExists(file)) {
    const Plan there = loadPlan(folder);
    if (there.id == plan.id) return false;
    throw InputError("'" + file.string() + "' is another plan (" + there.id.substr(0, 8) + ", now " +
                     plan.id.substr(0, 8) +
                     "): the study or a scenario was changed since it was made; study run --update plans it anew and "
                     "keeps the results that it needs, --out gives it a folder of its own");
  }
  makeFolder(folder);
  writeNewFile(file, writePlan(plan));
  return true;
}

}  // namespace morula
