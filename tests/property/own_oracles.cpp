#include "own_oracles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "biology/sense.h"
#include "contacts/contacts.h"
#include "mesh/convex_shell.h"
#include "mesh/mesh_measures.h"
#include "mesh_oracles.h"
#include "observation/measures.h"
#include "simulation/settle.h"

namespace morula::chance {

namespace {

/// Returns the mesh's volume [length³]: the sum of signed tetrahedra from the origin, face by face.
double ownVolume(const Mesh& m) {
  double six = 0;
  for (const Face& f : m.faces) {
    const Point &a = m.vertices[f[0]], &b = m.vertices[f[1]], &c = m.vertices[f[2]];
    six += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  }
  return six / 6;
}

/// Returns the share [1] of grid points inside `a` that are also inside `b`. The grid covers the box of `a`.
double ownOverlap(const Mesh& a, const Mesh& b) {
  constexpr int n = 11;
  const Box box = measureBox(a.vertices), other = measureBox(b.vertices);
  const auto inBox = [](const Box& k, const Point& p) {
    return p.x >= k.low.x && p.x <= k.high.x && p.y >= k.low.y && p.y <= k.high.y && p.z >= k.low.z && p.z <= k.high.z;
  };
  if (other.low.x > box.high.x || other.high.x < box.low.x || other.low.y > box.high.y || other.high.y < box.low.y ||
      other.low.z > box.high.z || other.high.z < box.low.z)
    return 0;
  int inside = 0, both = 0;
  const Vector size = box.high - box.low;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const Point p = box.low + Vector{(i + 0.5) / n * size.x, (j + 0.5) / n * size.y, (k + 0.5) / n * size.z};
        if (!isInside(p, a.vertices, a.faces)) continue;
        ++inside;
        both += inBox(other, p) && isInside(p, b.vertices, b.faces);
      }
  return inside ? static_cast<double>(both) / inside : 1;
}

/// Sampling error of the share: two standard deviations at 600 points and a share of a fifth.
constexpr double samplingError = 0.03;

/// Returns the place of a point relative to the shell [1]: 1 on the shell.
double reachOf(const ShellParameters& shell, const Point& p) {
  if (!shell.mesh) return norm(Vector{p.x / shell.semiAxes[0], p.y / shell.semiAxes[1], p.z / shell.semiAxes[2]});
  double most = 0;
  for (const ShellPlane& plane : shell.mesh->planes) most = std::max(most, dot(plane.normal, p) / plane.offset);
  return most;
}

}  // namespace

std::string ownVerdict(const World& world) {
  const Bodies& b = *world.bodies;
  const bool sphere = b.areSpheres();
  const double egg = ownVolume(sphere ? b.surface : b.mesh.mesh);
  std::vector<Mesh> meshes;
  for (int cell = 0; cell < b.count; ++cell) {
    const int slot = b.slots[cell];
    meshes.push_back(cellMesh(world, world.cells.path[cell]));
    const Mesh& m = meshes.back();
    const std::string name = "cell " + world.cells.path[cell].text();
    const double scale = b.restScale[slot], volume = ownVolume(m);
    // Membranes can be made for more or less than their contents (membrane.production).
    const double contents = b.parameters.pressure.constant;
    const double rest =
        egg * (b.model().hasMembrane && contents > 0 ? b.pressureConstant[slot] / contents : scale * scale * scale);
    if (!(volume > 0)) return name + " is inside out";
    if (volume > 10.1 * rest) return fmt::format("{} is blown up to {:.3f}", name, volume / rest);
    if (volume < 0.1 * rest) return fmt::format("{} is crushed to {:.3f}", name, volume / rest);
    if (b.parameters.shell) {
      std::vector<Point> inside;
      // The mesh of a ball has the ball's volume, so its vertices stand out. A shell that holds the surface of a mesh's
      // volume acts on vertices as if its half-axes were longer by the sag, which unit/physics tests.
      const double* a = b.parameters.shell->semiAxes.data();
      const bool holdsVertices = b.parameters.shell->mesh || b.parameters.shell->holds == Held::vertices;
      const double sag = sphere || holdsVertices ? 0 : b.sag[slot];
      if (sphere) {
        const Point centre = b.vertex(slot, 0);
        for (const Point& p : m.vertices)
          inside.push_back(centre + (b.parameters.cell.radius * scale / norm(p - centre)) * (p - centre));
      } else {
        for (const Point& x : m.vertices)
          inside.push_back({x.x * a[0] / (a[0] + sag), x.y * a[1] / (a[1] + sag), x.z * a[2] / (a[2] + sag)});
      }
      for (const Point& p : inside) {
        const double reach = reachOf(*b.parameters.shell, p);
        if (!(reach <= 1 + 5e-6)) return fmt::format("{} stands out of its shell: {:.6f}", name, reach);
      }
    }
  }
  for (std::size_t i = 0; i < meshes.size(); ++i)
    for (std::size_t j = 0; j < meshes.size(); ++j)
      if (i != j)
        if (const double share = ownOverlap(meshes[i], meshes[j]); share > 0.2 + samplingError)
          return fmt::format("cell {} shares {:.3f} with {}", world.cells.path[i].text(), share,
                             world.cells.path[j].text());
  return "";
}

std::map<std::string, std::string> familyOf(const World& world) {
  std::map<std::string, std::string> cells;
  for (const LineageEntry& e : world.lineage.entries) cells[e.path.text()] = world.biology->describe(e.state);
  return cells;
}

bool isOfGenesAlone(const Scene& scene) {
  return !scene.cycle.divisionSize && std::ranges::all_of(scene.senses, [](const SenseParameters& sense) {
    return kindOf(sense.kind).needs == SenseNeeds::nothing;
  });
}

bool isClosedBetweenEvents(const World& world) {
  if (!world.bodies || settles(world)) return false;
  const PhysicsParameters& p = world.bodies->parameters;
  const bool boundless = p.pressure.outside == 0 && p.pressure.constant > 0;  // contents that have no rest volume
  const bool touches =
      world.contacts && (world.bodies->areSpheres() || world.contacts->parameters.law != ContactLaw::pair);
  return world.bodies->model().hasMembrane && !p.shell && !p.growth && !p.motility && !boundless && !touches &&
         !world.swirls;
}

const Turn turns[3] = {
    {"half a turn about z",
     [](const Vector& v) {
       return Vector{-v.x, -v.y, v.z};
     },
     false, true},
    {"a third of a turn about (1, 1, 1)",
     [](const Vector& v) {
       return Vector{v.y, v.z, v.x};
     }},
    {"a mirror",
     [](const Vector& v) {
       return Vector{v.x, v.y, -v.z};
     },
     true},
};

Scene turned(Scene scene, const Turn& turn) {
  const auto place = [&](auto& v) { v = turn.place(v); };
  const auto size = [&](Vector& v) {
    place(v);
    v = {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
  };
  const auto rotation = [&](Vector& axis) {  // a mirror reverses rotations
    place(axis);
    if (turn.mirrors) axis = -1.0 * axis;
  };
  MechanicsScene& m = *scene.mechanics;
  const auto surface = [&](Mesh& mesh) {
    for (Point& v : mesh.vertices) place(v);
    if (turn.mirrors)
      for (Face& f : mesh.faces) std::swap(f[1], f[2]);
  };
  surface(m.mesh);
  for (Mesh& mesh : m.coarser) surface(mesh);
  if (auto& shell = m.physics.shell) {
    Vector axes{shell->semiAxes[0], shell->semiAxes[1], shell->semiAxes[2]};
    size(axes);
    if (shell->mesh) {
      ConvexShell copy = *shell->mesh;
      surface(copy.mesh);
      for (ShellPlane& plane : copy.planes) place(plane.normal);
      shell->mesh = std::make_shared<const ConvexShell>(std::move(copy));
    }
    shell->semiAxes[0] = axes.x, shell->semiAxes[1] = axes.y, shell->semiAxes[2] = axes.z;
  }
  const auto hand = [&](std::optional<Chirality>& chirality) {
    if (chirality && turn.mirrors) chirality->angle = -chirality->angle;
  };
  place(m.division.otherwise.axis);
  hand(m.division.chirality);
  for (DivisionRule& rule : m.division.rules) {
    if (rule.plane) place(rule.plane->axis);
    hand(rule.chirality);
  }
  for (SenseParameters& sense : scene.senses) place(sense.axis);
  for (StartCell& cell : scene.cells) place(cell.at), place(cell.velocity), rotation(cell.turn), size(cell.stretch);
  return scene;
}

}  // namespace morula::chance
