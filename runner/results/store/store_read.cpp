// What a file holds, back as plain data.
#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <set>

#include "base/error.h"
#include "database/measure_columns.h"
#include "database/store_error.h"
#include "golden/number_text.h"
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

/// A copy of the text that lives as long as the program:
/// ConnectionRecord points to one of a handful of causes.
const char* lasting(std::string text) {
  static std::mutex mutex;
  static std::set<std::string> texts;
  const std::lock_guard lock(mutex);
  return texts.insert(std::move(text)).first->c_str();
}

// What a column of the present row holds. Each refuses what cannot be.

Fate fateFrom(const Statement& s, int column) {
  const std::string text = s.line(column);
  for (const Fate fate : {Fate::alive, Fate::divided, Fate::died})
    if (text == name(fate)) return fate;
  s.refuse(column, "needs alive, divided or died");
}

Scope scopeFrom(const Statement& s, int column) {
  const std::string text = s.line(column);
  for (const Scope scope : {Scope::world, Scope::cell, Scope::pair})
    if (text == name(scope)) return scope;
  s.refuse(column, "needs world, cell or pair");
}

RunStatus statusFrom(const Statement& s, int column) {
  const std::string text = s.line(column);
  for (const RunStatus status : {RunStatus::running, RunStatus::done, RunStatus::failed, RunStatus::killed})
    if (text == name(status)) return status;
  s.refuse(column, "needs running, done, failed or killed");
}

Hash hashFrom(const Statement& s, int column) {
  const auto hash = readHash(s.line(column));
  if (!hash) s.refuse(column, "needs 32 hexadecimal digits");
  return *hash;
}

CellPath pathFrom(const Statement& s, int column) {
  try {
    return CellPath::parse(s.line(column));
  } catch (const InputError& error) {
    s.refuse(column, std::string("needs a cell's path (") + error.what() + ")");
  }
}

std::string idFrom(const Statement& s, int column) {
  auto text = s.line(column);
  if (text.empty() || text.size() > 64 || text.find_first_not_of("0123456789abcdef") != text.npos)
    s.refuse(column, "needs hexadecimal digits");
  return text;
}

int smallFrom(const Statement& s, int column, int low) {
  const auto value = s.integer(column);
  constexpr int high = 1'000'000;
  if (value < low || value > high)
    s.refuse(column, "needs a whole number from " + std::to_string(low) + " to 1000000");
  return static_cast<int>(value);
}

std::vector<std::pair<std::string, std::string>> librariesFrom(const std::string& text) {
  std::vector<std::pair<std::string, std::string>> libraries;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find("; ", begin), text.size());
    const std::size_t space = text.rfind(' ', end - 1);
    libraries.emplace_back(text.substr(begin, space - begin), text.substr(space + 1, end - space - 1));
    begin = end + 2;
  }
  return libraries;
}

const std::string runColumns =
    "SELECT run_id, scenario, seed, status, state_hash, started, ended, steps, cells, time, failure, "
    "scenario_hash, "
    "version, sources, git_commit, git_state, compiler, flags, target, libraries, cpu, kernel, isa, threads, "
    "command, binary_hash, fp_environment, cpu_features "
    "FROM run ";

StoredRun runFrom(const Statement& s) {
  StoredRun run;
  run.id = idFrom(s, 0);
  run.record.scenario = s.line(1);
  run.record.seed = s.bits(2);
  run.status = statusFrom(s, 3);
  if (!s.isNull(4)) run.stateHash = hashFrom(s, 4).text();
  run.started = s.line(5);
  run.ended = s.line(6);
  if (!s.isNull(7)) run.steps = s.natural(7);
  if (!s.isNull(8)) run.cells = s.natural(8);
  run.time = s.isNull(9) ? 0 : s.real(9);
  run.failure = s.line(10);
  run.record.scenarioHash = s.line(11);
  run.record.build = {s.line(12), s.line(13), s.line(14), s.line(15),
                      s.line(16), s.line(17), s.line(18), librariesFrom(s.line(19))};
  run.record.machine = {s.line(20), s.line(21), s.line(27), s.line(26)};
  run.record.isa = s.line(22);
  run.record.threads = smallFrom(s, 23, 1);
  run.record.command = s.text(24);
  run.record.binaryHash = s.line(25);
  return run;
}

std::vector<StoredRun> allRuns(Statement&& s) {
  std::vector<StoredRun> runs;
  while (s.next()) runs.push_back(runFrom(s));
  return runs;
}

void readLineage(Database& db, const std::string& id, RunResults& results, StateNumbers& numberOf) {
  Statement s(db,
              "SELECT path, born, ended, fate, state, name, born_step, ended_step FROM cell WHERE run_id = ? "
              "ORDER BY born, path");
  for (s.start(id); s.next();) {
    LineageEntry e;
    e.path = pathFrom(s, 0);
    e.born = s.real(1);
    e.fate = fateFrom(s, 3);
    if (e.fate != Fate::alive) e.ended = s.real(2), e.endedStep = s.natural(7);
    e.state = numberOf(s.line(4));
    if (!s.isNull(5)) results.names.emplace(e.path, s.line(5));
    e.bornStep = s.natural(6);
    results.lineage.push_back(e);
  }
}

void readSamples(Database& db, const std::string& id, StateNumbers& numberOf,
                 const std::function<void(Sample)>& take) {
  const auto world = columnsOf<Observation>(), ofCell = columnsOf<CellContext>(), ofPair = columnsOf<Touch>();
  Statement whole(db, "SELECT time, step, " + selected(db, "sample", world) +
                          " FROM sample WHERE run_id = ? ORDER BY time");
  Statement cell(db, "SELECT path, state, " + selected(db, "cell_sample", ofCell) +
                         " FROM cell_sample WHERE run_id = ? AND time = ? ORDER BY path");
  Statement contact(db, "SELECT a, b, " + selected(db, "contact", ofPair) +
                            " FROM contact WHERE run_id = ? AND time = ? ORDER BY a, b");
  Statement more(db,
                 "SELECT scope, name, a, b, value FROM measure WHERE run_id = ? AND time = ? ORDER BY scope, "
                 "name, a, b");
  for (whole.start(id); whole.next();) {
    Sample sample;
    WorldMeasures& w = sample.world;
    if (const double time = whole.real(0); !(time >= 0 && time <= std::numeric_limits<double>::max()))
      whole.refuse(0, "needs a time from 0");
    w.time = whole.real(0), w.step = whole.natural(1);
    readValues(whole, 2, world, w.values);
    for (cell.start(id, w.time); cell.next();) {
      CellMeasures& c = sample.cells.emplace_back();
      c.path = pathFrom(cell, 0), c.state = numberOf(cell.line(1));
      readValues(cell, 2, ofCell, c.values);
    }
    for (contact.start(id, w.time); contact.next();) {
      ContactMeasures& c = sample.contacts.emplace_back();
      c.a = pathFrom(contact, 0), c.b = pathFrom(contact, 1);
      readValues(contact, 2, ofPair, c.values);
    }
    for (more.start(id, w.time); more.next();)
      if (!more.isNull(4))
        sample.more.push_back(
            {scopeFrom(more, 0), more.line(1), pathFrom(more, 2), pathFrom(more, 3), more.real(4)});
    take(std::move(sample));
  }
}

double finiteFrom(const Statement& s, int column) {
  const double value = s.real(column);
  if (!std::isfinite(value)) s.refuse(column, "needs a finite number");
  return value;
}

void readFaces(Database& db, const std::string& id, std::vector<MeshFaces>& meshes) {
  Statement s(
      db,
      "SELECT CAST(d.path AS INTEGER), content, "
      "(SELECT max(length(vertices)) / 6 FROM mesh_sample m WHERE m.run_id = d.run_id AND m.mesh = "
      "CAST(d.path AS INTEGER)) "
      "FROM run_document d JOIN document USING (hash) WHERE run_id = ? AND role = 'faces' ORDER BY 1");
  for (s.start(id); s.next();) {
    if (s.isNull(2)) continue;  // no surface has this mesh
    MeshFaces& m = meshes.emplace_back();
    m.mesh = smallFrom(s, 0, 0), m.vertices = s.natural(2);
    if (!facesFrom(s.text(1), m.vertices, m.faces)) s.refuse(1, "needs three corners a face, each a vertex");
  }
}

/// To `samples`, which are there; so are the faces.
void readSurfaces(Database& db, const std::string& id, RunResults& results) {
  Statement s(db,
              "SELECT path, mesh, low_x, low_y, low_z, step_x, step_y, step_z, vertices FROM mesh_sample "
              "WHERE run_id = ? AND time = ? ORDER BY path");
  for (Sample& sample : results.samples)
    for (s.start(id, sample.world.time); s.next();) {
      const auto real = [&](int column) { return finiteFrom(s, column); };
      CellSurface& c = sample.surfaces.emplace_back();
      c.path = pathFrom(s, 0), c.mesh = smallFrom(s, 1, 0);
      c.low = {real(2), real(3), real(4)}, c.step = {real(5), real(6), real(7)};
      const auto mesh = std::ranges::find(results.meshes, c.mesh, &MeshFaces::mesh);
      const std::string numbers = s.text(8);
      if (mesh == results.meshes.end()) s.refuse(1, "needs the number of a mesh among the documents");
      if (numbers.size() % 6 != 0 || numbers.size() / 6 != mesh->vertices)
        s.refuse(8, "needs six bytes for each vertex of the mesh");
      c.numbers = numbersFrom(numbers);
    }
}

void eachLink(Database& db, const std::string& id, const std::function<void(ChainLink)>& take) {
  Statement link(db,
                 "SELECT step, hash, state, clock, connections, lineage FROM step_hash WHERE run_id = ? "
                 "ORDER BY step");
  Statement cell(db, "SELECT path, hash FROM cell_hash WHERE run_id = ? AND step = ? ORDER BY path");
  std::optional<std::uint64_t> last;
  for (link.start(id); link.next();) {
    // Their distances divide: equal steps, which the key of a whole table excludes, must not get that far.
    if (last && link.natural(0) <= *last) link.refuse(0, "needs steps that ascend");
    last = link.natural(0);
    const auto hash = [&](int column) { return hashFrom(link, column); };
    ChainLink next{*last, hash(1), {hash(2), hash(3), {}, hash(4), hash(5)}};
    for (cell.start(id, *last); cell.next();)
      next.state.cells.push_back({pathFrom(cell, 0), hashFrom(cell, 1)});
    take(std::move(next));
  }
}

}  // namespace

std::vector<StoredRun> Store::runs() {
  return allRuns(Statement(db_, runColumns + "ORDER BY started, run_id"));
}

StoredRun Store::find(const std::string& id) {
  const std::string file = db_.file().string();
  if (id.empty()) {
    const std::vector<StoredRun> last =
        allRuns(Statement(db_, runColumns + "ORDER BY started DESC, run_id LIMIT 1"));
    if (last.empty()) throw StoreError(file + ": there are no runs in it");
    return last.front();
  }
  Statement s(db_, runColumns + "WHERE substr(run_id, 1, ?) = ? ORDER BY run_id LIMIT 2");
  const std::vector<StoredRun> found = allRuns(std::move(s.start(id.size(), id)));
  if (found.empty()) throw StoreError(file + ": no run " + id + "; `morula export` without a run lists them");
  if (found.size() > 1) throw StoreError(file + ": several runs begin with " + id + "; give more digits");
  return found.front();
}

RunResults Store::lineage(const std::string& id) {
  RunResults results;
  StateNumbers numberOf(results.stateTexts);
  readLineage(db_, id, results, numberOf);
  return results;
}

RunResults Store::results(const std::string& id) {
  RunResults results;
  StateNumbers numberOf(results.stateTexts);
  readLineage(db_, id, results, numberOf);
  readSamples(db_, id, numberOf, [&](Sample s) { results.samples.push_back(std::move(s)); });
  readFaces(db_, id, results.meshes);
  readSurfaces(db_, id, results);

  Statement connection(db_,
                       "SELECT a, b, made, released, cause FROM connection WHERE run_id = ? ORDER BY number");
  for (connection.start(id); connection.next();)
    results.connections.push_back({pathFrom(connection, 0), pathFrom(connection, 1), connection.real(2),
                                   connection.isNull(3) ? -1 : connection.real(3),
                                   lasting(connection.line(4))});

  Statement timeStep(db_, "SELECT time, step, time_step FROM time_step WHERE run_id = ? ORDER BY step");
  for (timeStep.start(id); timeStep.next();)
    results.timeSteps.push_back({timeStep.real(0), timeStep.natural(1), timeStep.real(2)});

  Statement division(db_,
                     "SELECT path, time, step, axis_x, axis_y, axis_z, share, extent_ratio FROM division "
                     "WHERE run_id = ? ORDER BY step, path");
  for (division.start(id); division.next();)
    results.divisions.push_back({pathFrom(division, 0),
                                 division.real(1),
                                 division.natural(2),
                                 {division.real(3), division.real(4), division.real(5)},
                                 division.real(6),
                                 division.isNull(7) ? std::nullopt : std::optional(division.real(7))});

  results.chain = chain(id);
  results.checks = checks(id);
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

std::vector<CheckResult> Store::checks(const std::string& id) {
  Statement s(db_,
              "SELECT \"check\", kind, expected, actual, tolerance, passed, class, first_step, cell, field, "
              "share_of_tolerance, message FROM check_result WHERE run_id = ? ORDER BY number");
  std::vector<CheckResult> checks;
  for (s.start(id); s.next();) {
    CheckResult& c = checks.emplace_back();
    c.check = s.text(0), c.kind = s.text(1), c.expected = s.text(2), c.actual = s.text(3),
    c.tolerance = s.text(4);
    c.passed = s.integer(5) != 0;
    c.failureClass = s.text(6);
    if (!s.isNull(7)) c.firstStep = s.natural(7);
    if (!s.isNull(8)) c.cell = s.text(8);
    c.field = s.text(9);
    if (!s.isNull(10)) c.share = s.real(10);
    c.message = s.text(11);
  }
  return checks;
}

std::vector<SourceText> Store::documents(const std::string& id) {
  Statement s(db_,
              "SELECT role, path, content FROM run_document JOIN document USING (hash) WHERE run_id = ? "
              "ORDER BY number");
  std::vector<SourceText> documents;
  for (s.start(id); s.next();) documents.push_back({s.line(0), s.text(1), s.text(2)});
  return documents;
}

}  // namespace morula
