#include "store/records.h"

#include "base/error.h"

namespace morula {

const char* name(RunStatus status) {
  switch (status) {
    case RunStatus::running:
      return "running";
    case RunStatus::done:
      return "done";
    case RunStatus::failed:
      return "failed";
    case RunStatus::killed:
      return "killed";
  }
  throw BugError("a run status that is not one");
}

std::string runId(const RunRecord& record) {
  Hasher hasher;
  hasher.field("scenario_hash").add(record.scenarioHash);
  hasher.field("seed").add(record.seed);
  hasher.field("build_id").add(buildId(record.build));
  return hasher.digest().text().substr(0, 16);  // 64 bits: a million runs collide with probability 3e-8
}

}  // namespace morula
