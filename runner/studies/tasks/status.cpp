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

class Look {
 public:
  explicit Look(const PlannedStudy& study) : study_(study) {}

  StudyStatus run() {
    status_.tasks = study_.plan.tasks.size();
    for (std::size_t task = 0; task < status_.tasks; ++task) lookAt(task);
    status_.bytes = bytesBelow(study_.folder.path());
    status_.secondsLeft = secondsLeft();
    status_.isMerged = status_.isComplete() && status_.unreadable.empty() && fileExists(study_.folder.merged());
    return std::move(status_);
  }

 private:
  void lookAt(std::size_t task) {
    const fs::path file = study_.folder.task(study_.plan.tasks[task].id);
    if (!fileExists(file)) return status_.missing.push_back(task);
    try {
      if (!looksWhole(file)) throw FileError("it is not a whole database");
      TaskFile found(file);
      const double took = found.timing().cpuSeconds;
      status_.cpuSeconds += took;
      if (found.task().status == "failed") status_.failed.push_back({task, found.task().reason});
      else ++status_.done, tookOfDone_ += took, expectedOfDone_ += expected(task);
    } catch (const FileError& error) {
      status_.missing.push_back(task);
      status_.unreadable.push_back({task, error.what()});
    }
  }

  double expected(std::size_t task) const {
    const Plan& plan = study_.plan;
    return plan.costs.empty() ? 1 : plan.costs[plan.tasks[task].condition].seconds;
  }

  std::optional<double> secondsLeft() const {
    double left = 0;
    for (const std::size_t task : status_.missing) left += expected(task);
    if (left == 0) return 0;
    if (expectedOfDone_ > 0) return left * tookOfDone_ / expectedOfDone_;
    return study_.plan.costs.empty() ? std::nullopt : std::optional(left);
  }

  const PlannedStudy& study_;
  StudyStatus status_;
  double tookOfDone_ = 0, expectedOfDone_ = 0;
};

}  // namespace

StudyStatus statusOf(const PlannedStudy& study) { return Look(study).run(); }

std::string describe(const StudyStatus& s, const PlannedStudy& study) {
  const Plan& plan = study.plan;
  constexpr std::size_t most = 20;
  std::string text = fmt::format("{}: {} runs: {} done, {} failed, {} missing\n", plan.study.name, s.tasks, s.done,
                                 s.failed.size(), s.missing.size());
  for (const FailedTask& f : s.failed) text += "  failed   " + nameOfTask(plan, f.task) + ": " + f.reason + "\n";
  for (const FailedTask& f : s.unreadable)
    text += "  damaged  " + nameOfTask(plan, f.task) + ": " + f.reason + "; `morula study run` does it again\n";
  for (std::size_t i = 0; i < std::min(most, s.missing.size()); ++i)
    text += "  missing  " + nameOfTask(plan, s.missing[i]) + "\n";
  if (s.missing.size() > most) text += fmt::format("  … and {} more\n", s.missing.size() - most);
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
  const Plan& plan = study.plan;
  const auto one = [&](std::size_t task) {
    return Json{{"task_id", plan.tasks[task].id},
                {"condition", nameOf(plan, plan.tasks[task].condition)},
                {"seed", plan.tasks[task].seed}};
  };
  const auto withReasons = [&](const std::vector<FailedTask>& tasks) {
    Json list = Json::array();
    for (const FailedTask& f : tasks) {
      list.push_back(one(f.task));
      list.back()["reason"] = f.reason;
    }
    return list;
  };
  Json missing = Json::array();
  for (const std::size_t task : s.missing) missing.push_back(one(task));
  return {{"study", plan.study.name},
          {"plan_id", plan.id},
          {"folder", study.folder.path().string()},
          {"tasks", s.tasks},
          {"done", s.done},
          {"failed", withReasons(s.failed)},
          {"missing", missing},
          {"damaged", withReasons(s.unreadable)},
          {"complete", s.isComplete()},
          {"merged", s.isMerged},
          {"cpu_seconds", s.cpuSeconds},
          {"seconds_left", orNull(s.secondsLeft)},
          {"bytes", s.bytes}};
}

}  // namespace morula
