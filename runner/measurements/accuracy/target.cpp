#include "accuracy/target.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/number_text.h"
#include "files/scratch_folder.h"
#include "files/text.h"
#include "system/child_process.h"

namespace morula {
namespace {

constexpr std::uint64_t finestTried = 4;

/// Returns the command of a setting: the question's changes and the setting's own.
std::vector<std::string> commandFor(const Setting& setting, const TargetQuestion& question) {
  std::vector<std::string> changes = changesFor(setting);
  bool allowOutside = false;
  try {
    allowOutside = question.read(changes).allowOutside;
  } catch (const InputError&) { return {}; }  // its row has failed, too
  const auto pathOf = [](const std::string& change) { return change.substr(0, change.find('=')); };
  std::vector<std::string> command{"run", question.file};
  const auto add = [&](const char* option, const std::string& value) {
    command.insert(command.end(), {option, value});
  };
  for (const std::string& given : question.set)
    if (std::ranges::find(changes, pathOf(given), pathOf) == changes.end()) add("--set", given);
  if (allowOutside) command.push_back("--allow-outside");
  if (!question.seed.empty()) add("--seed", question.seed);
  for (const std::string& change : changes) add("--set", change);
  return command;
}

std::string lastLine(const std::string& text) {
  const auto lines = linesOf(text.substr(0, text.find_last_not_of('\n') + 1));
  return lines.empty() ? "" : lines.back();
}

/// Runs commands to their ends, within one budget for all.
class Runner {
 public:
  Runner(const TargetQuestion& question, TargetAnswer& answer) : question_(question), answer_(answer) {}

  std::optional<EndedRun> run(const Setting& setting, const std::string& series, double error) {
    const auto command = commandFor(setting, question_);
    const double rest = question_.budget - spent_;
    if (command.empty()) return {};
    if (rest < 1) {
      answer_.outOfTime = true;
      return {};
    }
    question_.tell(fmt::format("running to the end: {}, {}", series, timeStepChange(setting)));
    const ScratchFolder folder(question_.folder);
    auto words = command;
    words.insert(words.begin(), question_.program);
    words.insert(words.end(), {"--no-check", "--no-pictures", "--quiet", "--out", folder.path().string()});
    const ChildEnd end =
        runChild(words, {.cpuSeconds = static_cast<int>(std::ceil(rest)), .silent = false, .errorsToo = true});
    spent_ += end.cpuSeconds;
    if (end.well()) return EndedRun{command, setting, error, end.cpuSeconds};
    if (end.outOfTime()) answer_.outOfTime = true;
    answer_.failures.push_back(fmt::format(
        "{}, {}: {}", series, timeStepChange(setting),
        end.outOfTime() ? fmt::format("not at its end after {:.0f} s of CPU time (--budget)", end.cpuSeconds)
                        : end.text() + ": " + lastLine(end.said)));
    return {};
  }

 private:
  const TargetQuestion& question_;
  TargetAnswer& answer_;
  double spent_ = 0;
};

/// Returns "morula run file --set path=value", with words in quotes if a shell needs them.
std::string commandText(const std::vector<std::string>& command) {
  std::string text = "morula";
  for (const std::string& word : command) text += " " + shellWord(word);
  return text;
}

/// Returns the coarsest level that leaves room for the error of time steps, including levels that did not take part.
std::optional<std::uint64_t> levelThatHolds(const MeshError& mesh, double room) {
  for (std::uint64_t level = mesh.own; level <= finestTried; ++level)
    if (const auto error = mesh.errorOf(level); error && *error <= room) return level;
  return {};
}

Json toJson(const std::optional<EndedRun>& run) {
  if (!run) return {};
  return {{"command", run->command},
          {"settings", morula::toJson(run->setting)},
          {"error", run->error},
          {"cpu_seconds", run->cpuSeconds}};
}

}  // namespace

TargetAnswer findTarget(const AccuracyReport& report, const TargetQuestion& question) {
  TargetAnswer answer;
  Runner runner(question, answer);
  for (const AccuracyRow* row : thatHold(report, question.error)) {
    if (answer.outOfTime) break;
    answer.best = runner.run(row->setting, row->series, *row->error);
    if (answer.best) break;
  }
  const auto mesh = report.mesh.error();
  if (!answer.best || !mesh || report.mesh.none || *mesh + answer.best->error <= question.error) return answer;
  answer.levelThatHolds = levelThatHolds(report.mesh, question.error - answer.best->error);
  const Setting& best = answer.best->setting;
  if (!answer.levelThatHolds || best.level != report.mesh.own || best.model) return answer;
  Setting finer = best;
  finer.level = answer.levelThatHolds;
  if (!finer.automatic)
    finer.timeStep = std::ldexp(finer.timeStep, static_cast<int>(*best.level) - static_cast<int>(*finer.level));
  answer.finer = runner.run(finer, fmt::format("icosphere {}", *finer.level),
                            answer.best->error + *report.mesh.errorOf(*finer.level));
  return answer;
}

std::string describe(const TargetAnswer& answer, const TargetQuestion& question, const AccuracyReport& report) {
  const std::string target = numberText(question.error);
  std::string text;
  for (const std::string& failure : answer.failures)
    text += "cheaper settings, which do not reach the end: " + failure + "\n";
  if (!answer.best)
    return text + (answer.outOfTime
                       ? "no settings with an error of at most " + target +
                             " have reached the end within the CPU time allowed; allow more with --budget\n"
                       : "none of the settings tried has an error of at most " + target + " and reaches the end\n");
  const EndedRun& best = *answer.best;
  const bool toTheEnd = report.end && report.times.back() >= *report.end * (1 - 1e-6);
  text += fmt::format(
      "the cheapest settings tried whose error on the scenario's mesh is at most {}: {:.2g}, compared up to time "
      "{}{}\n"
      "  {}\n"
      "  this command has been run to the end, in {:.2f} s of CPU time\n",
      target, best.error, numberText(report.times.back()),
      toTheEnd || !report.end ? "" : " of " + numberText(*report.end) + ", before chaos", commandText(best.command),
      best.cpuSeconds);
  const auto mesh = report.mesh.error();
  if (report.mesh.none) return text;
  if (!mesh) return text + "  the mesh's error is not known: " + report.mesh.unknown + "\n";
  if (*mesh + best.error <= question.error)
    return text + fmt::format("  the mesh adds {:.2g}: the whole error is at most {:.2g}\n", *mesh, *mesh + best.error);
  text += fmt::format("  icosphere {} itself adds {:.2g}, so the whole error is above {}: ", report.mesh.own, *mesh,
                      target);
  if (!answer.levelThatHolds) return text + "no icosphere up to 4 would hold it\n";
  text += fmt::format("icosphere {} would hold it\n", *answer.levelThatHolds);
  if (answer.finer)
    text += fmt::format(
        "  {}\n"
        "  this command has been run to the end, in {:.2f} s of CPU time; estimate of its whole error: "
        "{:.2g}\n",
        commandText(answer.finer->command), answer.finer->cpuSeconds, answer.finer->error);
  else text += "  settings with this icosphere have not been run to the end\n";
  return text;
}

Json toJson(const TargetAnswer& answer, const TargetQuestion& question, const AccuracyReport& report) {
  const auto mesh = report.mesh.error();
  const bool known = answer.best && mesh;
  const double whole = known ? *mesh + answer.best->error : 0;
  return {{"error", question.error},
          {"settings", answer.best ? morula::toJson(answer.best->setting) : Json()},
          {"run_to_the_end", toJson(answer.best)},
          {"mesh_error", orNull(mesh)},
          {"whole_error", known ? Json(whole) : Json()},
          {"mesh_holds", known ? Json(whole <= question.error) : Json()},
          {"icosphere_that_holds", orNull(answer.levelThatHolds)},
          {"finer_run_to_the_end", toJson(answer.finer)},
          {"failures", answer.failures}};
}

}  // namespace morula
