#include "analysis/tidy.h"

#include "analysis/measure_words.h"
#include "analysis/study_results.h"
#include "base/number_text.h"
#include "database/database.h"
#include "files/text.h"

namespace morula {
namespace {

/// The joins from a condition's labels to its runs.
constexpr const char* runsOfConditions =
    " FROM replicate JOIN condition ON condition.condition_id = replicate.condition_id JOIN task USING (task_id) JOIN ";

std::vector<std::string> measuresOfCells(Database& db) {
  std::vector<std::string> names;
  Statement columns(db,
                    "SELECT name FROM pragma_table_info('cell_sample') WHERE name NOT IN "
                    "('run_id', 'time', 'path', 'state') ORDER BY cid");
  for (columns.start(); columns.next();) names.push_back(columns.line(0));
  return names;
}

/// Returns the first `axes` columns of a row, and the numbers of seed and time, as the beginning of its lines.
std::string beginningOf(const Statement& row, int axes) {
  std::string line;
  for (int a = 0; a < axes; ++a) line += csvField(row.line(a)) + ",";
  return line + std::to_string(row.bits(axes)) + "," + exactText(row.finite(axes + 1)) + ",";
}

}  // namespace

void writeTidy(const std::filesystem::path& file, TidyRows rows, const std::function<void(std::string_view)>& write) {
  const StudyResults study = readStudyResults(file);  // throws StoreError for an invalid file
  Database db(file, Database::Mode::existing, std::chrono::seconds(5));
  std::string labels, header;
  for (const ResultAxis& axis : study.axes)
    labels += "condition." + sqlName(axis.name) + ", ", header += csvField(axis.name) + ",";
  const int axes = static_cast<int>(study.axes.size());
  if (rows == TidyRows::runs) {
    write(header + "seed,time,measure,value,unit\n");
    Statement values(db, "SELECT " + labels + "replicate.seed, result.time, measure, value" + runsOfConditions +
                             "result USING (run_id) WHERE task.status = 'done' "
                             "ORDER BY condition.condition_id, replicate.seed, measure, result.time");
    for (values.start(); values.next();)
      write(beginningOf(values, axes) + csvField(values.line(axes + 2)) + "," + exactText(values.finite(axes + 3)) +
            "," + unitOfMeasure(values.line(axes + 2)) + "\n");
    return;
  }
  const auto measures = measuresOfCells(db);
  std::string columns;
  std::vector<std::string> units;  // the ends of lines
  for (const std::string& name : measures) units.push_back("," + unitOfMeasure("cell." + name) + "\n");
  for (const std::string& name : measures) columns += ", cell_sample." + sqlName(name);
  write(header + "seed,time,cell,name,substances,measure,value,unit\n");
  Statement cells(
      db, "SELECT " + labels +
              "replicate.seed, cell_sample.time, iif(path = '', 'egg', path), cell.name, cell_sample.state" + columns +
              runsOfConditions +
              "cell_sample USING (run_id) LEFT JOIN cell USING (run_id, path) WHERE task.status = 'done' "
              "ORDER BY condition.condition_id, replicate.seed, cell_sample.time, path");
  for (cells.start(); cells.next();) {
    std::string beginning = beginningOf(cells, axes) + cells.line(axes + 2) + ",";
    if (!cells.isNull(axes + 3)) beginning += csvField(cells.line(axes + 3));
    beginning += "," + csvField(cells.line(axes + 4)) + ",";
    for (std::size_t m = 0; m < measures.size(); ++m) {
      const int column = axes + 5 + static_cast<int>(m);
      if (!cells.isNull(column)) write(beginning + measures[m] + "," + exactText(cells.finite(column)) + units[m]);
    }
  }
}

}  // namespace morula
