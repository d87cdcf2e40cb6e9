#include "tasks/run_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <memory>

#include "base/error.h"
#include "files/draft.h"
#include "files/folders.h"
#include "study/plan.h"
#include "system/clock.h"
#include "system/console.h"
#include "system/signals.h"
#include "yaml/numbers.h"

namespace morula {
namespace {

class TaskProgress {
 public:
  /// `tasks`: the tasks to compute, `jobs` of them at a time.
  TaskProgress(const Plan& plan, const std::vector<std::size_t>& tasks, int jobs, bool quiet)
      : plan_(plan), jobs_(jobs), begun_(seconds(ClockKind::wall)), line_(quiet), all_(tasks.size()) {
    for (const std::size_t task : tasks) expectedAll_ += expected(task);
  }

  /// Counts a task that has ended.
  void ended(std::size_t task, bool failed) {
    ++done_;
    if (failed) ++failed_;
    expectedDone_ += expected(task);
  }
  /// Shows progress if the line is due. Call often.
  void show() {
    if (line_.isDue()) line_.show(text());
  }
  void clear() { line_.clear(); }

 private:
  /// Returns the predicted cost of a task; without predictions all tasks count alike.
  double expected(std::size_t task) const {
    return plan_.costs.empty() ? 1 : std::max(plan_.costs[plan_.tasks[task].condition].seconds, 1e-3);
  }

  std::string text() const {
    const double share = expectedAll_ > 0 ? std::min(expectedDone_ / expectedAll_, 1.0) : 1;
    std::string text = plan_.study.name + line_.bar(share) + fmt::format("  {} of {} runs", done_, all_);
    if (failed_) text += fmt::format("  {} failed", failed_);
    // Extrapolates the speed so far by the wall clock, whatever else the machine does: predictions share one factor of
    // error.
    const double perExpected = expectedDone_ > 0     ? (seconds(ClockKind::wall) - begun_) / expectedDone_
                               : plan_.costs.empty() ? 0
                                                     : 1.0 / jobs_;
    if (perExpected > 0) text += "  " + formatDuration((expectedAll_ - expectedDone_) * perExpected) + " left";
    return text;
  }

  const Plan& plan_;
  int jobs_;
  double begun_;  // [s] wall clock
  ProgressLine line_;
  std::size_t all_, done_ = 0, failed_ = 0;
  double expectedAll_ = 0, expectedDone_ = 0;  // [s] CPU time
};

/// Returns true if a process that ended by this signal crashed by its own fault. Other signals come from outside: from
/// a user, a scheduler, or the system when memory runs out.
bool isCrash(int signal) {
  for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGTRAP})
    if (signal == own) return true;
  return false;
}

/// Sorts by predicted time, longest first, so that no long task runs alone at the end. The order of equals stays.
void longestFirst(const Plan& plan, std::vector<std::size_t>& tasks) {
  if (plan.costs.empty()) return;
  std::stable_sort(tasks.begin(), tasks.end(), [&](std::size_t a, std::size_t b) {
    return plan.costs[plan.tasks[a].condition].seconds > plan.costs[plan.tasks[b].condition].seconds;
  });
}

class StudyRun {
 public:
  StudyRun(const PlannedStudy& study, const RunStudyOptions& options)
      : study_(study), options_(options), settings_(options.settings) {
    double& limit = settings_.execution.memoryLimit;
    if (const auto& most = study.plan.study.limits.memory) limit = std::min(limit, static_cast<double>(*most));
  }

  RunStudyReport run() {
    const double begun = seconds(ClockKind::wall);
    report_.asked = options_.tasks.size();
    removeAbandonedDrafts(study_.folder.tasks());
    removeAbandonedDrafts(study_.folder.pictures());
    removeAbandonedDrafts(study_.folder.path());
    std::vector<std::size_t> open = openTasks();
    emptyTaskFile(), binaryHash(), machineInfo();  // once, not in each process
    if (options_.jobs > 1) longestFirst(study_.plan, open);
    progress_ = std::make_unique<TaskProgress>(study_.plan, open, options_.jobs, options_.quiet);
    runAll(open);
    progress_->clear();
    std::ranges::sort(report_.failed, {}, &FailedTask::task);
    std::ranges::sort(report_.undrawn, {}, &FailedTask::task);
    std::ranges::sort(report_.stopped, {}, &FailedTask::task);
    report_.seconds = seconds(ClockKind::wall) - begun;
    return std::move(report_);
  }

 private:
  struct Running {
    std::size_t task;
    std::unique_ptr<Forked> process;
  };

  std::filesystem::path fileOf(std::size_t task) const { return study_.folder.task(study_.plan.tasks[task].id); }

  bool isThere(std::size_t task) {
    const auto file = fileOf(task);
    if (!fileExists(file) || !looksWhole(file)) return false;
    if (!ownBuild_) requireOwnBuild(file), ownBuild_ = true;
    if (!options_.retryFailed) return true;
    const bool drawn =
        !keepsPicture(study_.plan, task) || study_.folder.storedPicture(study_.plan.tasks[task].id).has_value();
    return drawn && TaskFile(file).task().status == TaskStatus::done;
  }

  std::vector<std::size_t> openTasks() {
    std::vector<std::size_t> open;
    for (const std::size_t task : options_.tasks) {
      if (isThere(task)) ++report_.already;
      else open.push_back(task);
    }
    return open;
  }

  void begin(std::size_t task) {
    const RunLimits& limits = study_.plan.study.limits;
    running_.push_back({task, std::make_unique<Forked>(ForkedLimits{limits.cpu, limits.memory}, [&, task] {
                          return runTask(study_.plan, task, study_.folder, settings_);
                        })});
  }

  void runAll(const std::vector<std::size_t>& open) {
    const SignalWatch signals;
    std::size_t next = 0;
    while (next < open.size() || !running_.empty()) {
      if (const int signal = SignalWatch::caught(); signal && !report_.signal) {
        report_.signal = signal;
        for (Running& r : running_) r.process->stop(SIGTERM);  // runs check for it and stop
      }
      if (report_.signal && running_.empty()) break;
      while (!report_.signal && next < open.size() && running_.size() < static_cast<std::size_t>(options_.jobs))
        begin(open[next++]);
      std::vector<Forked*> processes;
      for (const Running& r : running_) processes.push_back(r.process.get());
      std::vector<std::size_t> ended = endedAmong(processes, 0.2);
      for (auto place = ended.rbegin(); place != ended.rend(); ++place) end(*place);
      progress_->show();
    }
    report_.left = open.size() - next;
  }

  void end(std::size_t place) {
    const Running running = std::move(running_[place]);
    running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(place));
    ForkedEnd end = running.process->wait();
    report_.cpuSeconds += end.cpuSeconds;
    settle(running.task, end);
  }

  void settle(std::size_t task, const ForkedEnd& end) {
    const RunLimits& limits = study_.plan.study.limits;
    const ForkedAnswer& answer = end.answer;
    if (answer.code == cannotWrite) throw FileError(answer.text);
    if (end.signal == 0 && answer.code == 0) return computed(task, answer.text);
    if (end.signal == 0 && answer.code == undrawn) {
      report_.undrawn.push_back({task, reasonOf(FailureKind::memoryLimit, answer.text)});
      return computed(task, "");
    }
    if (end.signal == SIGXCPU && limits.cpu)
      return fail(task, end, FailureKind::cpuLimit,
                  fmt::format("more than {:g} s of CPU time (limits.cpu-per-run)", *limits.cpu));
    if (end.signal == 0 && answer.code == outOfMemory)
      return fail(task, end, FailureKind::memoryLimit,
                  "there is no more memory" +
                      (limits.memory ? fmt::format(" within {} bytes (limits.memory-per-run)", *limits.memory) : ""));
    if (isCrash(end.signal)) return fail(task, end, FailureKind::crash, signalName(end.signal));
    if (end.signal == 0 && answer.code < 128)
      return fail(task, end, FailureKind::crash,
                  answer.code == brokeDown ? "a bug of Morula's: " + answer.text
                                           : fmt::format("ended with code {}", answer.code));
    const int signal = end.signal ? end.signal : answer.code - 128;
    report_.stopped.push_back({task, "stopped from outside by " + signalName(signal)});
    progress_->ended(task, false);
  }

  /// `failure`: why the task failed; "" if it is done.
  void computed(std::size_t task, const std::string& failure) {
    ++report_.computed;
    if (!failure.empty()) report_.failed.push_back({task, failure});
    progress_->ended(task, !failure.empty());
  }

  void fail(std::size_t task, const ForkedEnd& end, FailureKind kind, const std::string& why) {
    writeFailure(study_.plan, task, study_.folder, settings_, kind, why, end);
    computed(task, reasonOf(kind, why));
  }

  const PlannedStudy& study_;
  const RunStudyOptions& options_;
  TaskSettings settings_;
  RunStudyReport report_;
  std::vector<Running> running_;
  std::unique_ptr<TaskProgress> progress_;
  bool ownBuild_ = false;  // an existing result is of this build
};

}  // namespace

RunStudyReport runStudy(const PlannedStudy& study, const RunStudyOptions& options) {
  return StudyRun(study, options).run();
}

std::string doneInWords(std::size_t done, std::size_t insane) {
  return fmt::format("{} done", done) + (insane ? fmt::format(", {} of them not sane", insane) : "");
}

std::string nameOfTask(const Plan& plan, std::size_t task) {
  const Task& t = plan.tasks[task];
  return fmt::format("{}, seed {} (task {})", nameOf(plan, t.condition), t.seed, t.id);
}

std::string firstOf(const std::vector<std::string>& lines) {
  constexpr std::size_t most = 20;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, lines.size()); ++i) text += lines[i] + "\n";
  if (lines.size() > most) text += fmt::format("  … and {} more\n", lines.size() - most);
  return text;
}

std::string taskLines(const std::string& what, const std::vector<std::size_t>& tasks, const Plan& plan,
                      const std::string& remark) {
  std::vector<std::string> lines;
  for (const std::size_t task : tasks) lines.push_back(what + nameOfTask(plan, task) + remark);
  return firstOf(lines);
}

std::string taskLines(const std::string& what, const std::vector<FailedTask>& tasks, const Plan& plan,
                      const std::string& remark) {
  std::string text;
  for (const FailedTask& f : tasks) text += what + nameOfTask(plan, f.task) + ": " + f.reason + remark + "\n";
  return text;
}

Json toJson(const std::vector<std::size_t>& tasks, const Plan& plan) {
  Json list = Json::array();
  for (const std::size_t task : tasks) {
    const Task& t = plan.tasks[task];
    list.push_back({{"task_id", t.id}, {"condition", nameOf(plan, t.condition)}, {"seed", t.seed}});
  }
  return list;
}

Json toJson(const std::vector<FailedTask>& tasks, const Plan& plan) {
  Json list = Json::array();
  for (const FailedTask& f : tasks) {
    list.push_back(toJson(std::vector{f.task}, plan)[0]);
    list.back()["reason"] = f.reason;
  }
  return list;
}

std::string describe(const RunStudyReport& r, const PlannedStudy& study) {
  std::string text =
      fmt::format("{}: {} of {} runs have a result: {} computed now, {} there before; {} of CPU time in {}\n",
                  study.plan.study.name, r.already + r.computed, r.asked, r.computed, r.already,
                  formatDuration(r.cpuSeconds), formatDuration(r.seconds));
  text += taskLines("  failed   ", r.failed, study.plan);
  text += taskLines("  no picture ", r.undrawn, study.plan);
  text += taskLines("  no result  ", r.stopped, study.plan, "; the next study run repeats it");
  if (r.left) text += fmt::format("  {} runs were not begun; the same command continues the study\n", r.left);
  return text;
}

Json toJson(const RunStudyReport& r, const PlannedStudy& study) {
  return {{"study", study.plan.study.name},
          {"plan_id", study.plan.id},
          {"folder", study.folder.path().string()},
          {"asked", r.asked},
          {"already", r.already},
          {"computed", r.computed},
          {"failed", toJson(r.failed, study.plan)},
          {"undrawn", toJson(r.undrawn, study.plan)},
          {"stopped", toJson(r.stopped, study.plan)},
          {"left", r.left},
          {"complete", r.isComplete()},
          {"seconds", r.seconds},
          {"cpu_seconds", r.cpuSeconds}};
}

Shard parseShard(const std::string& text) {
  const auto refuse = [&] {
    throw InputError("'" + text + "' is no share; needs NUMBER/OF with 1 ≤ NUMBER ≤ OF ≤ 1000000, as 3/40");
  };
  const auto slash = text.find('/');
  if (slash == text.npos) refuse();
  const auto number = scenario::parseNatural(text.substr(0, slash)),
             of = scenario::parseNatural(text.substr(slash + 1));
  constexpr std::uint64_t most = 1'000'000;
  if (!number.wrong.empty() || !of.wrong.empty() || number.value < 1 || number.value > of.value || of.value > most)
    refuse();
  return {static_cast<std::size_t>(number.value), static_cast<std::size_t>(of.value)};
}

std::vector<std::size_t> tasksOf(const Shard& shard, std::size_t count) {
  std::vector<std::size_t> tasks;
  for (std::size_t task = shard.number - 1; task < count; task += shard.of) tasks.push_back(task);
  return tasks;
}

}  // namespace morula
