#include "tasks/run_task.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "base/error.h"
#include "check/check_run.h"
#include "files/text.h"
#include "files/write_file.h"
#include "loop/simulate.h"
#include "pictures/pictures.h"
#include "store/sample_values.h"
#include "system/clock.h"
#include "system/signals.h"
#include "system/usable_memory.h"
#include "values/cell_words.h"

namespace morula {
namespace {

/// Returns the options of recording; the scenario's `record` already has the study's measures and interval.
RecordOptions recordingOf(const Plan& plan, const Scenario& scenario) {
  const Study& study = plan.study;
  RecordOptions record = recordingOf(scenario, study.keep.hashes == HashesKept::all);
  record.hashEnd = study.keep.hashes == HashesKept::end;
  record.atDivisions = study.when.moments == Moments::eachDivision;
  return record;
}

/// Returns the samples to compare. With `when: end` the start is recorded, as of every run, and not compared.
std::vector<Sample> measuredSamples(const Study& study, const std::vector<Sample>& samples) {
  if (study.when.moments != Moments::end || samples.empty()) return samples;
  return {samples.back()};
}

/// Drops results that were not asked for. Samples of start and end stay, as of every run, and so do connections at the
/// end: their history is the largest table.
void drop(RunResults& results, const Study& study) {
  if (study.keep.samples == SamplesKept::all) return;
  if (results.samples.size() > 2) results.samples.erase(results.samples.begin() + 1, results.samples.end() - 1);
  std::erase_if(results.connections, [](const ConnectionRecord& c) { return c.released >= 0; });
}

FailureKind kindOf(Want want) { return want == Want::memory ? FailureKind::memoryLimit : FailureKind::numerical; }

/// Makes the end of a run that has nothing to show.
RunEnd failedEnd(const std::string& why) { return {.status = RunStatus::failed, .failure = why}; }

TaskOutcome outcomeOf(const Plan& plan, std::size_t task, const Scenario& scenario, const TaskSettings& settings) {
  const Task& planned = plan.tasks[task];
  TaskOutcome outcome;
  outcome.task = {planned.id, task, planned.condition, planned.seed};
  outcome.record = recordOf(scenario, settings.execution, settings.command);
  TimingRow& timing = outcome.timing;
  const RunRecord& r = outcome.record;
  timing.host = hostName();
  timing.cpu = r.machine.cpu, timing.kernel = r.machine.kernel, timing.cpuFeatures = r.machine.features;
  timing.fpEnvironment = r.machine.fpEnvironment, timing.isa = r.isa, timing.threads = r.threads;
  timing.command = r.command, timing.binaryHash = r.binaryHash;
  timing.started = utcNow();
  return outcome;
}

constexpr int pictureSize = 400;  // [pixel] small, to be viewed side by side

void draw(const World& world, const Scenario& scenario, const std::string& title, const std::filesystem::path& file) {
  if (!world.bodies) {
    TreePicture tree = lineagePictureOf(world, scenario);
    tree.title = title;
    return writePicture(drawLineage(tree), file);
  }
  OrganismPicture picture = pictureOf(world, scenario);
  picture.title = title;
  picture.instruments.scaleBar = true;
  picture.width = picture.height = pictureSize;
  writePicture(drawOrganism(picture), file);
}

/// Returns why there is no picture; "" if there is one. A lack of memory for the picture does not make the run fail.
std::string drawIfPossible(const World& world, const Scenario& scenario, const std::string& title,
                           const std::filesystem::path& file) {
  try {
    draw(world, scenario, title, file);
  } catch (const NumericalError& error) {
    if (error.want != Want::memory) throw;
    return error.what();
  } catch (const std::bad_alloc&) { return "there is no more memory to draw"; }
  return "";
}

/// Simulates. `notDrawn`: why the picture of the run is missing.
void compute(const Plan& plan, std::size_t task, const Scenario& scenario, const StudyFolder& folder,
             const TaskSettings& settings, TaskOutcome& outcome, std::string& notDrawn) {
  const Study& study = plan.study;
  const auto measure = [&](const std::vector<Sample>& samples, const std::map<StateId, std::string>& states) {
    const auto values = valuesOf(samples, states, study.measures, scenario);
    outcome.values.insert(outcome.values.end(), values.begin(), values.end());
  };
  // Samples that are not kept are measured and dropped.
  RunResults before;
  const RecordSink let = [&](const RunResults& records) {
    if (study.when.moments != Moments::end) measure(records.samples, records.stateTexts);
    if (before.samples.empty() && !records.samples.empty()) before.samples = {records.samples.front()};
    before.chain.insert(before.chain.end(), records.chain.begin(), records.chain.end());
  };
  CheckedRun checked = simulateChecked(
      scenario, settings.execution,
      {.record = recordingOf(plan, scenario), .sink = study.keep.samples == SamplesKept::all ? nullptr : let}, false);
  Simulation& run = checked.run;
  outcome.end = run.end;
  outcome.results = std::move(run.results);
  RunResults& results = outcome.results;
  if (run.end.status == RunStatus::failed) {
    outcome.task.reason = reasonOf(kindOf(run.end.want), run.end.failure);
    outcome.values.clear();
  } else {
    measure(measuredSamples(study, results.samples), results.stateTexts);
    results.checks = std::move(checked.sanity);
    if (keepsPicture(plan, task))
      notDrawn =
          drawIfPossible(run.world, scenario,
                         join(plan.conditions[plan.tasks[task].condition].labels) +
                             fmt::format("{}seed {}", plan.study.axes.empty() ? "" : ", ", plan.tasks[task].seed),
                         folder.picture(plan, task));
  }
  results.samples.insert(results.samples.begin(), before.samples.begin(), before.samples.end());
  results.chain.insert(results.chain.begin(), before.chain.begin(), before.chain.end());
  drop(results, study);
}

void write(TaskOutcome outcome, const std::filesystem::path& file) {
  outcome.timing.ended = utcNow();
  overwriteFile(file, taskFileBytes(std::move(outcome)));
}

void computeAndWrite(const Plan& plan, std::size_t task, const StudyFolder& folder, const TaskSettings& settings,
                     ForkedAnswer& answer) {
  const Scenario scenario = scenarioOf(plan, plan.tasks[task]);
  TaskOutcome outcome = outcomeOf(plan, task, scenario, settings);
  const auto fail = [&](const std::string& why, Want want) {
    outcome.end = failedEnd(why);
    outcome.task.reason = reasonOf(kindOf(want), why);
    outcome.results = {}, outcome.values.clear();
  };
  std::string notDrawn;
  try {
    compute(plan, task, scenario, folder, settings, outcome, notDrawn);
  } catch (const Interrupted& by) {
    answer.code = 128 + by.signal;
    return;
  } catch (const InputError& error) {  // with this seed the scene cannot begin
    fail(error.what(), error.want);
  } catch (const NumericalError& error) { fail(error.what(), error.want); }
  liftMemoryLimit();
  outcome.timing.cpuSeconds = seconds(ClockKind::process);
  outcome.timing.maxMemory = peakMemory();
  answer.text = notDrawn.empty() ? outcome.task.reason : notDrawn;
  if (!notDrawn.empty()) answer.code = undrawn;
  write(std::move(outcome), folder.task(plan.tasks[task].id));
}

}  // namespace

ForkedAnswer runTask(const Plan& plan, std::size_t task, const StudyFolder& folder, const TaskSettings& settings) {
  endOutOfMemoryWith(outOfMemory);
  ForkedAnswer answer;
  try {
    computeAndWrite(plan, task, folder, settings, answer);
  } catch (const std::bad_alloc&) {
    answer = {outOfMemory, "there is no more memory"};
  } catch (const FileError& error) { answer = {cannotWrite, error.what()}; } catch (const std::exception& error) {
    answer = {brokeDown, error.what()};
  }
  return answer;
}

void writeFailure(const Plan& plan, std::size_t task, const StudyFolder& folder, const TaskSettings& settings,
                  FailureKind kind, const std::string& why, const ForkedEnd& end) {
  TaskOutcome outcome = outcomeOf(plan, task, scenarioOf(plan, plan.tasks[task]), settings);
  outcome.end = failedEnd(why);
  outcome.task.reason = reasonOf(kind, why);
  outcome.timing.cpuSeconds = end.cpuSeconds;
  outcome.timing.maxMemory = end.maxMemory;
  write(std::move(outcome), folder.task(plan.tasks[task].id));
}

bool keepsPicture(const Plan& plan, std::size_t task) {
  if (plan.study.keep.pictures == PicturesKept::none) return false;
  if (plan.study.keep.pictures == PicturesKept::all) return true;
  const std::uint64_t first = plan.study.seeds.front();
  return std::ranges::any_of(plan.replicates, [&](const Replicate& r) { return r.task == task && r.seed == first; });
}

std::vector<ResultRow> valuesOf(const std::vector<Sample>& samples, const std::map<StateId, std::string>& states,
                                const std::vector<std::string>& measures, const Scenario& scenario) {
  std::vector<ResultRow> rows;
  for (const std::string& name : measures) {
    const AskedMeasure measure = resolved(readMeasure(name), scenario.names, scenario.scene.dna);
    for (const Sample& sample : samples)
      if (const auto value = meanIn(sample, measure, states)) rows.push_back({name, sample.world.time, *value});
  }
  return rows;
}

}  // namespace morula
