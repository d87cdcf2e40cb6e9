#include "python/organism.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.h"
#include "database/store_error.h"
#include "drawing/png_file.h"
#include "library/table.h"
#include "library/world_tables.h"
#include "loop/scenario_run.h"
#include "loop/stored_scenario.h"
#include "observation/asked_measure.h"
#include "pictures/pictures.h"
#include "reader/source.h"
#include "state/checkpoint.h"
#include "state/state_hash.h"
#include "store/result_rows.h"
#include "store/store.h"
#include "trees/lineage_tree.h"
#include "values/cell_words.h"
#include "views/picture_maker.h"

namespace morula {
namespace {

Scenario read(const std::string& source, const std::vector<std::string>& sets) {
  const auto overrides = overridesOf(sets, {});
  if (source.find('\n') == source.npos && source.find('\0') != source.npos)
    throw InputError("scenario: the name of a file holds no character 0");
  if (source.find('\n') != source.npos || !isDatabase(source)) return readSource(source, overrides);
  const Scenario stored = storedScenario(source, "");
  return overrides.empty() ? stored : readScenario(stored.bytes, source, "", overrides, stored.files);
}

/// Returns the record by which a saved state is known to be of this scenario, seed and program.
RunRecord identityOf(const Scenario& scenario) {
  RunRecord record;
  record.scenario = scenario.scene.name;
  record.scenarioHash = scenario.meaning.text();
  record.seed = scenario.scene.seed;
  return record;
}

/// Returns the names of the columns before a row's own, without the run's id.
std::string contextWithoutRun(const TableInfo& info) {
  const std::string all = info.context;
  return all.size() > 7 ? all.substr(7) : "";  // "run_id time"
}

DataColumn::Kind kindOf(const std::string& sqlType) {
  if (sqlType.starts_with("REAL")) return DataColumn::Kind::real;
  if (sqlType.starts_with("INTEGER")) return DataColumn::Kind::whole;
  return sqlType.starts_with("BLOB") ? DataColumn::Kind::bytes : DataColumn::Kind::text;
}

}  // namespace

Organism::Organism(const std::string& source, const std::vector<std::string>& sets, int threads)
    : sets_(sets), scenario_(read(source, sets)) {
  execution_.threads = threads;
  begin();
}

Organism::Organism(const ScenarioSource& s, int threads)
    : sets_(s.sets), scenario_(readScenario(s.bytes, s.name, "", overridesOf(s.sets, {}), s.files)) {
  execution_.threads = threads;
  begin();
}

void Organism::begin() {
  World world = makeScenarioWorld(scenario_, execution_);
  now_.reset(), ended_.reset(), failure_.clear();
  samples_.emplace(recordingOf(scenario_, false));
  run_.emplace(std::move(world), RunSetup{.label = scenario_.scene.name, .nameOf = scenario_.names.function()});
  run_->watch(*samples_);
}

void Organism::run(double time, std::uint64_t most, const std::function<bool()>& stops) {
  if (!failure_.empty()) throw NumericalError(failure_, Want::nothing);
  if (ended_) return;
  now_.reset();
  const std::uint64_t step = world().clock.step;
  end(run_->until(time, most > neverDue - step ? neverDue : step + most, stops));
}

void Organism::end(const RunEnd& end) {
  if (end.status == RunStatus::killed) return;
  ended_ = samples_->take(world(), end);
  if (end.status != RunStatus::failed) return;
  failure_ = end.failure;
  throw NumericalError(failure_, end.want);
}

std::string Organism::hash() const {
  if (!failure_.empty()) throw InputError("a run that failed has no hash; it failed with: " + failure_);
  return stateHash(world()).text();
}

std::string Organism::save() const {
  if (!failure_.empty()) throw InputError("a run that failed cannot be saved; it failed with: " + failure_);
  Store store = Store::inMemory();
  const std::string id = store.begin(identityOf(scenario_));
  store.keepCheckpoint(id, {world().clock.step, scenario_.record.every, {}, saveState(world())}, records());
  return store.bytes();
}

void Organism::restore(const std::string& state) {
  std::optional<Store> store;
  std::optional<ResumedRun> saved;
  try {
    store = Store::inMemory(state.empty() ? "no state" : state);
    saved = store->resume(identityOf(scenario_));
  } catch (const FileError&) {
    throw InputError("the bytes are no saved state, or a damaged one; needs what save() returned");
  }
  if (!saved)
    throw InputError("the saved state is of another scenario, seed or Morula; needs one of '" + scenario_.scene.name +
                     "', seed " + std::to_string(scenario_.scene.seed) + ", with the same keys and program");
  begin();
  run_->resume(saved->checkpoint.state, {[&](const RecordSink& take) { store->eachRecord(saved->id, take); }, {}});
  if (morula::finished(world())) end(endOf(world(), RunStatus::done));
}

DataTable Organism::table(const std::string& name) const {
  const SqlTable* found = nullptr;
  std::string known;
  for (const SqlTable* t : runTables()) {
    if (t->info.part != TablePart::samples && t->info.part != TablePart::end) continue;
    if (name == t->info.name) found = t;
    known += (known.empty() ? "" : ", ") + std::string(t->info.name);
  }
  if (!found) throw InputError("there is no table '" + name + "'; needs one of " + known);
  if (found->info.part == TablePart::end) return tableNow(name);
  DataTable table{name, {}};
  const std::string context = contextWithoutRun(found->info);
  visitRecords(records(), [&](std::uint64_t, const auto& row, const auto&... values) {
    using Row = std::remove_cvref_t<decltype(row)>;
    if constexpr (tableInfo<Row>.part == TablePart::samples)
      if (name == tableInfo<Row>.name) addRow(table, context, row, values...);
  });
  if (!table.columns.empty()) return table;
  for (const auto* columns : {&found->context, &found->own})
    for (const SqlColumn& c : *columns)
      if (c.name != "run_id") table.columns.push_back({c.name, c.unit, c.meaning, kindOf(c.type), {}, {}});
  return table;
}

const Observation& Organism::now() const {
  if (!now_) now_.emplace(world());
  if (scenario_.check.reference) now_->reference = &*scenario_.check.reference;
  return *now_;
}

DataTable Organism::tableNow(const std::string& name) const {
  return worldTable(now(), name, scenario_.names.function());
}

AskedMeasure Organism::measureNamed(const std::string& name) const {
  return resolved(readMeasure(name, IfSeveral::first), scenario_.names, scenario_.scene.dna);
}

MeasuredNow Organism::measure(const std::string& name) const {
  const AskedMeasure asked = measureNamed(name);
  if (asked.scope == Scope::pair)
    throw InputError("'" + name + "' measures pairs of cells; needs a measure of the organism or of cells");
  const auto taken = takeMeasures(now(), std::vector{asked.name});
  const auto& paths = world().cells.path;
  MeasuredNow measured{asked.scope == Scope::cell, {}};
  measured.values.assign(measured.ofCells ? paths.size() : 1, std::numeric_limits<double>::quiet_NaN());
  for (const TakenMeasure& t : taken)
    measured.values[measured.ofCells ? std::size_t(cellNumber(world().cells, t.a)) : 0] = t.value;
  return measured;
}

Surfaces Organism::surfaces() const {
  Surfaces all;
  const auto& paths = world().cells.path;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto first = std::int32_t(all.cell.size());
    const Mesh mesh = cellMesh(world(), paths[i]);
    all.start.push_back(first);
    for (const Point& p : mesh.vertices) all.vertices.insert(all.vertices.end(), {p.x, p.y, p.z});
    all.cell.insert(all.cell.end(), mesh.vertices.size(), std::int64_t(i));
    for (const Face& face : mesh.faces)
      for (const auto corner : face) all.triangles.push_back(first + std::int32_t(corner));
  }
  all.start.push_back(std::int64_t(all.cell.size()));
  return all;
}

std::string Organism::picture(const std::string& colour, int size) const {
  if (!world().bodies) return drawLineage(lineagePictureOf(world(), scenario_)).file(PictureFormat::png);
  const bool isColoured = !scenario_.colours.empty() || !scenario_.cellColours.empty();
  PictureWishes wishes;
  wishes.colouring = parseColouring(!colour.empty() ? colour : isColoured ? "substance" : "clone");
  wishes.width = wishes.height = size;
  PictureMaker maker(scenario_, wishes);
  maker.add(world());
  return pngFile(drawOrganism(maker.take()[0]));
}

}  // namespace morula
