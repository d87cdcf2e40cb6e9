// The file around the fields, with the scene that it is of. A state is checked before it is taken over, so that nothing
// afterwards can read past an end. The hash of the file finds damage; these checks find files that another program
// wrote.

#include "state/checkpoint.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "state/checkpoint_state.h"
#include "state/scene_parts.h"

namespace morula {
namespace {

constexpr std::string_view magic = "MORULACP";
constexpr std::size_t numberSize = sizeof(std::uint64_t);
constexpr std::size_t headSize = magic.size() + 2 * numberSize, tailSize = 2 * numberSize;

[[noreturn]] void refuse(const std::string& why) { throw InputError("checkpoint: " + why); }

void append(std::string& bytes, std::uint64_t value) {
  bytes.append(reinterpret_cast<const char*>(&value), numberSize);
}

std::uint64_t numberAt(std::string_view bytes, std::size_t at) {
  std::uint64_t value;
  std::memcpy(&value, bytes.data() + at, numberSize);
  return value;
}

Hash hashOf(std::uint64_t version, std::string_view fields) {
  Hasher h;
  h.field("checkpoint").add(version).add(fields);
  return h.digest();
}

std::string sealed(const std::string& fields) {
  std::string bytes;
  bytes.reserve(headSize + fields.size() + tailSize);
  bytes += magic;
  append(bytes, checkpointVersion);
  append(bytes, fields.size());
  bytes += fields;
  const Hash hash = hashOf(checkpointVersion, fields);
  append(bytes, hash.high);
  append(bytes, hash.low);
  return bytes;
}

std::string_view unsealed(std::string_view bytes) {
  if (bytes.substr(0, magic.size()) != magic) refuse("these bytes are not a checkpoint");
  if (bytes.size() < headSize) refuse("the checkpoint is cut short within its first bytes");
  const std::uint64_t version = numberAt(bytes, magic.size()), length = numberAt(bytes, magic.size() + numberSize);
  if (version != checkpointVersion)
    refuse("the checkpoint has format " + std::to_string(version) + ", and this program reads format " +
           std::to_string(checkpointVersion) + "; resume with the program that wrote the checkpoint");
  const std::size_t rest = bytes.size() - headSize;
  if (rest < tailSize || rest - tailSize < length)
    refuse("the checkpoint is cut short: " + std::to_string(bytes.size()) + " bytes of it are present");
  if (rest - tailSize > length) refuse("more bytes follow than belong to it");
  const std::string_view fields = bytes.substr(headSize, length);
  const Hash kept{numberAt(bytes, headSize + length), numberAt(bytes, headSize + length + numberSize)};
  if (kept != hashOf(version, fields)) refuse("the checkpoint is damaged: its hash is not that of its content");
  return fields;
}

void writeScene(FieldWriter& out, const Scene& scene) {
  Texts names, hashes;
  for (const auto& [name, hash] : hashSceneParts(scene)) names.push_back(name), hashes.push_back(hash);
  out.add("scene.parts", names);
  out.add("scene.hashes", hashes);
}

void checkScene(FieldReader& in, const Scene& scene) {
  const Texts names = in.texts("scene.parts"), hashes = in.texts("scene.hashes");
  const std::vector<ScenePart> parts = hashSceneParts(scene);
  if (names.size() != hashes.size()) refuse("the checkpoint does not hold enough of its scene");
  std::string others;
  const auto differ = [&](const std::string& name) { others += (others.empty() ? "" : ", ") + name; };
  for (const auto& [name, hash] : parts) {
    const auto at = std::ranges::find(names, name);
    if (at == names.end() || hashes[at - names.begin()] != hash) differ(name);
  }
  for (const std::string& name : names)  // parts that only the other scene has
    if (std::ranges::find(parts, name, &ScenePart::name) == parts.end()) differ(name);
  if (!others.empty()) refuse("the checkpoint belongs to another scene; this scene differs in: " + others);
}

/// False for infinities.
bool isPositive(double a) { return a > 0 && a < INFINITY; }

void checkClock(const Clock& c, bool hasTimeStep) {
  demand(std::isfinite(c.time) && std::isfinite(c.epochTime) && c.epochStep <= c.step, "the clock");
  if (hasTimeStep) demand(isPositive(c.timeStep), "the time step");
}

/// Demands that the living cells and their entries belong to each other.
void checkCells(const Cells& cells, const std::vector<LineageEntry>& entries) {
  const auto alive = std::ranges::count(entries, Fate::alive, &LineageEntry::fate);
  const auto& path = cells.path;
  demand(static_cast<std::size_t>(alive) == path.size(), "the living cells are not those of the lineage");
  for (std::size_t i = 0; i < path.size(); ++i) {
    demand(i == 0 || path[i - 1] < path[i], "the order of cells");
    const std::size_t entry = cells.entry[i];
    demand(entry < entries.size() && entries[entry].path == path[i] && entries[entry].fate == Fate::alive,
           cellName(path[i].text()) + " is not in the lineage");
  }
  for (double time : cells.lastCycle) demand(std::isfinite(time), "the time of a cell cycle");
}

void checkConnections(const std::vector<ConnectionRecord>& history, const std::vector<CellPath>& living) {
  std::set<std::pair<CellPath, CellPath>> active;
  const auto lives = [&](const CellPath& path) { return std::ranges::binary_search(living, path); };
  for (const auto& [a, b, made, released, cause] : history) {
    const bool holds = released < 0;
    demand(a < b && (!holds || (lives(a) && lives(b) && active.insert({a, b}).second)),
           "a connection of '" + a.text() + "' and '" + b.text() + "'");
  }
}

void checkPolarities(const std::vector<PolarityRecord>& polarities) {
  for (std::size_t i = 0; i < polarities.size(); ++i)
    demand(
        (i == 0 || polarities[i - 1].path < polarities[i].path) && std::abs(norm(polarities[i].direction) - 1) < 1e-6,
        "the polarity that '" + polarities[i].path.text() + "' left to its daughters");
}

}  // namespace

std::string saveState(const World& world) {
  FieldWriter fields;
  writeScene(fields, world.model);
  writeState(fields, world);
  return sealed(fields.bytes());
}

SavedState readCheckpoint(std::string_view checkpoint, const World& world, std::size_t added) {
  FieldReader fields(unsealed(checkpoint), "checkpoint");
  Scene scene = world.model;
  MORULA_CHECK(added <= scene.experiments.size(), "the experiments that were added are of the scene");
  scene.experiments.resize(scene.experiments.size() - added);
  checkScene(fields, scene);
  SavedState state = readState(fields, world, !scene.experiments.empty());
  checkSavedState(state, world);
  return state;
}

void checkSavedState(const SavedState& s, const World& world) {
  const World& read = s.world;
  checkClock(read.clock, world.bodies && !world.settlings);
  checkCells(read.cells, read.lineage.entries);
  if (world.bodies)
    for (int slot : read.bodies->slots)
      demand(isPositive(read.bodies->vertexMass[slot]) && isPositive(read.bodies->restScale[slot]),
             "a cell's mass or size");
  for (const Columns* radii : {&s.contacts.radius, &s.contacts.snapshotRadius})
    for (double a : *radii) demand(isPositive(a), "a cell's influence radius");
  if (world.polarities) checkPolarities(*read.polarities);
  if (read.experiments)
    for (const ExperimentRecord& record : *read.experiments)
      demand(record.number >= 1 && record.number <= world.model.experiments.size(), "an experiment that was done");
  if (world.connections) checkConnections(read.connections->history, read.cells.path);
  if (world.birthSizes) {
    demand(read.birthSizes->size() == read.cells.path.size(), "a cell's size at birth");
    for (const BirthSize& birth : *read.birthSizes) demand(isPositive(birth.size), "a cell's size at birth");
  }
}

}  // namespace morula
