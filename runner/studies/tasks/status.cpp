#include "tasks/status.h"

#include <fmt/format.h>

#include "base/error.h"
#include "files/folders.h"
#include "files/text.h"
#include "simulation/memory.h"
#include "system/console.h"

namespace morula {
namespace {

namespace fs = std::filesystem;

std::uint64_t bytesBelow(const fs::path& folder) {
  std::uint64_t bytes = 0;
  if (!isFolder(folder)) return bytes;
  for (const char* ending : {".db", ".png", ".json"})
    for (const fs::path& file : filesBelow(folder, ending)) bytes += fileSize(file);
  return bytes;
}

}  // namespace

StudyStatus statusOf(const PlannedStudy& study) {
  const Plan& plan = study.plan;
  StudyStatus status;
  status.tasks = plan.tasks.size();
  double tookOfDone = 0, expectedOfDone = 0, left = 0;
  for (std::size_t task = 0; task < status.tasks; ++task) {
    const fs::path file = study.folder.task(plan.tasks[task].id);
    const double expected = plan.costs.empty() ? 1 : plan.costs[plan.tasks[task].condition].seconds;
    try {
      if (fileExists(file)) {
        if (!looksWhole(file)) throw FileError("the file is not a whole database");
        TaskFile found(file);
        const double took = found.timing().cpuSeconds;
        status.cpuSeconds += took;
        if (found.task().status == TaskStatus::failed) status.failed.push_back({task, found.task().reason});
        else ++status.done, tookOfDone += took, expectedOfDone += expected;
        if (std::string why = found.whyInsane(); !why.empty()) status.insane.push_back({task, std::move(why)});
        continue;
      }
    } catch (const FileError& error) { status.unreadable.push_back({task, error.what()}); }
    status.missing.push_back(task);
    left += expected;
  }
  if (left == 0 || !plan.costs.empty()) status.secondsLeft = left;
  if (left > 0 && expectedOfDone > 0) status.secondsLeft = left * tookOfDone / expectedOfDone;
  status.bytes = bytesBelow(study.folder.path());
  status.isMerged = status.isComplete() && status.unreadable.empty() && fileExists(study.folder.merged());
  return status;
}

StateCounts StudyStatus::counts() const {
  StateCounts counts;
  counts.add(ResultState::fine, done - insane.size());
  counts.add(ResultState::insane, insane.size());
  counts.add(ResultState::failed, failed.size());
  counts.add(ResultState::missing, missing.size());
  if (!stale.empty()) counts.add(ResultState::stale);
  return counts;
}

std::string describe(const StudyStatus& s, const PlannedStudy& study) {
  const Plan& plan = study.plan;
  std::string text = fmt::format("{}: {} runs: {}, {} failed, {} missing\n", plan.study.name, s.tasks,
                                 doneInWords(s.done, s.insane.size()), s.failed.size(), s.missing.size());
  for (const std::string& why : s.stale) text += "  stale    " + why + "\n";
  text += taskLines("  failed   ", s.failed, plan);
  text += taskLines("  not sane ", s.insane, plan);
  text += taskLines("  damaged  ", s.unreadable, plan, "; `morula study run` repeats it");
  text += taskLines("  missing  ", s.missing, plan);
  text += fmt::format("  took     {} of CPU time\n", formatDuration(s.cpuSeconds));
  if (!s.missing.empty())
    text += "  left     " +
            (s.secondsLeft ? formatDuration(*s.secondsLeft) + " of CPU time" : std::string("nothing is known")) + "\n";
  text += "  disk     " + bytesText(static_cast<double>(s.bytes)) + "\n";
  if (s.isMerged) text += "  results  " + study.folder.merged().string() + "\n";
  else if (s.isComplete())
    text += "  results  not merged yet: morula study merge " + shellWord(study.folder.path().string()) + "\n";
  return text;
}

Json toJson(const StudyStatus& s, const PlannedStudy& study) {
  return {{"study", study.plan.study.name},
          {"plan_id", study.plan.id},
          {"folder", study.folder.path().string()},
          {"tasks", s.tasks},
          {"done", s.done},
          {"failed", toJson(s.failed, study.plan)},
          {"not_sane", toJson(s.insane, study.plan)},
          {"missing", toJson(s.missing, study.plan)},
          {"stale", s.stale},
          {"states", s.counts().json()},
          {"damaged", toJson(s.unreadable, study.plan)},
          {"complete", s.isComplete()},
          {"merged", s.isMerged},
          {"cpu_seconds", s.cpuSeconds},
          {"seconds_left", orNull(s.secondsLeft)},
          {"bytes", s.bytes}};
}

}  // namespace morula
