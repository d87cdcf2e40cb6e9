#include "export/gltf.h"

#include <algorithm>
#include <array>
#include <map>

#include "base/error.h"
#include "base/number_text.h"
#include "files/bytes.h"
#include "system/json.h"

namespace morula {
namespace {

// glTF's numbers of component types and targets
constexpr int asFloat = 5126, asUint16 = 5123, asUint32 = 5125, ofVertices = 34962, ofCorners = 34963;

/// Returns for each vertex the unit normal of its faces, weighted by their areas.
std::vector<Vector> smoothNormals(const std::vector<Point>& vertices, const std::vector<Face>& faces) {
  std::vector<Vector> normals(vertices.size());
  const auto at = [&](std::int32_t i) { return vertices[static_cast<std::size_t>(i)]; };
  for (const Face& f : faces) {
    const Vector area = cross(at(f[1]) - at(f[0]), at(f[2]) - at(f[0]));
    for (const std::int32_t corner : f) normals[static_cast<std::size_t>(corner)] += area;
  }
  for (Vector& n : normals) {
    const double length = norm(n);
    n = length > 0 ? n / length : Vector{0, 0, 1};
  }
  return normals;
}

class GltfWriter {
 public:
  GltfWriter(const ExportedRun& run, const Sample& sample) : run_(run), sample_(sample) {
    document_["asset"] = {{"version", "2.0"}, {"generator", "Morula " + run.run.record.build.version}};
    document_["scene"] = 0;
    for (const CellSurface& s : sample.surfaces) addCell(s);
    const std::size_t root = addRoot(sample.surfaces.size());
    document_["scenes"].push_back({{"name", run.run.record.scenario + ", time " + exactText(sample.world.time)},
                                   {"nodes", {root}},
                                   {"extras", {{"run_id", run.run.id}, {"time", sample.world.time}}}});
    if (!bytes_.empty()) document_["buffers"].push_back({{"byteLength", bytes_.size()}});  // glTF has no empty buffers
  }

  std::string file() const {
    std::string json = jsonText(document_);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::size_t binary = bytes_.empty() ? 0 : 8 + bytes_.size();  // size of the second chunk with its header
    std::string file;
    put32(file, std::uint32_t{0x46546C67});  // "glTF"
    put32(file, std::uint32_t{2});
    put32(file, static_cast<std::uint32_t>(20 + json.size() + binary));
    put32(file, static_cast<std::uint32_t>(json.size()));
    put32(file, std::uint32_t{0x4E4F534A});  // "JSON"
    file += json;
    if (binary == 0) return file;
    put32(file, static_cast<std::uint32_t>(bytes_.size()));
    put32(file, std::uint32_t{0x004E4942});  // "BIN"
    return file + bytes_;
  }

 private:
  /// Adds bytes as an accessor and returns its number.
  std::size_t add(const std::string& bytes, int target, Json accessor) {
    document_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}, {"target", target}});
    bytes_ += bytes;
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    // Lengths have 32 bits; the file's part before the bytes is far smaller than the rest of the range.
    if (bytes_.size() > 4'000'000'000)
      throw FileError("glTF: more than 4 GB of surfaces, which one .glb cannot hold; use --format vtk or ply");
    accessor["bufferView"] = document_["bufferViews"].size() - 1;
    document_["accessors"].push_back(std::move(accessor));
    return document_["accessors"].size() - 1;
  }

  std::size_t addVectors(const std::vector<Vector>& vectors, bool withBox) {
    std::string bytes;
    std::array<float, 3> low{}, high{};
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      const std::array<float, 3> v{static_cast<float>(vectors[i].x), static_cast<float>(vectors[i].y),
                                   static_cast<float>(vectors[i].z)};
      if (i == 0) low = high = v;
      for (std::size_t k = 0; k < 3; ++k) {
        putFloat(bytes, v[k]);
        low[k] = std::min(low[k], v[k]), high[k] = std::max(high[k], v[k]);
      }
    }
    Json accessor{{"componentType", asFloat}, {"count", vectors.size()}, {"type", "VEC3"}};
    if (withBox) accessor["min"] = low, accessor["max"] = high;
    return add(bytes, ofVertices, std::move(accessor));
  }

  std::size_t cornersOf(const MeshFaces& mesh) {
    if (const auto found = corners_.find(mesh.mesh); found != corners_.end()) return found->second;
    const bool isShort = mesh.vertices <= 65535;  // 65535 itself is no index, since it may end a strip
    std::string bytes;
    for (const Face& face : mesh.faces)
      for (const std::int32_t corner : face) {
        if (isShort) put16(bytes, static_cast<std::uint16_t>(corner));
        else put32(bytes, corner);
      }
    return corners_[mesh.mesh] = add(bytes, ofCorners,
                                     {{"componentType", isShort ? asUint16 : asUint32},
                                      {"count", 3 * mesh.faces.size()},
                                      {"type", "SCALAR"}});
  }

  std::size_t materialOf(const CellPath& cell, StateId state) {
    const std::string own = run_.own.contains(cell) ? "cell " + cell.text() : "";
    const std::string& text = own.empty() ? run_.results.stateTexts.at(state) : own;
    if (const auto found = materials_.find(text); found != materials_.end()) return found->second;
    const Colour c = run_.colourOf(cell, state);  // glTF's factors are linear light
    document_["materials"].push_back({{"name", text},
                                      {"pbrMetallicRoughness",
                                       {{"baseColorFactor", {linearLight(c.r), linearLight(c.g), linearLight(c.b), 1}},
                                        {"metallicFactor", 0},
                                        {"roughnessFactor", 0.6}}}});
    return materials_[text] = document_["materials"].size() - 1;
  }

  void addCell(const CellSurface& s) {
    const MeshFaces& mesh = run_.meshOf(s);
    const std::vector<Point> vertices = vertexPositions(s);
    const CellMeasures* measures = ExportedRun::measuresOf(sample_, s.path);
    const int number = run_.cellNumber(s.path);
    MORULA_CHECK(measures && number >= 0, "each surface is a cell's");
    const std::string name = run_.nameOf(run_.results.lineage[static_cast<std::size_t>(number)]);
    const std::size_t positions = addVectors(vertices, true);
    const std::size_t normals = addVectors(smoothNormals(vertices, mesh.faces), false);
    Json primitives = Json::array();
    primitives.push_back({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                          {"indices", cornersOf(mesh)},
                          {"material", materialOf(s.path, measures->state)}});
    document_["meshes"].push_back({{"name", name}, {"primitives", primitives}});
    document_["nodes"].push_back({{"name", name},
                                  {"mesh", document_["meshes"].size() - 1},
                                  {"extras",
                                   {{"path", s.path.text()},
                                    {"state", run_.results.stateTexts.at(measures->state)},
                                    {"volume", orNull((*measures)["volume"])}}}});
  }

  /// Adds the parent of the first `cells` nodes and returns its number. The y axis points upwards in glTF, the z axis
  /// in Morula: the parent's matrix, column by column, takes (x, y, z) to (x, z, -y) exactly.
  std::size_t addRoot(std::size_t cells) {
    Json root{{"name", run_.run.record.scenario}, {"matrix", {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1}}};
    for (std::size_t i = 0; i < cells; ++i) root["children"].push_back(i);
    document_["nodes"].push_back(std::move(root));
    return cells;
  }

  const ExportedRun& run_;
  const Sample& sample_;
  Json document_;
  std::string bytes_;
  std::map<int, std::size_t> corners_;            // accessor of each mesh
  std::map<std::string, std::size_t> materials_;  // material of each text of substances, or of a cell
};

}  // namespace

std::string glbFile(const ExportedRun& run, const Sample& sample) { return GltfWriter(run, sample).file(); }

}  // namespace morula
