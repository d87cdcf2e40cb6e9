#include "export/geff.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace morula {
namespace {

using Number = std::uint64_t;

/// Returns the name of a unit in OME-Zarr, whose names GEFF recommends; other units keep theirs.
std::string omeUnit(const std::string& unit) {
  static constexpr std::pair<const char*, const char*> names[] = {
      {"µm", "micrometer"}, {"μm", "micrometer"}, {"um", "micrometer"}, {"nm", "nanometer"},
      {"mm", "millimeter"}, {"cm", "centimeter"}, {"m", "meter"},       {"ms", "millisecond"},
      {"s", "second"},      {"min", "minute"},    {"h", "hour"},        {"d", "day"}};
  for (const auto& [name, ome] : names)
    if (unit == name) return ome;
  return unit;
}

class GraphWriter {
 public:
  GraphWriter(const ExportedRun& run, const Tracks& tracks) : run_(run), tracks_(tracks) {}

  ZarrFolder write() {
    for (const char* group : {"nodes", "nodes/props", "edges"}) out_.group(group);
    addNodes();
    addEdges();
    out_.group("", {{"geff", about()}});
    return std::move(out_);
  }

 private:
  void addNodes() {
    std::vector<Number> ids;
    for (std::size_t i = 0; i < tracks_.spots.size(); ++i) ids.push_back(i);
    out_.array("nodes/ids", ids);
    for (const SpotField& field : spotFields()) addProperty(field);
    addProperty({"radius", "radius of the ball of the cell's volume", "length", [](auto&, auto& s) {
                   return s.volume ? TableValue(std::cbrt(*s.volume * 3 / (4 * std::numbers::pi))) : TableValue();
                 }});
    for (const char* axis : {"t", "z", "y", "x"}) addAxis(axis);
  }

  /// Adds the values of a property that are of one type, with a mark at each that is missing.
  template <class Value, class Stored>
  void addValues(const std::string& path, const std::vector<TableValue>& values) {
    std::vector<Stored> all;
    std::vector<std::uint8_t> missing;
    for (const TableValue& value : values) {
      const auto* found = std::get_if<Value>(&value);
      all.push_back(found ? static_cast<Stored>(*found) : Stored());
      missing.push_back(found == nullptr);
    }
    out_.array(path + "/values", all);
    if (std::ranges::count(missing, 1) > 0) out_.array(path + "/missing", missing);
  }

  void addProperty(const SpotField& field) {
    const std::string path = std::string("nodes/props/") + field.name;
    out_.group(path);
    std::vector<TableValue> values;
    for (const TrackedSpot& spot : tracks_.spots) values.push_back(field.of(tracks_, spot));
    const bool isText = std::holds_alternative<std::string>(values.front());
    const bool isWhole = std::holds_alternative<std::int64_t>(values.front());
    if (isText) addValues<std::string, std::string>(path, values);
    else if (isWhole) addValues<std::int64_t, Number>(path, values);
    else addValues<double, double>(path, values);
    Json& about = properties_[field.name] = {{"identifier", field.name},
                                             {"dtype", isText    ? "str"
                                                       : isWhole ? "uint64"
                                                                 : "float64"},
                                             {"varlength", false},
                                             {"description", field.meaning}};
    if (tracks_.units.any() && *field.unit) about["unit"] = omeUnit(shownUnit(tracks_.units, field.unit).name);
  }

  /// Adds an axis, whose values a property gives.
  void addAxis(const std::string& name) {
    const auto field = std::ranges::find(spotFields(), name, [](const SpotField& f) { return std::string(f.name); });
    double low = INFINITY, high = -INFINITY;
    for (const TrackedSpot& spot : tracks_.spots) {
      const double value = std::get<double>(field->of(tracks_, spot));
      low = std::min(low, value), high = std::max(high, value);
    }
    Json axis{{"name", name}, {"type", name == "t" ? "time" : "space"}, {"min", low}, {"max", high}};
    if (properties_[name].contains("unit")) axis["unit"] = properties_[name]["unit"];
    axes_.push_back(axis);
  }

  void addEdges() {
    std::vector<Number> ends;
    const auto add = [&](int from, int to) {
      ends.insert(ends.end(), {static_cast<Number>(from), static_cast<Number>(to)});
    };
    for (const CellTrack& track : tracks_.tracks) {
      if (track.parent >= 0)
        add(tracks_.tracks[static_cast<std::size_t>(track.parent)].spots.back(), track.spots.front());
      for (std::size_t i = 1; i < track.spots.size(); ++i) add(track.spots[i - 1], track.spots[i]);
    }
    const std::size_t edges = ends.size() / 2;
    out_.array("edges/ids", ends, {edges, 2});
  }

  /// Returns true if the spots of each cell are a tracklet: none has one daughter alone, whose spots would join them.
  bool areTracklets() const {
    std::vector<int> daughters(tracks_.tracks.size());
    for (const CellTrack& track : tracks_.tracks)
      if (track.parent >= 0) ++daughters[static_cast<std::size_t>(track.parent)];
    return std::ranges::count(daughters, 1) == 0;
  }

  Json about() const {
    Json graph{{"geff_version", "1.2"},
               {"directed", true},
               {"axes", axes_},
               {"node_props_metadata", properties_},
               {"edge_props_metadata", Json::object()},
               {"sphere", "radius"}};
    if (areTracklets()) graph["track_node_props"] = {{"tracklet", "track_id"}};
    graph["display_hints"] = {
        {"display_horizontal", "x"}, {"display_vertical", "y"}, {"display_depth", "z"}, {"display_time", "t"}};
    graph["extra"] = {{"morula",
                       {{"run_id", run_.run.id},
                        {"scenario", run_.run.record.scenario},
                        {"seed", run_.run.record.seed},
                        {"version", run_.run.record.build.version}}}};
    return graph;
  }

  const ExportedRun& run_;
  const Tracks& tracks_;
  ZarrFolder out_;
  Json properties_ = Json::object(), axes_ = Json::array();
};

}  // namespace

ZarrFolder geffGraph(const ExportedRun& run, const Tracks& tracks) { return GraphWriter(run, tracks).write(); }

}  // namespace morula
