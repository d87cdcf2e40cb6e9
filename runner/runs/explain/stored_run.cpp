#include "explain/stored_run.h"

#include <algorithm>

#include "simulation/world.h"

namespace morula {

StoredRunSource::StoredRunSource(std::string name, std::vector<ChainLink> chain, std::uint64_t steps,
                                 std::string failure)
    : name_(std::move(name)), failure_(std::move(failure)), chain_(std::move(chain)), steps_(steps) {}

HashTrace StoredRunSource::hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) {
  HashTrace t;
  for (const ChainLink& link : chain_)
    if (link.step >= from && link.step <= to && ((link.step - from) % every == 0 || link.step == steps_))
      t.links.push_back(link);  // the last state, too, wherever it lies
  t.lastStep = std::min(to, steps_);
  if (t.lastStep == steps_) t.failure = failure_;
  return t;
}

std::unique_ptr<World> StoredRunSource::stateAt(std::uint64_t) {
  noState = "a database keeps hashes, not states";
  return nullptr;
}

std::string findBrokenLink(const std::vector<ChainLink>& chain, std::uint64_t& step) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const ChainLink& link = chain[i];
    step = link.step;
    if (hashWhole(link.state) != link.state.whole)
      return "at step " + std::to_string(step) +
             " the hashes of cells and parts do not make up that of the state: a row of "
             "cell_hash or step_hash is lost or edited";
    const auto before = i ? std::optional(chain[i - 1].hash) : std::nullopt;
    if (hashLink(before, step, link.state.whole) != link.hash)
      return "at step " + std::to_string(step) +
             " the chain of hashes is broken: this row of step_hash or one before it is lost or edited";
  }
  return {};
}

}  // namespace morula
