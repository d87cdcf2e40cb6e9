// Reads the content of a file as plain data, and checks that it is as stored.
#include <algorithm>
#include <set>

#include "base/hash.h"
#include "database/store_error.h"
#include "store/run_tables.h"
#include "store/store.h"

namespace morula {
namespace {

/// Gives equal texts one number, in order of first appearance.
class StateNumbers {
 public:
  explicit StateNumbers(std::map<StateId, std::string>& texts) : texts_(texts) {}
  StateId operator()(std::string text) {
    const auto [place, isNew] = numbers_.try_emplace(text, static_cast<StateId>(numbers_.size()));
    if (isNew) texts_.emplace(place->second, std::move(text));
    return place->second;
  }

 private:
  std::map<std::string, StateId> numbers_;
  std::map<StateId, std::string>& texts_;
};

std::vector<StoredRun> allRuns(Statement&& s) {
  std::vector<StoredRun> runs;
  while (s.next()) {
    const std::string& id = runs.emplace_back(s.row<StoredRun>()).id;
    if (id.empty() || id.size() > 64 || id.find_first_not_of("0123456789abcdef") != id.npos)
      s.refuse(0, "needs hexadecimal digits");
  }
  return runs;
}

void readLineage(Database& db, const std::string& id, RunResults& results, StateNumbers& numberOf) {
  for (CellRow& row : rowsOf<CellRow>(db, "", id)) {
    row.cell.state = numberOf(std::move(row.state));
    if (row.name) results.names.emplace(row.cell.path, std::move(*row.name));
    results.lineage.push_back(row.cell);
  }
}

void readSamples(Database& db, const std::string& id, StateNumbers& numberOf, const std::function<void(Sample)>& take) {
  Statement whole(db, sqlTable<WorldMeasures>().select(db)), cell(db, sqlTable<CellSampleRow>().select(db)),
      contact(db, sqlTable<ContactMeasures>().select(db)),
      more(db, sqlTable<TakenMeasure>().select(db, "value IS NOT NULL"));
  for (whole.start(id); whole.next();) {
    Sample sample;
    sample.world = whole.row<WorldMeasures>();
    const double time = sample.world.time;
    if (time < 0) whole.refuse(0, "needs a time from 0");
    for (cell.start(id, time); cell.next();) {
      CellSampleRow row = cell.row<CellSampleRow>();
      row.cell.state = numberOf(std::move(row.state));
      sample.cells.push_back(std::move(row.cell));
    }
    for (contact.start(id, time); contact.next();) sample.contacts.push_back(contact.row<ContactMeasures>());
    for (more.start(id, time); more.next();) sample.more.push_back(more.row<TakenMeasure>());
    take(std::move(sample));
  }
}

void readFaces(Database& db, const std::string& id, std::vector<MeshFaces>& meshes) {
  Statement s(db,
              "SELECT CAST(d.path AS INTEGER), content, (SELECT max(length(vertices)) / 6 FROM mesh_sample m WHERE "
              "m.run_id = d.run_id AND m.mesh = CAST(d.path AS INTEGER)) FROM run_document d JOIN document USING "
              "(hash) WHERE run_id = ? AND role = 'faces' ORDER BY 1");
  for (s.start(id); s.next();) {
    if (s.isNull(2)) continue;  // no surface has this mesh
    MeshFaces& m = meshes.emplace_back();
    m.mesh = s.small(0), m.vertices = s.natural(2);
    if (!facesFrom(s.text(1), m.vertices, m.faces)) s.refuse(1, "needs three corners a face, each a vertex");
  }
}

/// Reads surfaces into the samples of `results`, which must have its samples and faces.
void readSurfaces(Database& db, const std::string& id, RunResults& results) {
  Statement s(db, sqlTable<CellSurface>().select(db));
  for (Sample& sample : results.samples)
    for (s.start(id, sample.world.time); s.next();) {
      const CellSurface& c = sample.surfaces.emplace_back(s.row<CellSurface>());
      const auto mesh = std::ranges::find(results.meshes, c.mesh, &MeshFaces::mesh);
      const int numbers = s.columns() - 1;
      if (mesh == results.meshes.end()) s.refuse(1, "needs the number of a mesh among the documents");
      if (s.text(numbers).size() != 6 * mesh->vertices)
        s.refuse(numbers, "needs six bytes for each vertex of the mesh");
    }
}

void eachLink(Database& db, const std::string& id, const std::function<void(ChainLink)>& take) {
  Statement links(db, sqlTable<ChainLink>().select(db)), cell(db, sqlTable<CellHash>().select(db));
  std::optional<std::uint64_t> last;
  for (links.start(id); links.next();) {
    ChainLink link = links.row<ChainLink>();
    // Readers divide by the distance of steps. A damaged table may hold equal steps, although its key excludes them.
    if (last && link.step <= *last) links.refuse(0, "needs steps that ascend");
    last = link.step;
    for (cell.start(id, link.step); cell.next();) link.state.cells.push_back(cell.row<CellHash>());
    take(std::move(link));
  }
}

}  // namespace

std::vector<StoredRun> Store::runs() {
  return allRuns(Statement(db_, sqlTable<StoredRun>().select(db_, "", "started, run_id")));
}

StoredRun Store::find(const std::string& id) {
  const std::string file = db_.file().string();
  if (id.empty()) {
    const std::vector<StoredRun> last =
        allRuns(Statement(db_, sqlTable<StoredRun>().select(db_, "", "started DESC, rowid DESC LIMIT 1")));
    if (last.empty()) throw StoreError(file + ": there are no runs in it");
    return last.front();
  }
  Statement s(db_, sqlTable<StoredRun>().select(db_, "substr(run_id, 1, ?) = ?", "run_id LIMIT 2"));
  const std::vector<StoredRun> found = allRuns(std::move(s.start(id.size(), id)));
  if (found.empty()) throw StoreError(file + ": no run " + id + "; `morula export " + file + "` lists them");
  if (found.size() > 1) throw StoreError(file + ": several runs begin with " + id + "; give more digits");
  return found.front();
}

RunResults Store::lineage(const std::string& id) {
  RunResults results;
  StateNumbers numberOf(results.stateTexts);
  readLineage(db_, id, results, numberOf);
  results.experiments = rowsOf<ExperimentRecord>(db_, "", id);
  return results;
}

RunResults Store::measured(const std::string& id) {
  RunResults results;
  StateNumbers numberOf(results.stateTexts);
  readLineage(db_, id, results, numberOf);
  readSamples(db_, id, numberOf, [&](Sample s) { results.samples.push_back(std::move(s)); });
  return results;
}

RunResults Store::results(const std::string& id) {
  RunResults results;
  StateNumbers numberOf(results.stateTexts);
  readLineage(db_, id, results, numberOf);
  readSamples(db_, id, numberOf, [&](Sample s) { results.samples.push_back(std::move(s)); });
  readFaces(db_, id, results.meshes);
  readSurfaces(db_, id, results);

  results.connections = rowsOf<ConnectionRecord>(db_, "", id);
  results.timeSteps = rowsOf<TimeStepRecord>(db_, "", id);
  results.settlings = rowsOf<SettlingRecord>(db_, "", id);
  results.experiments = rowsOf<ExperimentRecord>(db_, "", id);
  results.divisions = rowsOf<DivisionRecord>(db_, "", id);
  results.chain = chain(id);
  results.checks = checks(id);
  results.against = rowsOf<AgainstStage>(db_, "", id);
  for (AgainstCell& cell : rowsOf<AgainstCell>(db_, "", id))
    if (cell.stage < results.against.size()) results.against[cell.stage].byCell.push_back(std::move(cell));
  for (AgainstStage& stage : results.against) sortByDistance(stage.byCell);
  return results;
}

void Store::eachRecord(const std::string& id, const RecordSink& take) {
  RunResults part;
  StateNumbers numberOf(part.stateTexts);
  readFaces(db_, id, part.meshes);
  readSamples(db_, id, numberOf, [&](Sample s) {
    part.samples = {std::move(s)};
    readSurfaces(db_, id, part);
    take(part);
  });
  part.samples.clear();
  eachLink(db_, id, [&](ChainLink link) {
    part.chain = {std::move(link)};
    take(part);
  });
}

std::vector<ChainLink> Store::chain(const std::string& id) {
  std::vector<ChainLink> chain;
  eachLink(db_, id, [&](ChainLink link) { chain.push_back(std::move(link)); });
  return chain;
}

std::vector<CheckResult> Store::checks(const std::string& id) { return rowsOf<CheckResult>(db_, "", id); }

std::vector<SourceText> Store::documents(const std::string& id) {
  Statement s(db_,
              "SELECT role, path, content FROM run_document JOIN document USING (hash) WHERE run_id = ? "
              "ORDER BY number");
  std::vector<SourceText> documents;
  for (s.start(id); s.next();) documents.push_back({s.line(0), s.text(1), s.text(2)});
  return documents;
}

namespace {

/// Returns the runs whose rows this process has checked, by file.
std::set<std::pair<std::filesystem::path, std::string>>& intactRuns() {
  static std::set<std::pair<std::filesystem::path, std::string>> intact;
  return intact;
}

/// Throws StoreError if an index of a table with row numbers is damaged: a search by it could then miss whole rows.
void requireIndexes(Database& db) {
  for (const SqlTable* t : runTables()) {
    if (!t->info.hasRowNumbers) continue;
    Statement integrity(db, std::string("PRAGMA integrity_check(") + t->info.name + ")");
    const std::string found = integrity.next() ? integrity.text(0) : "ok";
    if (found != "ok")
      throw StoreError(db.file().string() + ": the database is damaged: " + found.substr(found.find('\n') + 1) +
                       "; restore the file from a copy, or run the scenario again");
  }
}

}  // namespace

void Store::requireAllIntact() {
  requireAllSealed(db_, [](TablePart) { return true; });
  requireIndexes(db_);
  for (const StoredRun& run : runs()) intactRuns().emplace(file(), run.id);
}

void Store::requireIntact(const std::string& id) {
  if (intactRuns().contains({file(), id})) return;
  requireSealed(db_, id);
  requireIndexes(db_);
  intactRuns().emplace(file(), id);
}

void Store::requireShownIntact(const std::string& id) {
  if (intactRuns().contains({file(), id})) return;
  static std::set<std::pair<std::filesystem::path, std::string>> shown;  // checked before
  if (!shown.emplace(file(), id).second) return;
  requireSealed(db_, id, [](TablePart part) { return part != TablePart::hashes; });
  requireIndexes(db_);
}

std::vector<ValueDifference> Store::changedRecord(const std::string& id) {
  std::vector<ValueDifference> changed;
  Statement s(db_,
              "SELECT d.number, d.role, d.hash, t.content FROM run_document d LEFT JOIN document t USING (hash) "
              "WHERE run_id = ? ORDER BY d.number");
  for (s.start(id); s.next();) {
    const std::string row = "number " + std::to_string(s.integer(0)) + ", role " + s.text(1);
    if (s.isNull(3)) {
      changed.push_back({"document", row, "", s.text(2), "no such row"});
      continue;
    }
    const std::string hash = Hasher().add(s.text(3)).digest().text();
    if (hash != s.text(2)) changed.push_back({"document", row, "content", s.text(2), hash});
  }
  const StoredRun run = find(id);
  const std::string build = buildId(run.record.build), own = runId(run.record);
  Statement row(db_, "SELECT build_id FROM run WHERE run_id = ?");
  row.start(id).next();
  if (row.text(0) != build) changed.push_back({"run", "run_id " + id, "build_id", row.text(0), build});
  if (own != id) changed.push_back({"run", "run_id " + id, "run_id", id, own});
  return changed;
}

std::vector<ValueDifference> Store::lostCells(const StoredRun& run) {
  std::vector<ValueDifference> lost;
  const auto add = [&](const char* which, const char* column, const char* stored) {
    Statement s(db_, std::string("SELECT path FROM cell c WHERE run_id = ? AND ") + which + " ORDER BY path LIMIT 1");
    if (s.start(run.id).next()) lost.push_back({"cell", "path " + s.text(0), column, stored, "no such row"});
  };
  add("parent IS NOT NULL AND NOT EXISTS (SELECT 1 FROM cell m WHERE m.run_id = c.run_id AND m.path = c.parent AND "
      "m.fate = 'divided')",
      "parent", "a mother that divided");
  add("fate = 'divided' AND (SELECT count(*) FROM cell d WHERE d.run_id = c.run_id AND d.path IN (c.path || 'A', "
      "c.path || 'B')) < 2",
      "fate", "divided into two daughters");
  if (run.status != RunStatus::done) return lost;
  Statement alive(db_, "SELECT count(*) FROM cell WHERE run_id = ? AND fate = 'alive'");
  alive.start(run.id).next();
  if (alive.natural(0) != run.cells)
    lost.push_back({"run", "run_id " + run.id, "cells", std::to_string(run.cells), std::to_string(alive.natural(0))});
  return lost;
}

}  // namespace morula
