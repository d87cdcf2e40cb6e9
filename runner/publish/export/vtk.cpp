#include "export/vtk.h"

#include <fmt/format.h>

#include <limits>

#include "base/error.h"
#include "base/number_text.h"
#include "files/bytes.h"
#include "observation/measures.h"

namespace morula {
namespace {

/// The bytes behind the markup: pieces with their lengths in front, addressed by their offsets.
class Appended {
 public:
  /// Appends an array's bytes and returns the attributes that refer to them.
  std::string add(const std::string& bytes) {
    const std::size_t offset = bytes_.size();
    put64(bytes_, bytes.size());
    bytes_ += bytes;
    return fmt::format("format=\"appended\" offset=\"{}\"", offset);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Returns texts in VTK's form: the codes of their bytes, each text closed by a 0.
std::string textArray(const std::string& name, const std::vector<std::string>& texts) {
  std::string codes;
  for (const std::string& text : texts) {
    for (const char c : text) codes += std::to_string(static_cast<std::uint8_t>(c)) + ' ';
    codes += "0 ";
  }
  return fmt::format("      <Array type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"ascii\">{}</Array>\n",
                     name, texts.size(), codes);
}

std::string array(const char* type, const std::string& name, int components, const std::string& place) {
  return fmt::format("        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" {}/>\n", type, name,
                     components, place);
}

/// Returns for each triangle the value of its cell.
template <class Put>
std::string perTriangle(const ExportedRun& run, const Sample& sample, Put put) {
  std::string bytes;
  for (const CellSurface& s : sample.surfaces)
    for (std::size_t i = 0; i < run.meshOf(s).faces.size(); ++i) put(bytes, s);
  return bytes;
}

std::string cellData(const ExportedRun& run, const Sample& sample, Appended& data) {
  const auto stateOf = [&](const CellSurface& s) {
    const CellMeasures* m = ExportedRun::measuresOf(sample, s.path);
    MORULA_CHECK(m, "a sample measures each of its cells");
    return m->state;
  };
  const auto each = [&](auto put) { return data.add(perTriangle(run, sample, put)); };
  std::string text;
  text += array("Int32", "cell", 1,
                each([&](std::string& b, const CellSurface& s) { put32(b, std::int32_t{run.cellNumber(s.path)}); }));
  text +=
      array("Int32", "state", 1,
            each([&](std::string& b, const CellSurface& s) { put32(b, std::int32_t{run.stateNumber(stateOf(s))}); }));
  text += array("UInt8", "colour", 3, each([&](std::string& b, const CellSurface& s) {
                  const Colour c = run.colourOf(s.path, stateOf(s));
                  put8(b, c.r), put8(b, c.g), put8(b, c.b);
                }));
  for (const auto& measure : sampledMeasures<CellContext>())
    text += array("Float64", measure.name, 1, each([&](std::string& b, const CellSurface& s) {
                    const auto value = (*ExportedRun::measuresOf(sample, s.path))[measure.name];
                    putDouble(b, value.value_or(std::numeric_limits<double>::quiet_NaN()));
                  }));
  return text;
}

}  // namespace

std::string vtpFile(const ExportedRun& run, const Sample& sample) {
  std::string points, corners, ends;
  std::int64_t vertices = 0, triangles = 0;
  for (const CellSurface& s : sample.surfaces) {
    for (const Point& x : vertexPositions(s)) putDouble(points, x.x), putDouble(points, x.y), putDouble(points, x.z);
    for (const Face& face : run.meshOf(s).faces) {
      for (const std::int32_t corner : face) put64(corners, static_cast<std::uint64_t>(vertices + corner));
      put64(ends, static_cast<std::uint64_t>(3 * ++triangles));
    }
    vertices += static_cast<std::int64_t>(s.numbers.size());
  }
  std::vector<std::string> paths;
  for (const LineageEntry& cell : run.results.lineage) paths.push_back(cell.path.text());

  Appended data;
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "  <PolyData>\n    <FieldData>\n";
  text += fmt::format(
      "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n",
      exactText(sample.world.time));
  text += textArray("run_id", {run.run.id}) + textArray("states", run.states) + textArray("paths", paths);
  text += fmt::format(
      "    </FieldData>\n    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n      <CellData>\n",
      vertices, triangles);
  text += cellData(run, sample, data);
  text += "      </CellData>\n      <Points>\n" + array("Float64", "Points", 3, data.add(points));
  text += "      </Points>\n      <Polys>\n" + array("Int64", "connectivity", 1, data.add(corners)) +
          array("Int64", "offsets", 1, data.add(ends));
  text += "      </Polys>\n    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n_";
  return text + data.bytes() + "\n  </AppendedData>\n</VTKFile>\n";
}

std::string pvdFile(const ExportedRun& run, const std::vector<std::string>& names) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n  <Collection>\n";
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n",
                        exactText(run.results.samples[i].world.time), names[i]);
  return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace morula
