#include "explain/run_source.h"

#include <algorithm>

#include "base/error.h"
#include "base/hash.h"
#include "loop/simulate.h"
#include "simulation/restore.h"
#include "simulation/simulation.h"
#include "system/child_process.h"
#include "system/json_record.h"
#include "system/signals.h"

namespace morula {
namespace {

Hash hashFrom(const Json& j) {
  const auto hash = readHash(j.get<std::string>());
  if (!hash) throw InputError("the trail: '" + j.get<std::string>() + "' is no hash");
  return *hash;
}

Json toJson(const ChainLink& link) {
  const StateHashes& s = link.state;
  Json cells = Json::array();
  for (const CellHash& c : s.cells) cells.push_back({c.path.text(), c.hash.text()});
  return {{"step", link.step},           {"whole", s.whole.text()},
          {"clock", s.clock.text()},     {"connections", s.connections.text()},
          {"lineage", s.lineage.text()}, {"cells", cells}};
}

/// `before`: the hash of the previous link, if there is one.
ChainLink linkFrom(const Json& j, const std::optional<Hash>& before) {
  ChainLink link;
  link.step = wholeFrom<std::uint64_t>(j.at("step"));
  link.state = {
      hashFrom(j.at("whole")), hashFrom(j.at("clock")), {}, hashFrom(j.at("connections")), hashFrom(j.at("lineage"))};
  for (const Json& cell : j.at("cells"))
    link.state.cells.push_back({CellPath::parse(cell.at(0).get<std::string>()), hashFrom(cell.at(1))});
  link.hash = hashLink(before, link.step, link.state.whole);
  return link;
}

}  // namespace

ProgramRun::ProgramRun(std::string program, std::string scenario, std::function<World()> make,
                       std::vector<std::string> more)
    : RunSource(std::move(program)), scenario_(std::move(scenario)), make_(std::move(make)), more_(std::move(more)) {}

std::string ProgramRun::answer(const std::vector<std::string>& arguments) const {
  std::vector<std::string> command{name, "internal", "trail", scenario_};
  command.insert(command.end(), arguments.begin(), arguments.end());
  command.insert(command.end(), more_.begin(), more_.end());
  ChildEnd end = runChild(command);
  if (end.notStarted()) throw InputError(name + ": cannot be started; give a Morula program");
  if (!end.well())
    throw InputError(name + ": ended with exit code " + std::to_string(end.code()) +
                     "; is it a Morula that knows `internal trail` and this scenario?");
  return std::move(end.said);
}

HashTrace ProgramRun::hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) {
  const std::string text =
      answer({"--from", std::to_string(from), "--to", std::to_string(to), "--every", std::to_string(every)});
  try {
    return readHashTrace(text);
  } catch (const InputError& e) { throw InputError(name + ": " + e.what()); }
}

std::unique_ptr<World> ProgramRun::stateAt(std::uint64_t step) {
  try {
    auto world = std::make_unique<World>(make_());
    restoreState(*world, answer({"--state", std::to_string(step)}));
    return world;
  } catch (const InputError& e) {  // failed there, or of another version or scene
    noState = e.what();
    return nullptr;
  }
}

StoredRunSource::StoredRunSource(std::string name, std::vector<ChainLink> chain, std::uint64_t steps,
                                 std::string failure)
    : RunSource(std::move(name)), chain_(std::move(chain)), steps_(steps), failure_(std::move(failure)) {}

HashTrace StoredRunSource::hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) {
  HashTrace t;
  for (const ChainLink& link : chain_)
    if (link.step >= from && link.step <= to && ((link.step - from) % every == 0 || link.step == steps_))
      t.links.push_back(link);  // including the last state, at any step
  t.lastStep = std::min(to, steps_);
  if (t.lastStep == steps_) t.failure = failure_;
  return t;
}

std::unique_ptr<World> StoredRunSource::stateAt(std::uint64_t) {
  noState = "a database keeps hashes and no states; compare with a program, by --with PROGRAM";
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

OwnRun::OwnRun(std::string name, std::function<World()> make, std::function<void(World&)> advance,
               std::function<void(const World&)> watch)
    : RunSource(std::move(name)), make_(std::move(make)), advance_(std::move(advance)), watch_(std::move(watch)) {}

OwnRun::~OwnRun() = default;

bool OwnRun::goTo(std::uint64_t step) {
  if (!world_ || world_->clock.step > step) {
    world_ = std::make_unique<World>(make_());
    failure_.clear();
  }
  while (world_->clock.step < step) {
    if (!failure_.empty() || finished(*world_)) return false;
    if (watch_) watch_(*world_);
    try {
      advance_(*world_);
    } catch (const NumericalError& error) {
      if (error.want != Want::nothing) throw;  // a lack of resources does not show where runs part
      failure_ = error.what();
    }
  }
  return true;
}

bool OwnRun::addLink(HashTrace& trace) {
  const auto before = trace.links.empty() ? std::nullopt : std::optional(trace.links.back().hash);
  try {
    trace.links.push_back(nextLink(before, *world_));
  } catch (const NumericalError& error) { failure_ = error.what(); }
  return failure_.empty();
}

HashTrace OwnRun::hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) {
  HashTrace t;
  for (std::uint64_t step = from; step <= to; step += every) {
    if (!goTo(step)) break;
    if (!failure_.empty()) break;
    if (!addLink(t)) break;
  }
  // The last state is included, at any step.
  if (failure_.empty() && world_->clock.step >= from && (t.links.empty() || t.links.back().step < world_->clock.step))
    addLink(t);
  t.lastStep = world_->clock.step;
  t.failure = failure_;
  return t;
}

std::unique_ptr<World> OwnRun::stateAt(std::uint64_t step) {
  goTo(step);
  return std::move(world_);  // the next question starts the run anew
}

OwnRun scenarioRun(const Scenario& scenario, const Execution& how, const std::string& called) {
  return {called + ", " + std::string(name(how.isa)) + ", threads " + std::to_string(how.threads),
          [&scenario, how] { return makeScenarioWorld(scenario, how); }, [](World& w) { step(w); },
          [](const World&) { stopAtSignal(); }};
}

std::string writeHashTrace(const HashTrace& trace) {
  Json links = Json::array();
  for (const ChainLink& link : trace.links) links.push_back(toJson(link));
  return jsonText({{"links", links}, {"last_step", trace.lastStep}, {"failure", trace.failure}}) + '\n';
}

HashTrace readHashTrace(const std::string& text) {
  try {
    const Json json = parseJson(text);
    HashTrace trace;
    for (const Json& j : json.at("links"))
      trace.links.push_back(linkFrom(j, trace.links.empty() ? std::nullopt : std::optional(trace.links.back().hash)));
    trace.lastStep = wholeFrom<std::uint64_t>(json.at("last_step"));
    json.at("failure").get_to(trace.failure);
    return trace;
  } catch (const Json::exception& error) {
    throw InputError(std::string("the trail is cut short, or another version's: ") + error.what());
  }
}

}  // namespace morula
