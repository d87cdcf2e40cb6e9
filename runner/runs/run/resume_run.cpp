#include "run/resume_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

#include "base/error.h"
#include "system/console.h"
#include "system/json.h"
#include "system/usage_error.h"

namespace morula {
namespace {

/// Lists the differences of two records that make their run ids differ.
std::string differences(const RunRecord& there, const RunRecord& here) {
  std::string text;
  for (const auto& [name, item, before, now] : compareIdentity(there, here))
    if (before != now) text += (text.empty() ? "" : "; ") + fmt::format("{} ({} then, {} now)", item, before, now);
  return text;
}

/// All values of a resolved scenario by their keys, "stop.cycles".
Json valuesOf(const RunRecord& record) {
  for (const SourceText& d : record.documents)
    if (d.role == "resolved")
      if (const Json json = tryParseJson(d.content); json.is_object()) return json.flatten();
  return Json::object();
}

/// The keys that differ between two scenarios, with both values.
std::string keysThatDiffer(const RunRecord& there, const RunRecord& here) {
  const Json before = valuesOf(there), now = valuesOf(here);
  std::set<std::string> keys;
  for (const Json* values : {&before, &now})
    for (const auto& [key, value] : values->items()) keys.insert(key);
  const auto text = [](const Json& values, const std::string& key) {
    return values.contains(key) ? jsonText(values[key]) : std::string("nothing");
  };
  std::string found;
  for (const std::string& key : keys) {
    if (text(before, key) == text(now, key)) continue;
    std::string path = key.substr(1);
    std::ranges::replace(path, '/', '.');
    found += (found.empty() ? "" : "; ") + path + ": " + text(before, key) + " then, " + text(now, key) + " now";
  }
  return found;
}

/// Why there is nothing to go on from.
std::string whyNot(Store& store, const RunRecord& record) {
  const std::string id = runId(record);
  std::optional<StoredRun> other;
  for (const StoredRun& run : store.runs()) {
    if (run.id == id && run.status == RunStatus::done) return "run " + id + " is finished";
    if (run.id == id) return "run " + id + " left no checkpoint (--checkpoint-every makes them)";
    if (run.record.scenario == record.scenario && run.status != RunStatus::done) other = run;
  }
  if (other) {
    RunRecord there = other->record;
    there.documents = store.documents(other->id);
    if (const std::string keys = keysThatDiffer(there, record); !keys.empty())
      return "run " + other->id + " of " + record.scenario + " belongs to another scenario (" + keys + ")";
    return "run " + other->id + " of " + record.scenario +
           " belongs to another run; differences: " + differences(other->record, record);
  }
  return "there is no unfinished run of " + record.scenario + " in " + store.file().string();
}

std::string samplesOf(const std::optional<double>& every) {
  return every ? fmt::format("samples every {}", *every) : "samples at start and end";
}

std::string hashesOf(const std::optional<std::uint64_t>& every) {
  return every ? fmt::format("state hashes every {}", *every) : "no state hashes";
}

/// Throws if the checkpoint's run was recorded in another way, for its records could not be completed.
void requireSameRecords(const Checkpoint& c, const RecordOptions& now) {
  if (c.every == now.every && c.hashEvery == now.hashEvery) return;
  throw UsageError(fmt::format(
      "--resume: the checkpoint was made with {} and {}, but this run has {} and {}; restore the former --no-check "
      "and the scenario's former record and check, or leave out --resume to start from the beginning",
      samplesOf(c.every), hashesOf(c.hashEvery), samplesOf(now.every), hashesOf(now.hashEvery)));
}

}  // namespace

std::optional<std::uint64_t> resumeRun(Store& store, const RunRecord& record, Run& run, const RecordOptions& recording,
                                       bool quiet) {
  const auto stopped = store.resume(record);
  if (!stopped) {
    tell("nothing to resume: " + whyNot(store, record) + "; starting from the beginning", quiet);
    return std::nullopt;
  }
  requireSameRecords(stopped->checkpoint, recording);
  try {
    run.resume(stopped->checkpoint.state,
               {[&](const RecordSink& take) { store.eachRecord(stopped->id, take); }, stopped->frames});
  } catch (const InputError& error) {
    throw FileError(store.file().string() + ": run " + stopped->id + " cannot be resumed: " + error.what() +
                    "; leave out --resume to start from the beginning");
  }
  const Clock& clock = run.world().clock;
  tell(fmt::format("{} continues from step {}, time {:.6g}", record.scenario, clock.step, clock.time), quiet);
  return clock.step;
}

}  // namespace morula
