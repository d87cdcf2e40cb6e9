#pragma once
// A run made by hand, with something in every table and numbers that are easily lost, and files that hold the run.
#include <limits>

#include "store/store.h"
#include "temporary_folder.h"

namespace morula {

inline LineageEntry cell(const char* path, double born, std::uint64_t bornStep, Fate fate, StateId state,
                         double ended = 0, std::uint64_t endedStep = 0) {
  return {CellPath::parse(path), born, ended, bornStep, endedStep, fate, state};
}

inline RunRecord exampleRecord() {
  RunRecord r;
  r.scenario = "unique-four";
  r.scenarioHash = "0123456789abcdef0123456789abcdef";
  r.seed = 20080617;
  r.documents = {{"scenario", "scenarios/thesis/unique-four.yaml", std::string("morula: 1\n\0 bytes \xff", 19)},
                 {"resolved", "", "morula: 1\nseed: 20080617\n"}};
  r.command = "morula run scenarios/thesis/unique-four.yaml";
  r.isa = "avx2";
  r.threads = 2;
  return r;
}

inline RunResults exampleResults() {
  RunResults r;
  r.stateTexts = {{3, "START a0"}, {7, "a4"}, {9, ""}};
  r.lineage = {cell("", 0, 0, Fate::divided, 3, 1.0 / 3, 683), cell("A", 1.0 / 3, 683, Fate::alive, 7),
               cell("B", 1.0 / 3, 683, Fate::died, 9, 0.1 + 0.2, 700)};
  r.names = {{CellPath::parse("A"), "AB"}};
  Sample start, later;
  start.world["cells"] = 1;
  start.world["volume"] = 4.1887902047863905;
  start.cells.resize(1);
  start.cells[0].state = 3;
  start.cells[0]["volume"] = start.world["volume"];
  start.cells[0]["neighbours"] = 0;
  later.world.time = 0.1 + 0.2;
  later.world.step = 700;
  for (const auto& [name, value] : {std::pair("cells", 1.0),
                                    {"volume", std::numeric_limits<double>::denorm_min()},
                                    {"kinetic_energy", 1e308},
                                    {"mean_pressure", -std::numeric_limits<double>::infinity()},
                                    {"shell_fill", 0.85},
                                    {"outermost", 0.9999999999999999}})
    later.world[name] = value;
  CellMeasures& cell = later.cells.emplace_back();
  cell.path = CellPath::parse("A");
  cell.state = 7;
  for (const auto& [name, value] : {std::pair("volume", 1.0 / 3),
                                    {"area", std::numeric_limits<double>::max()},
                                    {"pressure", -1e-320},
                                    {"x", 0.1},
                                    {"y", -0.2},
                                    {"z", 1e-17},
                                    {"sphericity", 1},
                                    {"neighbours", 1}})
    cell[name] = value;
  ContactMeasures& contact = later.contacts.emplace_back();
  contact.a = CellPath::parse("A");
  contact.b = CellPath::parse("B");
  contact["area"] = 0.7;
  r.samples = {start, later};
  r.connections = {{CellPath::parse("A"), CellPath::parse("B"), 1.0 / 3, 0.1 + 0.2, ReleaseCause::died},
                   {CellPath::parse("A"), CellPath::parse("B"), 1.0 / 3, -1, ReleaseCause::none}};
  r.timeSteps = {{0, 0, 0.00048828125}, {1.0 / 3, 683, 0.000244140625}};
  r.divisions = {{{}, 1.0 / 3, 683, {0.6, -0.8, 1e-17}, 0.58, 1.0000000000000002},
                 {CellPath::parse("A"), 0.1 + 0.2, 700, {0, 0, 1}, 0.5, {}}};
  r.chain = {
      {0, {1, 2}, {{3, 4}, {5, 6}, {{CellPath(), {7, 8}}}, {}, {9, 10}}},
      {512,
       {0xffffffffffffffffu, 0},
       {{11, 12}, {13, 14}, {{CellPath::parse("A"), {15, 16}}, {CellPath::parse("B"), {17, 18}}}, {19, 20}, {21, 22}}}};
  CheckResult check;
  check.check = "values final/*/volume";
  check.kind = CheckKind::golden;
  check.expected = "0.5";
  check.actual = "0.6";
  check.tolerance = "rel 1e-9";
  check.passed = false;
  check.failureClass = FailureClass::computation;
  check.firstStep = 700;
  check.cell = "";
  check.field = "volume";
  check.share = 2e8;
  check.message = "two\nlines";
  CheckResult passed;
  passed.check = "energy";
  passed.kind = CheckKind::invariant;
  r.checks = {check, passed};
  return r;
}

inline RunEnd exampleEnd() {
  return {.status = RunStatus::done, .stateHash = Hash{0xabc, 0xdef}, .steps = 700, .cells = 1, .time = 0.1 + 0.2};
}

/// A file of results in a folder of its own.
struct ResultsFile {
  TemporaryFolder folder;
  std::filesystem::path file = folder / "runs.db";
  Store store = Store::openForWriting(file);

  /// Opens the file for plain SQL.
  Database database() const { return Database(file, Database::Mode::existing, std::chrono::seconds(1)); }
  std::int64_t count(const std::string& rows) const { return database().integer("SELECT count(*) FROM " + rows); }
};

/// A file of results in which the run has begun.
struct BegunRun : ResultsFile {
  std::string id = store.begin(exampleRecord());
  void finish(const RunResults& results = exampleResults()) { store.finish(id, exampleEnd(), results); }
};

/// A file of results in which the run is finished.
struct FinishedRun : BegunRun {
  FinishedRun() { finish(); }
};

}  // namespace morula
