#include "run/resume_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/error.h"
#include "run/mother.h"
#include "system/console.h"
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

/// Why there is nothing to go on from.
std::string whyNot(Store& store, const RunRecord& record) {
  const std::string id = runId(record);
  std::optional<StoredRun> other;
  for (const StoredRun& run : store.runs()) {
    if (run.id == id && run.status == RunStatus::done) return "run " + id + " is finished";
    if (run.id == id) return "run " + id + " left no checkpoint (--checkpoint-every makes them)";
    if (run.record.scenario == record.scenario && (run.status != RunStatus::done || store.checkpointOf(run.id)))
      other = run;
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

std::string recordsOf(const std::optional<double>& every, const std::optional<std::uint64_t>& hashEvery) {
  return samplesOf(every) + " and " + hashesOf(hashEvery);
}

/// Throws if the checkpoint's run was recorded in another way, for its records could not be completed.
void requireSameRecords(const Checkpoint& c, const RecordOptions& now) {
  if (c.every == now.every && c.hashEvery == now.hashEvery) return;
  throw UsageError(
      fmt::format("--resume: the checkpoint was made with {}, but this run has {}; restore the former --no-check "
                  "and the scenario's former record and check, or leave out --resume to start from the beginning",
                  recordsOf(c.every, c.hashEvery), recordsOf(now.every, now.hashEvery)));
}

/// Says why the records of the mother cannot be this run's; "" if they can. A run without hashes leaves out hers.
std::string whyNotRecords(const Mother& mother, const RecordOptions& now) {
  const Checkpoint& c = mother.checkpoint;
  const bool hashesDiffer = now.hashEvery && (c.hashEvery != now.hashEvery || mother.changesHashes);
  if (c.every == now.every && !hashesDiffer) return "";
  return mother.changesHashes && c.every == now.every
             ? "with its first experiment the scene has other hashes on the way; give --no-check"
             : fmt::format("it was recorded with {}, and this run has {}", recordsOf(c.every, c.hashEvery),
                           recordsOf(now.every, now.hashEvery));
}

/// Gives the record the documents of the mother, which is known by her database alone, and its own values.
void takeDocuments(Store& store, const std::string& mother, RunRecord& record) {
  std::vector<SourceText> documents = store.documents(mother);
  std::erase_if(documents, [](const SourceText& d) { return d.role == "faces"; });
  for (SourceText& d : documents)
    for (const SourceText& own : record.documents)
      if (d.role == "resolved" && own.role == "resolved") d = own;
  record.documents = std::move(documents);
}

/// Goes on from the last state of another run that is one of this run, too. Returns its step; absent, with the reason,
/// if there is none.
std::optional<std::uint64_t> goOn(Store& store, RunRecord& record, Run& run, const RecordOptions& recording,
                                  const std::string& from, bool quiet, std::string& why) {
  const auto mother = findMother(store, record, from, why);
  if (!mother) return std::nullopt;
  const std::string& id = mother->run.id;
  store.requireIntact(id);
  if (!from.empty()) takeDocuments(store, id, record);
  try {
    if (const std::string other = whyNotRecords(*mother, recording); !other.empty()) throw InputError(other);
    run.goOn(mother->checkpoint.state, mother->added,
             {[&](const RecordSink& take) { store.eachRecord(id, take); }, {}});
  } catch (const InputError& error) {
    why = "run " + id + " cannot go on so: " + error.what();
    return std::nullopt;
  }
  record.mother = id;
  const Clock& clock = run.world().clock;
  record.motherTime = mother->run.status == RunStatus::done ? mother->run.time : clock.time;
  store.begin(record);
  tell(fmt::format("{} goes on from run {}, at step {}, time {:.6g}", record.scenario, id, clock.step, clock.time),
       quiet);
  return clock.step;
}

}  // namespace

std::optional<std::uint64_t> resumeRun(Store& store, RunRecord& record, Run& run, const RecordOptions& recording,
                                       const std::string& from, bool quiet) {
  const auto stopped = store.resume(record);
  if (!stopped) {
    std::string why;
    if (const auto step = goOn(store, record, run, recording, from, quiet, why)) return step;
    if (!from.empty()) throw UsageError("--resume: " + why);
    tell("nothing to resume: " + (why.empty() ? whyNot(store, record) : why) + "; starting from the beginning", quiet);
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
