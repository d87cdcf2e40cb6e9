#pragma once
// The tables of a run that was compared with measured cells (morula run --against).
#include "database/record_table.h"
#include "store/records.h"

namespace morula {

template <>
inline constexpr auto choices<FoundIn> = std::to_array<Choice<FoundIn>>({{FoundIn::both, "both", ""},
                                                                         {FoundIn::run, "run", ""},
                                                                         {FoundIn::table, "table", ""}});

template <>
inline constexpr TableInfo tableInfo<AgainstStage> = {
    .name = "against_stage",
    .part = TablePart::against,
    .context = "run_id number",
    .key = "run_id, number",
    .csv = "against_stages",
    .why = "with run --against: how far the cells lie from measured places, at each stage of the table"};
template <IsA<AgainstStage> T>
void listFields(T& stage, auto&& field) {
  auto& [ofCells, ofTime, time, cells, compared, rmsd, shapeRmsd, scale, mirroredShapeRmsd, contactF1, why, byCell] =
      stage;
  field({"of_cells", "the table's stage as a number of cells; NULL if it is a time"}, ofCells);
  field({"of_time", "the table's stage as a time; NULL if it is a number of cells", "time"}, ofTime);
  field({"time", "of the run's state; NULL if the run had no such stage", "time"}, time);
  field({"cells", "alive then"}, cells);
  field({"compared", "of which the table has places"}, compared);
  field({"rmsd", "root mean square distance, turned and moved, never mirrored", "length"}, rmsd);
  field({"shape_rmsd", "with the best scale, over the extent"}, shapeRmsd);
  field({"scale", "the best"}, scale);
  field({"mirrored_shape_rmsd", "of the cells' mirror image"}, mirroredShapeRmsd);
  field({"contact_f1", "NULL if the table lists no contacts"}, contactF1);
  field({"why", "nothing was compared; '' if something was"}, why);
}

template <>
inline constexpr TableInfo tableInfo<AgainstCell> = {.name = "against_cell",
                                                     .part = TablePart::against,
                                                     .context = "run_id",
                                                     .key = "run_id, stage, path",
                                                     .csv = "against_cells",
                                                     .why = "with `against_stage`: the distance of each cell"};
template <IsA<AgainstCell> T>
void listFields(T& cell, auto&& field) {
  auto& [stage, path, in, distance] = cell;
  field({"stage", "the number of its row in against_stage"}, stage);
  field({"path"}, path);
  field({"found_in"}, in);
  field({"distance", "NULL unless the cell was compared", "length"}, distance);
}

}  // namespace morula
