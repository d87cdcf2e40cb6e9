#include "export/run_tables.h"

#include <fmt/format.h>

#include "export/csv.h"

namespace morula {

std::string cellTable(const ExportedRun& run) {
  CsvTable csv({"cell", "path", "name", "born", "ended", "fate", "state"});
  std::int64_t number = 0;
  for (const LineageEntry& cell : run.results.lineage) {
    csv.add(number++).add(std::string_view(cell.path.text())).add(std::string_view(run.nameOf(cell)));
    csv.add(std::optional(cell.born));
    csv.add(cell.fate == Fate::alive ? std::nullopt : std::optional(cell.ended)).add(std::string_view(name(cell.fate)));
    csv.add(std::int64_t{run.stateNumber(cell.state)}).endRow();
  }
  return csv.text();
}

std::string stateTable(const ExportedRun& run) {
  CsvTable csv({"state", "substances", "colour"});
  for (std::size_t i = 0; i < run.states.size(); ++i) {
    Colour colour = neutralGrey;
    for (const auto& [state, text] : run.results.stateTexts)
      if (text == run.states[i]) colour = run.colours.at(state);
    csv.add(static_cast<std::int64_t>(i)).add(std::string_view(run.states[i]));
    csv.add(std::string_view(fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b))).endRow();
  }
  return csv.text();
}

}  // namespace morula
