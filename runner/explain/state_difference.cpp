#include "explain/state_difference.h"

#include <algorithm>
#include <array>
#include <bit>

#include "base/cell_path.h"
#include "golden/difference.h"
#include "golden/number_text.h"
#include "simulation/world.h"

namespace morula {

namespace {

class Finder {
 public:
  std::optional<StateDifference> found;

  /// What is compared from here on. `path`: whose it is, if a cell's.
  void about(bool lineage, std::optional<std::string> path) {
    lineage_ = lineage, path_ = std::move(path), vertex_.reset(), component_.clear();
  }
  void at(int vertex, char component) { vertex_ = vertex, component_ = component; }

  void number(const char* field, double e, double a) {
    if (std::bit_cast<std::uint64_t>(e) != std::bit_cast<std::uint64_t>(a))
      note(field, exactText(e), exactText(a), compareInWords(e, a));
  }
  void natural(const char* field, std::uint64_t e, std::uint64_t a) {
    if (e != a) text(field, std::to_string(e), std::to_string(a));
  }
  void text(const char* field, const std::string& e, const std::string& a) {
    if (e != a) note(field, e, a, "expected '" + e + "', actual '" + a + "'");
  }

 private:
  void note(const char* field, const std::string& e, const std::string& a, const std::string& words) {
    if (found) return;
    std::string what = path_ ? cellName(*path_) + ": " : "";
    what += field;
    if (vertex_) what += " of vertex " + std::to_string(*vertex_) + ", " + component_;
    found = {lineage_, path_, field, vertex_, component_, e, a, what + ": " + words};
  }

  bool lineage_ = false;
  std::optional<std::string> path_;
  std::optional<int> vertex_;
  std::string component_;
};

/// Cells that only one of the two has: the first by path tells.
void comparePopulation(Finder& f, const World& e, const World& a) {
  const auto &pe = e.cells.path, &pa = a.cells.path;
  const auto [ie, ia] = std::mismatch(pe.begin(), pe.end(), pa.begin(), pa.end());
  if (ie == pe.end() && ia == pa.end()) return;
  const bool onlyExpected = ia == pa.end() || (ie != pe.end() && *ie < *ia);
  f.about(true, (onlyExpected ? *ie : *ia).text());
  f.text("life", onlyExpected ? "alive" : "not there", onlyExpected ? "not there" : "alive");
}

void compareBiology(Finder& f, const World& e, const World& a) {
  const std::size_t cells = std::min(e.cells.path.size(), a.cells.path.size());
  for (std::size_t i = 0; i < cells && !f.found; ++i) {
    f.about(true, e.cells.path[i].text());
    f.text("substances", e.biology->describe(e.cells.state[i]), a.biology->describe(a.cells.state[i]));
    f.number("last cell cycle", e.cells.lastCycle[i], a.cells.lastCycle[i]);
    f.number("growth", e.cells.growth[i], a.cells.growth[i]);
  }
}

void compareLineage(Finder& f, const World& e, const World& a) {
  const auto &le = e.lineage.entries, &la = a.lineage.entries;
  for (std::size_t i = 0; i < std::min(le.size(), la.size()) && !f.found; ++i) {
    f.about(true, le[i].path.text());
    f.text("path in the lineage", le[i].path.text(), la[i].path.text());
    f.number("born", le[i].born, la[i].born);
    f.number("ended", le[i].ended, la[i].ended);
    f.natural("born at step", le[i].bornStep, la[i].bornStep);
    f.natural("ended at step", le[i].endedStep, la[i].endedStep);
    f.text("fate", name(le[i].fate), name(la[i].fate));
    f.text("substances in the lineage", e.biology->describe(le[i].state), a.biology->describe(la[i].state));
  }
  f.about(true, std::nullopt);
  f.natural("cells ever", le.size(), la.size());
}

void compareConnections(Finder& f, const World& e, const World& a) {
  if (!e.connections || !a.connections) return;
  const auto &he = e.connections->history, &ha = a.connections->history;
  for (std::size_t i = 0; i < std::min(he.size(), ha.size()) && !f.found; ++i) {
    f.about(false, he[i].a.text());
    f.text("connection from", he[i].a.text(), ha[i].a.text());
    f.text("connection to", he[i].b.text(), ha[i].b.text());
    f.number("connection made", he[i].made, ha[i].made);
    f.number("connection released", he[i].released, ha[i].released);
    f.text("connection's end", he[i].cause, ha[i].cause);
  }
  f.about(false, std::nullopt);
  f.natural("connections ever", he.size(), ha.size());
}

void compareClock(Finder& f, const Clock& e, const Clock& a) {
  f.about(false, std::nullopt);
  f.number("clock.time", e.time, a.time);
  f.natural("clock.step", e.step, a.step);
  f.number("clock.time step", e.timeStep, a.timeStep);
  f.number("clock.epoch's time", e.epochTime, a.epochTime);
  f.natural("clock.epoch's step", e.epochStep, a.epochStep);
  f.number("clock.next cell cycle", e.nextCycle, a.nextCycle);
}

void compareVectors(Finder& f, const char* field, const Bodies& be, const Reals& e, const Bodies& ba,
                    const Reals& a, int slotE, int slotA) {
  for (int v = 0; v < be.vertexCount(slotE) && !f.found; ++v) {
    const Vector u = be.read(e, slotE, v), w = ba.read(a, slotA, v);
    f.at(v, 'x'), f.number(field, u.x, w.x);
    f.at(v, 'y'), f.number(field, u.y, w.y);
    f.at(v, 'z'), f.number(field, u.z, w.z);
  }
}

void compareBody(Finder& f, const World& e, const World& a, std::size_t cell) {
  const Bodies &be = *e.bodies, &ba = *a.bodies;
  const int s = be.slots[cell], t = ba.slots[cell];
  f.about(false, e.cells.path[cell].text());
  f.natural("vertices", static_cast<std::uint64_t>(be.vertexCount(s)),
            static_cast<std::uint64_t>(ba.vertexCount(t)));
  f.number("vertex mass", be.vertexMass[s], ba.vertexMass[t]);
  f.number("rest scale", be.restScale[s], ba.restScale[t]);
  f.number("pressure constant", be.pressureConstant[s], ba.pressureConstant[t]);
  if (f.found) return;
  compareVectors(f, "position", be, be.position, ba, ba.position, s, t);
  compareVectors(f, "acceleration", be, be.acceleration, ba, ba.acceleration, s, t);
  compareVectors(f, "velocity", be, be.velocity, ba, ba.velocity, s, t);
}

}  // namespace

std::optional<StateDifference> findStateDifference(const World& expected, const World& actual) {
  Finder f;
  comparePopulation(f, expected, actual);
  compareBiology(f, expected, actual);
  compareLineage(f, expected, actual);
  compareConnections(f, expected, actual);
  compareClock(f, expected.clock, actual.clock);
  if (expected.bodies && actual.bodies && expected.cells.path.size() == actual.cells.path.size())
    for (std::size_t i = 0; i < expected.cells.path.size() && !f.found; ++i)
      compareBody(f, expected, actual, i);
  return f.found;
}

}  // namespace morula
