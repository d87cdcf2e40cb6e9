// The first things that people do to an embryo of their own: each takes at most three lines of the shipped worm's
// scenario, does what it says, and leaves everything before as it was, to the bit.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula::test;
using morula::Database;
using morula::Statement;

namespace {

std::multiset<std::string> linesOf(const std::string& text) {
  std::istringstream stream(text);
  std::multiset<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.insert(line);
  return lines;
}

/// Returns the lines of `text` that `before` does not have.
std::size_t newLines(const std::string& text, const std::string& before) {
  const auto now = linesOf(text), then = linesOf(before);
  std::vector<std::string> added;
  std::ranges::set_difference(now, then, std::back_inserter(added));
  return added.size();
}

/// The shipped worm in a folder of its own, with coarse cells and as far as eight of them: a fifth of a second.
class Worm : public TemporaryFolder {
 public:
  Worm() {
    std::filesystem::copy("scenarios/worm", path() + "/worm", std::filesystem::copy_options::recursive);
    wild_ = readWhole(*this / "worm/embryo.yaml");
    for (const auto& [what, by] : {std::pair{"icosphere: 2", "icosphere: 1"},
                                   {"fill: 0.905", "fill: 0.87"},
                                   {"stop: {time: 23.4}", "stop: {time: 12}"}})
      wild_ = replaced(wild_, what, by);
  }
  /// Writes the worm with another part, or a new one at its end, and returns the file.
  std::string file(const std::string& name, const std::string& what, const std::string& by) const {
    const std::string text = what.empty() ? wild_ + by + "\n" : replaced(wild_, what, by);
    CHECK(newLines(text, wild_) <= 3);
    writeWhole(*this / ("worm/" + name + ".yaml"), text);
    return *this / ("worm/" + name + ".yaml");
  }
  /// Runs it, and returns the database.
  std::string ran(const std::string& name, const std::string& what, const std::string& by) const {
    const std::string db = *this / (name + ".db");
    succeeds({"run", file(name, what, by), "--db", db, "--no-pictures", "--quiet", "--out", *this / "out"});
    return db;
  }
  std::string wild() const { return ran("wild", "", ""); }

 private:
  std::string wild_;
};

std::vector<std::string> texts(const std::string& db, const std::string& query) {
  Database file = opened(db);
  std::vector<std::string> all;
  for (Statement s(file, query); s.next();) all.push_back(s.text(0));
  return all;
}

std::map<std::string, double> numbers(const std::string& db, const std::string& query) {
  Database file = opened(db);
  std::map<std::string, double> all;
  for (Statement s(file, query); s.next();) all[s.text(0)] = s.real(1);
  return all;
}

/// Returns how long each cell lived, if the run has seen her end.
std::map<std::string, double> lives(const std::string& db) {
  return numbers(db, "SELECT name, ended - born FROM cell WHERE ended IS NOT NULL");
}

/// Returns the cells that were born.
std::vector<std::string> born(const std::string& db) { return texts(db, "SELECT name FROM cell ORDER BY name"); }

/// Returns the hashes of the cells at each sample before a time, or at each from then on.
std::vector<std::string> hashes(const std::string& db, const std::string& sign, double time) {
  return texts(db, "SELECT step || path || hash FROM cell_hash WHERE step " + sign + " (SELECT min(step) FROM sample " +
                       "WHERE time >= " + std::to_string(time) + ") ORDER BY step, path");
}

/// Checks that all cells have the wild type's bits before a time, and others afterwards.
void checkSameUntil(double time, const std::string& wild, const std::string& other) {
  const auto before = hashes(wild, "<", time);
  CHECK(before.size() > 30);
  CHECK(hashes(other, "<", time) == before);
  CHECK(hashes(other, ">", time) != hashes(wild, ">", time));
}

std::vector<std::string> without(std::vector<std::string> all, const std::vector<std::string>& some) {
  std::erase_if(all, [&](const std::string& one) { return std::ranges::find(some, one) != some.end(); });
  return all;
}

constexpr double step = 1.0 / 64;  // a life ends with a step, none of which is longer
const std::string colours = "colours: {\n";

}  // namespace

TEST_CASE("kill ABp at a time: she dies then, alone, and has no daughters") {
  const Worm worm;
  const std::string wild = worm.wild(), ablated = worm.ran("ablated", "", "experiments: [{kill: cell ABp, at: 7}]");
  CHECK(texts(ablated, "SELECT name FROM cell WHERE fate = 'died'") == std::vector<std::string>{"ABp"});
  CHECK(realIn(ablated, "SELECT ended FROM cell WHERE name = 'ABp'") == 7);
  CHECK(born(ablated) == without(born(wild), {"ABpl", "ABpr"}));
  checkSameUntil(7, wild, ablated);
}

TEST_CASE("a gene off: the cell whose division it begins lives on, and all is as it was until she would have divided") {
  const Worm worm;
  const std::string wild = worm.wild(), off = worm.ran("off", "", "experiments: [{gene-off: end4, at: 3}]");
  const double end = realIn(wild, "SELECT ended FROM cell WHERE name = 'ABp'");
  CHECK(texts(off, "SELECT fate FROM cell WHERE name = 'ABp'") == std::vector<std::string>{"alive"});
  CHECK(born(off) == without(born(wild), {"ABpl", "ABpr"}));
  checkSameUntil(realIn(wild, "SELECT born FROM cell WHERE name = 'ABp'"), wild, off);  // then her genes are read
  const std::string bodies =
      "SELECT path || quote(time) || quote(volume) || quote(area) || quote(x) || quote(y) FROM "
      "cell_sample WHERE time < " +
      nlohmann::json(end).dump() + " ORDER BY time, path";
  CHECK(texts(off, bodies).size() > 40);
  CHECK(texts(off, bodies) == texts(wild, bodies));
}

TEST_CASE("all cycles 10 % longer: so is every life") {
  const Worm worm;
  const auto wild = lives(worm.wild()),
             slow = lives(worm.ran("slow", "", "experiments: [{cycles: all, factor: 1.1, at: 0}]"));
  CHECK(slow.size() > 5);
  for (const auto& [name, life] : slow) CHECK(std::abs(life - 1.1 * wild.at(name)) < 2 * step);
}

TEST_CASE(
    "a random fifth delayed: they live longer by as much, others as long as before, and another seed has others") {
  const Worm worm;
  const auto wild = lives(worm.wild());
  std::set<std::vector<std::string>> chosen;
  for (const char* seed : {"1", "2", "3"}) {
    const std::string file =
        worm.file("late", "", "experiments: [{delay: all, by: 0.5, share: 0.2, after-birth: 0.125}]");
    const std::string db = worm / (std::string("late") + seed + ".db");
    succeeds({"run", file, "--seed", seed, "--db", db, "--no-pictures", "--quiet", "--out", worm / "out"});
    const auto delayed = texts(db, "SELECT name FROM experiment JOIN cell USING (run_id, path) ORDER BY name");
    CHECK(delayed.size() < 8);  // of fifteen; with a share of a fifth more are as rare as one in 230
    for (const auto& [name, life] : lives(db)) {
      CAPTURE(seed, name);
      const bool isLate = std::ranges::find(delayed, name) != delayed.end();
      CHECK(std::abs(life - wild.at(name) - (isLate ? 0.5 : 0)) < 2 * step);
    }
    chosen.insert(delayed);
  }
  CHECK(chosen.size() > 1);
}

TEST_CASE(
    "a parameter from a time on: a thick medium makes cells slow, as it does a run that stopped and went on with it") {
  const Worm worm;
  const std::string wild = worm.wild(),
                    thick = worm.ran("thick", "", "experiments: [{set: physics.drag, to: 40, at: 8}]");
  checkSameUntil(8, wild, thick);
  const std::string energy = "SELECT kinetic_energy FROM sample WHERE time = 8.5";
  CHECK(realIn(thick, energy) < realIn(wild, energy) / 10);  // a sixteenth, where cells move the same way
  const std::string db = worm.ran("early", "stop: {time: 12}", "stop: {time: 8}");
  const auto on = jsonOf({"run", db, "--resume", "--set", "stop.time=12", "--set", "physics.drag=40", "--no-pictures"});
  CHECK(texts(thick, "SELECT state_hash FROM run") == std::vector<std::string>{on.at("state_hash")});
}

TEST_CASE("stop when two cells touch: at the first look at which the wild type's do, with its bits") {
  const Worm worm;
  const std::string wild = worm.wild();
  const std::string met = worm.ran("met", "stop: {time: 12}",
                                   "stop: {time: 12, every: 0.5, when: [{touch: [cell MS, cell ABal], after: 10.2}]}");
  const double first = realIn(wild, "SELECT min(time) FROM contact WHERE a = 'AAA' AND b = 'BAA' AND time >= 10.2");
  CHECK(first > 10.2);
  CHECK(first < 12);
  CHECK(realIn(met, "SELECT time FROM run") == first);
  const std::string last = "SELECT path || hash FROM cell_hash WHERE step = ";
  CHECK(texts(met, last + "(SELECT steps FROM run) ORDER BY path").size() == 7);
  const std::string there = worm.ran("there", "stop: {time: 12}", "stop: {time: " + nlohmann::json(first).dump() + "}");
  CHECK(texts(met, last + "(SELECT steps FROM run) ORDER BY path") ==
        texts(there, last + "(SELECT steps FROM run) ORDER BY path"));
}

TEST_CASE("a ratio of two measures is that of their columns at each sample") {
  const Worm worm;
  const std::string db = worm.ran("ratio", "measures: [position_rmsd, contact_f1]",
                                  "measures: [position_rmsd, contact_f1, volume of cell AB / volume of cell P1]");
  const auto ratio = numbers(db, "SELECT quote(time), value FROM measure WHERE name LIKE '%/%' AND value IS NOT NULL");
  const auto ab = numbers(db, "SELECT quote(time), volume FROM cell_sample WHERE path = 'A'");
  const auto p1 = numbers(db, "SELECT quote(time), volume FROM cell_sample WHERE path = 'B'");
  CHECK(ratio.size() > 5);
  for (const auto& [time, volume] : ab) {
    CAPTURE(time);
    if (p1.contains(time)) CHECK(ratio.at(time) == volume / p1.at(time));
  }
}

TEST_CASE("colours by names of one's own: these cells have them, and no others") {
  const Worm worm;
  const std::string db = worm.ran("coloured", colours, colours + "    cell ABpl: '#123456', clone P1: '#abcdef',\n");
  succeeds({"export", db, "--format", "ply", "--time", "12", "-o", worm / "cells.ply", "--quiet"});
  const std::string ply = readWhole(worm / "cells.ply"), end = "end_header\n";
  constexpr std::size_t vertex = 19;  // three floats, three bytes of colour, and the number of the cell
  std::map<std::string, std::size_t> seen;
  for (std::size_t at = ply.find(end) + end.size() + 12, i = 0; i < 8 * 42; ++i, at += vertex) {
    char text[8];
    const auto part = [&](int k) { return unsigned(static_cast<unsigned char>(ply.at(at + k))); };
    std::snprintf(text, sizeof text, "#%02x%02x%02x", part(0), part(1), part(2));
    ++seen[text];
  }
  CHECK(seen["#123456"] == 42);
  CHECK(seen["#abcdef"] == 4 * 42);  // MS, E, C and P3
  CHECK(seen["#377eb8"] == 3 * 42);  // AB* as shipped
}

TEST_CASE(
    "one rule of a list as a level of a study: the run is that of the scenario with this rule, others as shipped") {
  const Worm worm;
  const std::string rule = "{of: EMS, axis: [-0.957, 0.11, -0.269], share: ";
  const std::string even = worm.ran("even", rule + "0.531}", rule + "0.5}"), wild = worm.wild();
  worm.file("base", "", "");
  writeWhole(worm / "worm/ems.study.yaml",
             "morula-study: 1\nname: ems\nbase: base.yaml\nseeds: 1\nmeasures: [energy]\n"
             "vary: {ems: {shipped: {}, even: {division.rules.EMS.share: 0.5}}}\n");
  succeeds({"study", "run", worm / "worm/ems.study.yaml", "--out", worm / "study", "--quiet"});
  const auto found = [&](const std::string& level) {
    return texts(worm / "study/study.db",
                 "SELECT state_hash FROM run JOIN condition USING (condition_id) WHERE ems = '" + level + "'");
  };
  CHECK(found("even") == texts(even, "SELECT state_hash FROM run"));
  CHECK(found("shipped") == texts(wild, "SELECT state_hash FROM run"));
  CHECK(found("even") != found("shipped"));
}
