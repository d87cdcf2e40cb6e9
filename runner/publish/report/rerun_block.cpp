#include "files/text.h"
#include "library/scene_format.h"
#include "report/run_blocks.h"
#include "report_data/run_words.h"
#include "system/installation.h"
#include "system/json.h"

namespace morula {
namespace {

/// Returns the stored chain of step hashes, or, if none is stored, that of the repetition for this page.
const std::vector<ChainLink>& chainOf(const RunFacts& run) {
  const bool isMade = run.results.chain.empty() && run.again && run.again->same;
  return isMade ? run.again->simulation.results.chain : run.results.chain;
}

}  // namespace

std::string whyNoRerun(const RunFacts& run) {
  if (run.run.status != RunStatus::done) return "the run did not come to its end";
  if (run.results.lineage.empty()) return "nothing is stored of the run's cells";
  return "";
}

PageSection rerunSection(const RunFacts& run) {
  PageSection section{"rerun-section", "Run it again, here", {}};
  section.body
      .say(
          "This page holds the simulator and the scene. One press of the button makes the run again on this machine, "
          "without network, and compares the hashes of the state with those that are stored; the explorer shows the "
          "organism as it grows.")
      .add(ProgramPlace{"again",
                        "Programs of this page do not run here: JavaScript is switched off, or the file was changed."});
  section.commands = {programWord() + " replay " + shellWord(run.database) + " --run " + run.run.id};
  return section;
}

std::vector<PageBytes> rerunBytes(const RunFacts& run, const std::string& module) {
  const std::string scene = writeScene(run.scenario.scene);
  const auto& chain = chainOf(run);
  Json links = Json::array();
  for (const ChainLink& link : chain) links.push_back({link.step, link.hash.text()});
  const std::uint64_t every = chain.size() > 1 ? chain[1].step - chain[0].step : 0;
  const Json stored{{"scene", scene.substr(scene.size() - 33, 32)},
                    {"state", run.run.stateHash},
                    {"steps", run.run.steps},
                    {"every", every},
                    {"links", links}};
  return {{"rerun-module", module}, {"rerun-scene", scene}, {"rerun-stored", jsonText(stored)}};
}

}  // namespace morula
