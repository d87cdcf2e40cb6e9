#include "tracks/measured.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "base/number_text.h"
#include "document/words.h"
#include "tracks/cell_table.h"
#include "tracks/embryo.h"
#include "tracks/wording.h"
#include "values/delimited_text.h"

namespace morula::tracks {
namespace {

/// The length and the time [of the scene] of one length and one time of the table.
struct Factors {
  double length, time;
};

double factorOf(const std::string& given, const std::string& scene, const char* what) {
  if (given == scene) return 1;
  const std::string rule = std::string("--against-units: the table's ") + what + " is in " + inQuotes(given);
  if (scene.empty())
    throw InputError(rule + ", and the scenario's `units` give no " + what +
                     "; add them to the scenario, or say that the table has the scene's own, as --against-units scene");
  throw InputError(rule + ", and the scenario's `units` are in " + inQuotes(scene) +
                   "; give the table's in these, with a factor if needed, as 0.5" + scene);
}

Factors factorsOf(const std::optional<Units>& given, const Units& scene) {
  if (given && !given->any()) return {1, 1};
  if (!given) return {1 / scene.perLength, 1 / scene.perTime};
  return {factorOf(given->length, scene.length, "length") * given->perLength / scene.perLength,
          factorOf(given->time, scene.time, "time") * given->perTime / scene.perTime};
}

class MeasuredReader {
 public:
  MeasuredReader(const CellNames& names, const Factors& factors, scenario::Problems& problems)
      : names_(names), factors_(factors), problems_(problems) {}

  MeasuredCells read(std::string_view text, const MeasuredOptions& options) {
    const CellTable table = readCellTable(text, problems_, {true, options.columns});
    if (!problems_.empty()) return {};
    if (!table.ignored.empty()) found_.told.push_back("columns that are not read: " + listed(table.ignored));
    if (table.form == Form::stages) readStages(table);
    else readTracks(table);
    for (auto& [key, stage] : stages_) found_.stages.push_back(std::move(stage));
    if (problems_.empty()) requireCells();
    if (!unknown_.empty())
      found_.told.push_back("the scenario has no cells that are called " +
                            listed(std::vector(unknown_.begin(), unknown_.end())));
    return std::move(found_);
  }

 private:
  void complain(int line, std::string what, std::string right) {
    problems_.add({line, 1, ""}, "", std::move(what), std::move(right));
  }

  /// Returns the cell, or nothing for one that the scenario does not know.
  std::optional<CellPath> cellOf(const std::string& text, bool isPath) {
    try {
      return cellCalled(names_, isPath && text != "egg" ? "/" + text : text, "");
    } catch (const InputError&) { unknown_.insert(inQuotes(text)); }
    return {};
  }

  void readStages(const CellTable& table) {
    for (const Row& row : table.rows) {
      if (problems_.size() >= scenario::maxProblems) return;
      const double time = row.stage > 0 ? 0 : row.time * factors_.time;
      if (time < 0)
        complain(row.line, "the time " + numberText(row.time) + " is before the run begins", "needs 0 or more");
      MeasuredStage& stage = stageOf(row.stage, time);
      const std::string text(row.cell);
      const auto cell = cellOf(text, table.arePaths);
      if (!cell) continue;
      const auto [line, isNew] = lines_[{row.stage, time}].try_emplace(*cell, row.line);
      if (!isNew)
        complain(row.line,
                 inQuotes(text) + " stands in line " + std::to_string(line->second) + " already, " +
                     (row.stage > 0 ? "for " + std::to_string(row.stage) + " cells" : "at " + numberText(row.time)),
                 "keep one row of each cell and stage");
      stage.measured.positions[*cell] = row.place * factors_.length;
      addContacts(row, *cell, table.arePaths, stage.measured);
    }
  }

  void addContacts(const Row& row, const CellPath& cell, bool arePaths, Reference& measured) {
    constexpr std::string_view between = " ;,|";
    for (std::string_view rest = row.contacts; !rest.empty();) {
      const std::string word(rest.substr(0, rest.find_first_of(between)));
      rest.remove_prefix(std::min(rest.size(), word.size() + 1));
      const auto other = word.empty() ? std::nullopt : cellOf(word, arePaths);
      if (!other) continue;
      if (*other == cell || other->isAncestorOf(cell) || cell.isAncestorOf(*other))
        complain(row.line, inQuotes(row.cell) + " and " + inQuotes(word) + " never live together",
                 "a contact needs two cells of which neither descends from the other");
      measured.contacts.insert(std::minmax(cell, *other));
    }
  }

  void readTracks(const CellTable& table) {
    if (table.isFlat)
      complain(1, "there is no column z", "places are compared in space: add z, or name its column with --columns");
    Lineage lineage = makeLineage(table, "", problems_);
    const auto isPlaced = [](const TrackedCell& c) { return !c.seen.empty(); };
    if (problems_.empty() && std::ranges::none_of(lineage.cells, isPlaced))
      complain(1, "the table has no places of cells", "needs columns x, y and z");
    if (!problems_.empty()) return;
    std::ranges::copy(lineage.assumed, std::back_inserter(found_.told));
    const Embryo embryo = makeEmbryo(std::move(lineage), {});
    for (const Stage& stage : embryo.stages) {
      if (stage.places.size() < 3) continue;
      Reference& measured = stageOf(stage.cells, 0).measured;
      for (const auto& [number, place] : stage.places)
        if (const auto cell = cellOf(embryo.lineage.cells[static_cast<std::size_t>(number)].name, false))
          measured.positions[*cell] = (place * embryo.length + embryo.centre) * factors_.length;
    }
  }

  MeasuredStage& stageOf(int cells, double time) {
    MeasuredStage& stage = stages_[{cells, time}];
    stage.cells = cells, stage.time = time;
    return stage;
  }

  void requireCells() {
    std::size_t most = 0;
    for (const MeasuredStage& stage : found_.stages) most = std::max(most, stage.measured.positions.size());
    if (most == 0 && !unknown_.empty())
      complain(1,
               "the scenario knows none of the table's cells: " + listed(std::vector(unknown_.begin(), unknown_.end())),
               "call cells as `names` of the scenario does, or by lineage paths, as AAB, in a column name or path");
    else if (most < 3)
      complain(1, "no stage has three cells that the scenario knows", "a comparison needs three cells of one stage");
  }

  const CellNames& names_;
  const Factors factors_;
  scenario::Problems& problems_;
  MeasuredCells found_;
  std::map<std::pair<int, double>, MeasuredStage> stages_;
  std::map<std::pair<int, double>, std::map<CellPath, int>> lines_;  // of each cell in the file
  std::set<std::string> unknown_;
};

}  // namespace

MeasuredCells readMeasured(std::string_view text, const std::string& file, const CellNames& names, const Units& scene,
                           const MeasuredOptions& options) {
  scenario::Problems problems(file);
  MeasuredCells found = MeasuredReader(names, factorsOf(options.units, scene), problems).read(text, options);
  problems.throwIfAny();
  return found;
}

}  // namespace morula::tracks
