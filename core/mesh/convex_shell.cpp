#include "mesh/convex_shell.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "mesh/obj_source.h"

namespace morula {
namespace {

constexpr double planeWithin = 1e-9;  // [size] min tolerance of a plane: a polygon's corners, as decimal numbers
constexpr double maxRounding = 1e-3;  // [size] max tolerance from a file's digits; more is a shape, not rounding
constexpr double minOffset = 1e-3;    // [size] if nearer, rounding of a distant vertex could reach the origin
constexpr double smallestSize = 1e-6, largestSize = 1e6;  // [length] sizes

class Planes {
 public:
  Planes(const Mesh& mesh, const MeshSource& source) : mesh_(mesh), source_(source) {
    for (const Point& x : mesh.vertices) size_ = std::max(size_, norm(x));
    if (!(size_ >= smallestSize && size_ <= largestSize))
      throw InputError(source.name + ": its farthest vertex lies " +
                       (size_ > largestSize ? "more than 1e6" : "less than 1e-6") +
                       " from the origin; needs a shell of a size in between");
  }

  std::vector<ShellPlane> find() {
    std::vector<ShellPlane> all, planes;
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      all.push_back(planeOf(mesh_.faces[f]));
      checkOrigin(f, all.back());
      moveOutwards(f, all.back());
    }
    for (std::size_t f = 0; f < all.size(); ++f) {
      double within = planeWithin * size_;
      if (isRounded_) within = std::max(within, std::min(toleranceAt(mesh_.faces[f], size_), maxRounding * size_));
      if (std::ranges::none_of(planes, [&](const ShellPlane& other) { return areOne(all[f], other, within); }))
        planes.push_back(all[f]);
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

  bool areOne(const ShellPlane& a, const ShellPlane& b, double within) const {
    return norm(a.normal - b.normal) * size_ <= within && std::abs(a.offset - b.offset) <= within;
  }

  /// Returns how far [length] the file's digits can put a vertex, at this distance from the face, outside of the face's
  /// plane. Each coordinate may be off by its rounding ε, so a point by √3 ε. A plane through three such points, whose
  /// smallest height is h, is off by √3 ε (1 + 2 r/h) at a distance r from them.
  double toleranceAt(const Face& face, double distance) const {
    double rounding = 0, longest = 0;
    for (int i = 0; i < 3; ++i) {
      const Point& x = mesh_.vertices[face[i]];
      for (const double coordinate : {x.x, x.y, x.z})
        rounding = std::max(rounding, source_.written.roundingOf(coordinate));
      longest = std::max(longest, norm(mesh_.vertices[face[(i + 1) % 3]] - x));
    }
    const Point& corner = mesh_.vertices[face[0]];
    const double height = norm(cross(mesh_.vertices[face[1]] - corner, mesh_.vertices[face[2]] - corner)) / longest;
    return std::sqrt(3.0) * rounding * (2 + 2 * distance / height);
  }

  [[noreturn]] void fail(std::size_t face, const std::string& text) const {
    throw InputError(source_.name + ":" + std::to_string(source_.faceLines[face]) + ":1: face " +
                     std::to_string(source_.faceNumbers[face]) + ": " + text);
  }

  void checkOrigin(std::size_t f, const ShellPlane& plane) const {
    if (plane.offset >= minOffset * size_) return;
    fail(f, plane.offset <= 0 ? "the origin is not inside of this face; a shell lies around the origin, so move it"
                              : "the origin lies almost in this face; a shell has it well inside, so move it");
  }

  /// Throws if a vertex lies outside of the plane by more than the file's digits explain. Otherwise moves the plane to
  /// the farthest vertex outside, so that the shell holds all of its vertices.
  void moveOutwards(std::size_t f, ShellPlane& plane) {
    const Face& face = mesh_.faces[f];
    double farthest = plane.offset;
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
      const double along = dot(plane.normal, mesh_.vertices[v]);
      if (!(along > plane.offset + planeWithin * size_)) continue;
      const double distance = norm(mesh_.vertices[v] - mesh_.vertices[face[0]]);
      if (along > plane.offset + std::min(toleranceAt(face, distance), maxRounding * size_))
        fail(f, "vertex " + std::to_string(v + 1) +
                    " lies outside of its plane; a shell is convex, so move one of them, or split a polygon "
                    "that is not flat the other way");
      farthest = std::max(farthest, along);
      isRounded_ = true;
    }
    plane.offset = farthest;
  }

  const Mesh& mesh_;
  const MeshSource& source_;
  double size_ = 0;
  bool isRounded_ = false;  // some vertex lies outside of a plane, as the digits of the file explain
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
