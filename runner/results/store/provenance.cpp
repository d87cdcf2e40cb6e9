#include "store/provenance.h"

namespace morula {

std::vector<Item> compareIdentity(const RunRecord& a, const RunRecord& b) {
  return {{"scenario", a.scenarioHash, b.scenarioHash},
          {"seed", std::to_string(a.seed), std::to_string(b.seed)},
          {"sources", a.build.sources, b.build.sources},
          {"compiler", a.build.compiler, b.build.compiler},
          {"flags", a.build.flags, b.build.flags},
          {"target", a.build.target, b.build.target},
          {"libraries", librariesText(a.build), librariesText(b.build)}};
}

std::vector<Item> compareConditions(const RunRecord& a, const RunRecord& b) {
  std::vector<Item> items = compareIdentity(a, b);
  items.insert(items.end(), {{"build id", buildId(a.build), buildId(b.build)},
                             {"version", a.build.version, b.build.version},
                             {"commit", a.build.gitCommit, b.build.gitCommit},
                             {"tree", a.build.gitState, b.build.gitState},
                             {"binary", a.binaryHash, b.binaryHash},
                             {"cpu", a.machine.cpu, b.machine.cpu},
                             {"cpu features", a.machine.features, b.machine.features},
                             {"kernel", a.machine.kernel, b.machine.kernel},
                             {"floating point", a.machine.fpEnvironment, b.machine.fpEnvironment},
                             {"isa", a.isa, b.isa},
                             {"threads", std::to_string(a.threads), std::to_string(b.threads)}});
  return items;
}

}  // namespace morula
