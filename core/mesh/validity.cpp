#include "mesh/validity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "base/error.h"
#include "mesh/mesh_measures.h"

namespace morula {
namespace {

// One side of an edge: a face that runs from a to b.
struct Side {
  int a, b, face;
  int low() const { return std::min(a, b); }
  int high() const { return std::max(a, b); }
};

// Runs the checks in an order in which each may rely on earlier ones.
class Checker {
 public:
  Checker(const Mesh& mesh, const MeshSource& source) : mesh_(mesh), source_(source) {}

  void checkAll() {
    checkSize();
    checkIndices();
    checkUse();
    checkFaceAreas();
    checkEdges();
    checkFans();
    checkConnected();
    checkVolume();
  }

 private:
  [[noreturn]] void fail(int line, const std::string& text) const {
    throw InputError(source_.name + ":" + (line > 0 ? std::to_string(line) + ":1:" : "") + " " + text);
  }
  int vertexLine(int i) const { return source_.vertexLines.empty() ? 0 : source_.vertexLines[i]; }
  int faceLine(int f) const { return source_.faceLines.empty() ? 0 : source_.faceLines[f]; }
  static std::string vertexName(int i) { return "vertex " + std::to_string(i + 1); }
  std::string faceName(int f) const {
    return "face " + std::to_string(source_.faceNumbers.empty() ? f + 1 : source_.faceNumbers[f]);
  }
  static std::string edgeName(const Side& s) {
    return "the edge between vertices " + std::to_string(s.low() + 1) + " and " + std::to_string(s.high() + 1);
  }
  int faceCount() const { return static_cast<int>(mesh_.faces.size()); }
  int vertexCount() const { return static_cast<int>(mesh_.vertices.size()); }

  void checkSize() const {
    if (vertexCount() < 4 || faceCount() < 4)
      fail(0, "a mesh of " + std::to_string(vertexCount()) + " vertices and " + std::to_string(faceCount()) +
                  " triangles encloses nothing; the smallest closed mesh, a tetrahedron, has 4 of each");
  }

  void checkIndices() const {
    for (int i = 0; i < vertexCount(); ++i) {
      const Point& v = mesh_.vertices[i];
      if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
        fail(vertexLine(i), vertexName(i) + ": a coordinate that is not a number; write three finite numbers");
    }
    for (int f = 0; f < faceCount(); ++f) {
      const Face& face = mesh_.faces[f];
      for (int i : face)
        if (i < 0 || i >= vertexCount())
          fail(faceLine(f), faceName(f) + ": there is no vertex " + std::to_string(std::int64_t{i} + 1) +
                                "; the mesh has vertices 1 to " + std::to_string(vertexCount()));
      for (int k = 0; k < 3; ++k)
        if (face[k] == face[(k + 1) % 3])
          fail(faceLine(f), faceName(f) + ": " + vertexName(face[k]) +
                                " occurs twice; the corners of a face are different vertices");
    }
  }

  void checkUse() const {
    std::vector<char> used(mesh_.vertices.size(), 0);
    for (const Face& face : mesh_.faces)
      for (int i : face) used[i] = 1;
    std::vector<int> loose;
    for (int i = 0; i < vertexCount(); ++i)
      if (!used[i]) loose.push_back(i);
    if (loose.empty()) return;
    if (loose.size() == 1)
      fail(vertexLine(loose[0]),
           vertexName(loose[0]) + ": no face has this vertex; remove it, for each vertex carries a part of the mass");
    constexpr std::size_t most = 8;
    std::string names;
    for (std::size_t i = 0; i < std::min(most, loose.size()); ++i)
      names += (i ? ", " : "") + std::to_string(loose[i] + 1);
    if (loose.size() > most) names += " and " + std::to_string(loose.size() - most) + " more";
    fail(vertexLine(loose[0]),
         "no face has the vertices " + names + "; remove them, for each vertex carries a part of the mass");
  }

  void checkFaceAreas() const {
    for (int f = 0; f < faceCount(); ++f) {
      const auto& [a, b, c] = mesh_.faces[f];
      const Point &p = mesh_.vertices[a], &q = mesh_.vertices[b], &r = mesh_.vertices[c];
      const double longest = std::max({dot(q - p, q - p), dot(r - q, r - q), dot(p - r, p - r)});
      if (!(norm(cross(q - p, r - p)) > flat * longest))
        fail(faceLine(f), faceName(f) + ": its corners " + std::to_string(a + 1) + ", " + std::to_string(b + 1) +
                              " and " + std::to_string(c + 1) +
                              " lie on one line, so that it has no area and no normal; move or merge vertices");
    }
  }

  void checkEdges() {
    std::vector<Side> sides;
    for (int f = 0; f < faceCount(); ++f)
      for (int k = 0; k < 3; ++k) sides.push_back({mesh_.faces[f][k], mesh_.faces[f][(k + 1) % 3], f});
    std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
      return std::array{s.low(), s.high(), s.face} < std::array{t.low(), t.high(), t.face};
    });
    for (std::size_t i = 0, end; i < sides.size(); i = end) {
      for (end = i; end < sides.size() && sides[end].low() == sides[i].low() && sides[end].high() == sides[i].high();)
        ++end;
      checkEdge({&sides[i], end - i});
    }
  }

  void checkEdge(std::span<const Side> sides) const {
    const Side& first = sides[0];
    if (sides.size() == 1)
      fail(faceLine(first.face), edgeName(first) + " belongs to " + faceName(first.face) +
                                     " only; a closed mesh has two faces at each edge: fill the hole, or merge "
                                     "vertices that lie at the same place");
    if (sides.size() > 2) {
      std::string names = faceName(first.face);
      for (const Side& s : sides.subspan(1)) names += ", " + faceName(s.face);
      fail(faceLine(sides[2].face),
           edgeName(first) + " belongs to " + std::to_string(sides.size()) + " faces (" + names +
               "); a closed mesh has two faces at each edge: remove inner walls and double faces");
    }
    if (first.a == sides[1].a)
      fail(faceLine(sides[1].face), edgeName(first) + ": " + faceName(first.face) + " and " + faceName(sides[1].face) +
                                        " turn opposite ways; list the corners of all " +
                                        "faces counter-clockwise as seen from outside");
  }

  // Two cones that touch at their tips share a vertex but no edge: its faces form two fans.
  void checkFans() const {
    std::vector<std::vector<std::array<int, 3>>> corners(mesh_.vertices.size());  // {from, to, face}
    for (int f = 0; f < faceCount(); ++f)
      for (int k = 0; k < 3; ++k) {
        const Face& face = mesh_.faces[f];
        corners[face[k]].push_back({face[(k + 1) % 3], face[(k + 2) % 3], f});
      }
    for (int i = 0; i < vertexCount(); ++i) {
      std::sort(corners[i].begin(), corners[i].end());
      std::size_t walked = 0, at = 0;
      std::vector<char> seen(corners[i].size(), 0);
      for (; !seen[at]; ++walked) {
        seen[at] = 1;
        const std::array<int, 3> key = {corners[i][at][1], std::numeric_limits<int>::min(), 0};
        at = std::lower_bound(corners[i].begin(), corners[i].end(), key) - corners[i].begin();
      }
      if (walked == corners[i].size()) continue;
      const std::size_t other = std::find(seen.begin(), seen.end(), 0) - seen.begin();
      fail(vertexLine(i), vertexName(i) + ": " + faceName(corners[i][0][2]) + " and " + faceName(corners[i][other][2]) +
                              " meet at this vertex alone; split it in two vertices or join the parts by faces");
    }
  }

  void checkConnected() const {
    std::vector<int> part(mesh_.vertices.size());
    for (int i = 0; i < vertexCount(); ++i) part[i] = i;
    const auto root = [&part](int i) {
      while (part[i] != i) i = part[i] = part[part[i]];
      return i;
    };
    for (const Face& face : mesh_.faces)
      for (int k = 1; k < 3; ++k) {
        const int a = root(face[0]), b = root(face[k]);
        part[std::max(a, b)] = std::min(a, b);
      }
    for (int f = 0; f < faceCount(); ++f)
      if (root(mesh_.faces[f][0]) != 0 && root(mesh_.faces[f][0]) != root(mesh_.faces[0][0]))
        fail(faceLine(f), faceName(f) + " is not connected to " + faceName(0) +
                              "; a cell is one piece: keep one closed surface per file");
  }

  void checkVolume() const {
    const double volume = measureVolume(mesh_.vertices, mesh_.faces);
    const Box box = measureBox(mesh_.vertices);
    const Vector size = box.high - box.low;
    const double extent = std::max({size.x, size.y, size.z});
    if (volume < -flat * extent * extent * extent)
      fail(faceLine(0),
           "all faces are inverted: the volume is negative; flip the orientation (list the corners of "
           "each face the other way round, counter-clockwise as seen from outside)");
    if (!(volume > flat * extent * extent * extent))
      fail(faceLine(0), "the mesh is flat: it encloses no volume; a cell needs an inside");
  }

  // A height below this share of the length beside it counts as none. The share lies far above rounding and far below
  // any mesh that springs could hold apart.
  static constexpr double flat = 1e-10;

  const Mesh& mesh_;
  const MeshSource& source_;
};

}  // namespace

void checkClosedManifold(const Mesh& mesh, const MeshSource& source) { Checker(mesh, source).checkAll(); }

void checkClosedManifold(const Mesh& mesh, const std::string& name) {
  checkClosedManifold(mesh, MeshSource{name, {}, {}, {}});
}

}  // namespace morula
