#pragma once
// The runs of a database that another run can go on from: those whose scenario is the same but for an earlier stop and
// fewer experiments.
#include <cstddef>
#include <optional>
#include <string>

#include "scenario/scenario.h"
#include "store/store.h"

namespace morula {

struct Mother {
  StoredRun run;
  Checkpoint checkpoint;
  std::size_t added = 0;       // experiments that the other run has and she has not
  bool changesHashes = false;  // she has none at all, and so her hashes do not count what was done
};

/// Returns the keys that differ between the scenarios of two runs, with both values, "stop.cycles: 2 then, 3 now".
std::string keysThatDiffer(const RunRecord& there, const RunRecord& here);

/// Returns the run whose checkpoint is the latest of those that a run with this record can go on from; absent without
/// one. `id`: only this run; `why` then says what is wrong with it.
std::optional<Mother> findMother(Store& store, const RunRecord& record, const std::string& id, std::string& why);

/// Returns the time [time] at which other runs go on from a run that has ended: its planned end if it came to that,
/// else what its clock showed.
double timeOfGoingOn(const StoredRun& run, const Scene& scene);

/// Returns the scenario of a stored run with these changes: `stop` and `experiments` replace its own, and a parameter
/// that may change while a scene runs is set by a further experiment at the time of going on. Throws UsageError for
/// other keys, and for none at all if the run has ended.
Scenario scenarioGoingOn(Store& store, const StoredRun& run, const std::vector<Override>& changes,
                         const Execution& execution);

}  // namespace morula
