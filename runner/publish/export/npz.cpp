#include "export/npz.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include "export/npy.h"
#include "simulation/measures.h"

namespace morula {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
using Starts = std::vector<std::int64_t>;

void addCells(NpzWriter& out, const ExportedRun& run) {
  std::vector<std::string> paths, names, fates;
  std::vector<double> born, ended;
  std::vector<std::int32_t> states;
  for (const LineageEntry& cell : run.results.lineage) {
    paths.push_back(cell.path.text()), names.push_back(run.nameOf(cell)), fates.push_back(name(cell.fate));
    born.push_back(cell.born), ended.push_back(cell.fate == Fate::alive ? none : cell.ended);
    states.push_back(run.stateNumber(cell.state));
  }
  out.add("paths", paths);
  out.add("names", names);
  out.add("born", born, {born.size()});
  out.add("ended", ended, {ended.size()});
  out.add("fates", fates);
  out.add("last_states", states, {states.size()});
  out.add("states", run.states);
}

std::string plural(std::string_view measure) {
  if (measure.ends_with("y")) return std::string(measure.substr(0, measure.size() - 1)) + "ies";
  return std::string(measure) + (measure.ends_with("s") ? "" : "s");
}

void addSamples(NpzWriter& out, const ExportedRun& run) {
  std::vector<double> times, centroids;
  std::vector<std::int32_t> cells, states;
  Starts start{0};
  const auto measures = sampledMeasures<CellContext>();
  std::vector<std::vector<double>> values(measures.size());
  for (const Sample& sample : run.results.samples) {
    times.push_back(sample.world.time);
    for (const CellMeasures& c : sample.cells) {
      cells.push_back(run.cellNumber(c.path)), states.push_back(run.stateNumber(c.state));
      for (const char* axis : {"x", "y", "z"}) centroids.push_back(c[axis].value_or(none));
      for (std::size_t k = 0; k < measures.size(); ++k) values[k].push_back(c.values[k].value_or(none));
    }
    start.push_back(static_cast<std::int64_t>(cells.size()));
  }
  out.add("times", times, {times.size()});
  out.add("cell_start", start, {start.size()});
  out.add("cell", cells, {cells.size()});
  out.add("state", states, {states.size()});
  out.add("centroids", centroids, {cells.size(), 3});
  for (std::size_t k = 0; k < measures.size(); ++k)
    if (const std::string_view name = measures[k].name; name.size() > 1)  // x, y and z stand there
      out.add(plural(name), values[k], {cells.size()});
}

void addContacts(NpzWriter& out, const ExportedRun& run) {
  std::vector<std::int32_t> pairs;
  std::vector<double> areas;
  Starts start{0};
  for (const Sample& sample : run.results.samples) {
    for (const ContactMeasures& c : sample.contacts) {
      pairs.push_back(run.cellNumber(c.a)), pairs.push_back(run.cellNumber(c.b));
      areas.push_back(c["area"].value_or(none));
    }
    start.push_back(static_cast<std::int64_t>(areas.size()));
  }
  out.add("contact_start", start, {start.size()});
  out.add("contacts", pairs, {areas.size(), 2});
  out.add("contact_areas", areas, {areas.size()});
}

void addSurfaces(NpzWriter& out, const ExportedRun& run) {
  std::vector<std::int32_t> cells, meshes;
  std::vector<double> bounds, vertices;
  Starts start{0}, vertexStart{0};
  for (const Sample& sample : run.results.samples) {
    for (const CellSurface& s : sample.surfaces) {
      cells.push_back(run.cellNumber(s.path)), meshes.push_back(s.mesh);
      bounds.push_back(std::max({s.step.x, s.step.y, s.step.z}) / 2);
      for (const Point& x : vertexPositions(s)) vertices.insert(vertices.end(), {x.x, x.y, x.z});
      vertexStart.push_back(static_cast<std::int64_t>(vertices.size() / 3));
    }
    start.push_back(static_cast<std::int64_t>(cells.size()));
  }
  out.add("surface_start", start, {start.size()});
  out.add("surface_cell", cells, {cells.size()});
  out.add("surface_mesh", meshes, {meshes.size()});
  out.add("surface_bound", bounds, {bounds.size()});
  out.add("vertex_start", vertexStart, {vertexStart.size()});
  out.add("vertices", vertices, {vertices.size() / 3, 3});
  for (const MeshFaces& mesh : run.results.meshes) {
    std::vector<std::int32_t> corners;
    for (const Face& face : mesh.faces) corners.insert(corners.end(), face.begin(), face.end());
    out.add("faces_" + std::to_string(mesh.mesh), corners, {mesh.faces.size(), 3});
  }
}

}  // namespace

std::string npzFile(const ExportedRun& run) {
  NpzWriter out;
  out.add("run_id", {run.run.id});
  out.add("scenario", {run.run.record.scenario});
  out.add("seed", {std::to_string(run.run.record.seed)});
  addCells(out, run);
  addSamples(out, run);
  addContacts(out, run);
  if (!run.results.meshes.empty()) addSurfaces(out, run);
  return out.file();
}

}  // namespace morula
