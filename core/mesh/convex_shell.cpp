#include "mesh/convex_shell.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "mesh/obj_source.h"

namespace morula {
namespace {

constexpr double planeWithin = 1e-9;  // of the size: corners of one polygon as decimal numbers put them
constexpr double leastOffset = 1e-3;  // of the size: nearer, rounding of a vertex far off would reach the origin
constexpr double smallestSize = 1e-6, largestSize = 1e6;  // [length] sizes

class Planes {
 public:
  Planes(const Mesh& mesh, const MeshSource& source) : mesh_(mesh), source_(source) {
    for (const Point& x : mesh.vertices) size_ = std::max(size_, norm(x));
    if (!(size_ >= smallestSize && size_ <= largestSize))
      throw InputError(source.name + ": its farthest vertex lies " +
                       (size_ > largestSize ? "more than 1e6" : "less than 1e-6") +
                       " from the origin; write a shell of a size in between");
  }

  std::vector<ShellPlane> find() {
    std::vector<ShellPlane> planes;
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      const ShellPlane plane = planeOf(mesh_.faces[f]);
      checkOrigin(f, plane);
      checkConvex(f, plane);
      if (std::ranges::none_of(planes, [&](const ShellPlane& other) { return areOne(plane, other); }))
        planes.push_back(plane);
    }
    return planes;
  }

 private:
  ShellPlane planeOf(const Face& face) const {
    const Point& corner = mesh_.vertices[face[0]];
    const Vector across = cross(mesh_.vertices[face[1]] - corner, mesh_.vertices[face[2]] - corner);
    const Vector normal = across / norm(across);
    return {normal, dot(normal, corner)};
  }

  bool areOne(const ShellPlane& a, const ShellPlane& b) const {
    return norm(a.normal - b.normal) <= planeWithin && std::abs(a.offset - b.offset) <= planeWithin * size_;
  }

  [[noreturn]] void fail(std::size_t face, const std::string& text) const {
    throw InputError(source_.name + ":" + std::to_string(source_.faceLines[face]) + ":1: face " +
                     std::to_string(source_.faceNumbers[face]) + ": " + text);
  }

  void checkOrigin(std::size_t f, const ShellPlane& plane) const {
    if (plane.offset >= leastOffset * size_) return;
    fail(f, plane.offset <= 0 ? "the origin is not inside of this face; a shell lies around the origin, so move it"
                              : "the origin lies almost in this face; a shell has it well inside, so move it");
  }

  void checkConvex(std::size_t f, const ShellPlane& plane) const {
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v)
      if (dot(plane.normal, mesh_.vertices[v]) > plane.offset + planeWithin * size_)
        fail(f, "vertex " + std::to_string(v + 1) +
                    " lies outside of its plane; a shell is convex, so move one of them, or split a polygon "
                    "that is not flat the other way");
  }

  const Mesh& mesh_;
  const MeshSource& source_;
  double size_ = 0;
};

}  // namespace

ConvexShell readConvexShell(const std::string& text, const std::string& name) {
  MeshSource source;
  ConvexShell shell;
  shell.mesh = readObjAsGiven(text, name, source);
  shell.planes = Planes(shell.mesh, source).find();
  return shell;
}

ConvexShell scaleConvexShell(ConvexShell shell, double factor) {
  for (Point& x : shell.mesh.vertices) x *= factor;
  for (ShellPlane& plane : shell.planes) plane.offset *= factor;
  return shell;
}

double measureReach(const std::vector<ShellPlane>& planes, const Point& x) {
  double reach = 0;
  for (const ShellPlane& plane : planes) reach = std::max(reach, dot(plane.normal, x) / plane.offset);
  return reach;
}

const ShellPlane& nearestPlane(const std::vector<ShellPlane>& planes, const Point& x) {
  MORULA_CHECK(!planes.empty(), "a shell has planes");
  return *std::ranges::min_element(planes, {},
                                   [&](const ShellPlane& plane) { return plane.offset - dot(plane.normal, x); });
}

}  // namespace morula
