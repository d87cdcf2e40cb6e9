#include "export/npz.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/utf8.h"
#include "export/zip.h"
#include "files/bytes.h"
#include "observation/measures.h"

namespace morula {
namespace {

class NpzWriter {
 public:
  /// Adds an array of doubles, or of 64- or 32-bit integers; the last axis is filled first, the only one without
  /// `shape`.
  template <class Number>
  void add(const std::string& name, const std::vector<Number>& values, std::vector<std::size_t> shape = {});
  /// Adds an array of texts with one axis, in UTF-32 (<U…).
  void add(const std::string& name, const std::vector<std::string>& texts);

  /// Returns the file's bytes. Throws FileError for more than 4 GB, the limit of such a zip.
  std::string file() const { return zipOf(files_, "give --time, or use --format vtk"); }

 private:
  void addArray(const std::string& name, const std::string& type, const std::vector<std::size_t>& shape,
                const std::string& bytes);
  std::vector<std::pair<std::string, std::string>> files_;  // name, bytes
};

constexpr std::uint32_t replacement = 0xfffd;  // in place of invalid characters

std::vector<std::uint32_t> codePoints(std::string_view text) {
  std::vector<std::uint32_t> points;
  while (!text.empty()) {
    const int length = utf8Length(text);
    points.push_back(length > 0 ? static_cast<std::uint32_t>(utf8Value(text, length)) : replacement);
    text.remove_prefix(length > 0 ? static_cast<std::size_t>(length) : 1);
  }
  return points;
}

std::string shapeText(const std::vector<std::size_t>& shape) {
  std::string text = "(";
  for (const std::size_t n : shape) text += std::to_string(n) + ", ";
  if (shape.size() > 1) text.resize(text.size() - 2);
  else text.resize(text.size() - 1);  // a shape of one axis ends in a comma: (3,)
  return text + ")";
}

template <class Number>
void NpzWriter::add(const std::string& name, const std::vector<Number>& values, std::vector<std::size_t> shape) {
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  if (shape.empty()) shape = {values.size()};
  MORULA_CHECK(values.size() == std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies()), name);
  std::string bytes;
  for (const Number v : values) putNumber(bytes, std::bit_cast<Bits>(v));
  addArray(name, std::is_floating_point_v<Number> ? "<f8" : sizeof(Number) == 8 ? "<i8" : "<i4", shape, bytes);
}

void NpzWriter::add(const std::string& name, const std::vector<std::string>& texts) {
  std::vector<std::vector<std::uint32_t>> all;
  std::size_t longest = 1;  // NumPy makes <U1 of empty texts, too
  for (const std::string& text : texts) longest = std::max(longest, all.emplace_back(codePoints(text)).size());
  std::string bytes;
  for (auto& points : all) {
    points.resize(longest, 0);
    for (const std::uint32_t p : points) put32(bytes, p);
  }
  addArray(name, "<U" + std::to_string(longest), {texts.size()}, bytes);
}

void NpzWriter::addArray(const std::string& name, const std::string& type, const std::vector<std::size_t>& shape,
                         const std::string& bytes) {
  // NumPy's format, version 1.0: the values begin at a multiple of 64 bytes.
  std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shapeText(shape) + ", }";
  header.resize((10 + header.size() + 1 + 63) / 64 * 64 - 11, ' ');
  header += '\n';
  std::string file = "\x93NUMPY";
  put8(file, 1), put8(file, 0);
  put16(file, static_cast<std::uint16_t>(header.size()));
  files_.emplace_back(name + ".npy", file + header + bytes);
}

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
  out.add("born", born);
  out.add("ended", ended);
  out.add("fates", fates);
  out.add("last_states", states);
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
  out.add("times", times);
  out.add("cell_start", start);
  out.add("cell", cells);
  out.add("state", states);
  out.add("centroids", centroids, {cells.size(), 3});
  for (std::size_t k = 0; k < measures.size(); ++k)
    if (const std::string_view name = measures[k].name; name.size() > 1)  // x, y and z are in `centroids`
      out.add(plural(name), values[k]);
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
  out.add("contact_start", start);
  out.add("contacts", pairs, {areas.size(), 2});
  out.add("contact_areas", areas);
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
  out.add("surface_start", start);
  out.add("surface_cell", cells);
  out.add("surface_mesh", meshes);
  out.add("surface_bound", bounds);
  out.add("vertex_start", vertexStart);
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
