#include "export/tracks.h"

#include <fmt/format.h>

#include "base/number_text.h"
#include "document/words.h"
#include "system/console.h"
#include "system/usage_error.h"

namespace morula {
namespace {

/// Tells which cells no sample holds, and how often samples must be taken to hold them.
void tellUnseen(const ExportedRun& run, const std::vector<const LineageEntry*>& unseen, bool quiet) {
  if (unseen.empty()) return;
  std::vector<std::string> names;
  double shortest = 0;
  for (const LineageEntry* cell : unseen) {
    const double life = (cell->fate == Fate::alive ? run.run.time : cell->ended) - cell->born;
    if (life > 0 && (shortest == 0 || life < shortest)) shortest = life;
    names.push_back(run.nameOf(*cell));
  }
  tell(fmt::format("run {}: cells that lived between two samples have no rows: {}; {}", run.run.id, listed(names),
                   shortest > 0 ? "record.every: " + numberText(shortest, 3) + " takes a sample of each"
                                : std::string("they were born as the run ended")),
       quiet);
}

const SpotField fields[] = {
    {"track_id", "number of the cell, from 1", "",
     [](auto&, auto& s) -> TableValue { return std::int64_t(s.track + 1); }},
    {"t", "time of the sample", "time", [](auto&, auto& s) -> TableValue { return s.time; }},
    {"z", "centroid of the cell along z", "length", [](auto&, auto& s) -> TableValue { return s.place.z; }},
    {"y", "centroid of the cell along y", "length", [](auto&, auto& s) -> TableValue { return s.place.y; }},
    {"x", "centroid of the cell along x", "length", [](auto&, auto& s) -> TableValue { return s.place.x; }},
    {"parent_track_id", "track_id of the mother; 0: none", "",
     [](auto& t, auto& s) -> TableValue { return std::int64_t{t.trackOf(s).parent + 1}; }},
    {"name", "name of the cell, or else its path", "",
     [](auto& t, auto& s) -> TableValue { return t.trackOf(s).name; }},
    {"path", "lineage path: egg, or A and B for each division", "",
     [](auto& t, auto& s) -> TableValue { return csvPath(t.trackOf(s).cell->path.text()); }},
    {"volume", "volume of the cell", "length³",
     [](auto&, auto& s) -> TableValue { return s.volume ? TableValue(*s.volume) : TableValue(); }},
    {"fate", "how the cell's life ends: divided or died, or alive at the end of the run", "",
     [](auto& t, auto& s) -> TableValue { return std::string(name(t.trackOf(s).cell->fate)); }},
};

bool hasPlace(const CellMeasures& c) { return c["x"] && c["y"] && c["z"]; }

}  // namespace

Tracks tracksOf(const ExportedRun& run, bool quiet) {
  const auto& lineage = run.results.lineage;  // by path
  const double length = shownUnit(run.units, "length").factor, time = shownUnit(run.units, "time").factor,
               volume = shownUnit(run.units, "length³").factor;
  Tracks made;
  made.units = run.units;
  std::vector<int> trackOf(lineage.size(), -1);
  for (const Sample& sample : run.results.samples)
    for (const CellMeasures& c : sample.cells)
      if (const int cell = run.cellNumber(c.path); cell >= 0 && hasPlace(c))
        trackOf[static_cast<std::size_t>(cell)] = 0;
  std::vector<const LineageEntry*> unseen;
  for (std::size_t i = 0; i < lineage.size(); ++i) {
    if (trackOf[i] < 0) {
      unseen.push_back(&lineage[i]);
      continue;
    }
    trackOf[i] = static_cast<int>(made.tracks.size());
    const std::string name = run.nameOf(lineage[i]);
    CellTrack& track = made.tracks.emplace_back(CellTrack{&lineage[i], name.starts_with('/') ? "" : name});
    for (CellPath path = lineage[i].path; !path.isEgg() && track.parent < 0;) {
      path = path.mother();  // mothers stand before their daughters
      if (const int mother = run.cellNumber(path); mother >= 0)
        track.parent = trackOf[static_cast<std::size_t>(mother)];
    }
  }
  for (const Sample& sample : run.results.samples)
    for (const CellMeasures& c : sample.cells) {
      const int cell = run.cellNumber(c.path);
      if (cell < 0 || !hasPlace(c)) continue;
      const auto track = static_cast<std::size_t>(trackOf[static_cast<std::size_t>(cell)]);
      made.tracks[track].spots.push_back(static_cast<int>(made.spots.size()));
      std::optional<double> size = c["volume"];
      if (size) *size *= volume;
      made.spots.push_back({track, sample.world.time * time, Point{*c["x"], *c["y"], *c["z"]} * length, size});
    }
  if (made.spots.empty())
    throw UsageError(fmt::format("--format: run {} of {} has no {}; needs csv, newick or npz", run.run.id,
                                 run.run.record.scenario,
                                 run.hasBodies ? "samples (record.every takes them), and so no places of cells"
                                               : "bodies, and so no places of cells"));
  tellUnseen(run, unseen, quiet);
  return made;
}

std::span<const SpotField> spotFields() { return fields; }

CsvTable trackTable(const Tracks& tracks) {
  std::vector<CsvColumn> header;
  for (const SpotField& field : fields)
    header.push_back({field.name, field.meaning, shownUnit(tracks.units, field.unit).name});
  CsvTable csv(std::move(header));
  for (const TrackedSpot& spot : tracks.spots) {
    TableRow row;
    for (const SpotField& field : fields) row.push_back(field.of(tracks, spot));
    csv.add(row);
  }
  return csv;
}

}  // namespace morula
