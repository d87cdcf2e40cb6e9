#include "diagnose/vertex_forces.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/error.h"
#include "connections/connections.h"
#include "contacts/contacts.h"
#include "observation/membrane_edges.h"
#include "physics/bending.h"
#include "physics/integrator.h"
#include "physics/stages.h"
#include "simulation/motility.h"
#include "simulation/move_physics.h"
#include "simulation/simulation.h"
#include "simulation/swirls.h"

namespace morula {
namespace {

/// Returns the forces of the membrane's springs [force] [Nilsson 2008, eq. 4.2].
std::vector<Vector> springForces(const Bodies& b, int slot) {
  std::vector<Vector> force(b.vertexCount(slot));
  const MembraneParameters& m = b.parameters.membrane;
  const double damping = m.damping.of(m.stiffness, b.vertexMass[slot]);
  forEachEdge(b, slot, [&](const MembraneEdge& edge) {
    const double length = norm(edge.d);
    if (!(length > 0)) return;
    const double tension = m.stiffness * (length - edge.rest) + damping * (dot(edge.rate, edge.d) / length);
    const Vector f = (edge.weight * tension / length) * edge.d;
    force[edge.i] += f;
    force[edge.j] -= f;
  });
  return force;
}

/// Returns ∇V of each vertex [length²]: a third of the area vectors of its faces [Nilsson 2008, eq. 4.5].
std::vector<Vector> volumeGradients(const Bodies& b, int slot) {
  std::vector<Vector> gradient(b.vertexCount(slot));
  for (const auto& [i, j, k] : b.meshOf(slot).mesh.faces) {
    const Point x = b.vertex(slot, i);
    const Vector third = (1.0 / 6) * cross(b.vertex(slot, j) - x, b.vertex(slot, k) - x);
    for (const int v : {i, j, k}) gradient[v] = gradient[v] + third;
  }
  return gradient;
}

std::vector<Vector> scaled(double by, std::vector<Vector> vectors) {
  for (Vector& v : vectors) v = by * v;
  return vectors;
}

/// Returns the vectors of the slot's vertices in an array, times a factor.
std::vector<Vector> ofSlot(const Bodies& b, int slot, const Reals& array, double times = 1) {
  std::vector<Vector> vectors;
  for (int v = 0; v < b.vertexCount(slot); ++v) vectors.push_back(times * b.read(array, slot, v));
  return vectors;
}

/// Returns the forces on all vertices that `add` adds, laid out as Bodies::acceleration. The bodies do not change.
template <class Add>
Reals addedToAll(Bodies& b, Add add) {
  Reals kept = b.acceleration;
  b.acceleration.assign(b.acceleration.size(), 0);
  add();
  std::swap(kept, b.acceleration);
  return kept;
}

/// Returns mass times acceleration [force].
std::vector<Vector> wholeForces(const Bodies& b, int slot) {
  return ofSlot(b, slot, b.acceleration, b.vertexMass[slot]);
}

/// Returns the forces of the medium [force], in proportion to mass.
std::vector<Vector> dragForces(const Bodies& b, int slot) {
  return ofSlot(b, slot, b.velocity, -b.parameters.drag * b.vertexMass[slot]);
}

void addTo(std::vector<Vector>& sum, const std::vector<Vector>& more) {
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] += more[v];
}

void takeFrom(std::vector<Vector>& sum, const std::vector<Vector>& less) {
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] -= less[v];
}

/// Returns the shell's force against a force that presses vertices outwards (physics/shell_kernel.h); zero for vertices
/// that do not lie on the shell.
std::vector<Vector> shellForces(const Bodies& b, int slot, const std::vector<Vector>& pressing) {
  const double* a = b.parameters.shell->semiAxes.data();
  const double within = b.parameters.precision == Precision::binary64 ? 1e-12 : 1e-6;
  std::vector<Vector> force(pressing.size());
  for (std::size_t v = 0; v < pressing.size(); ++v) {
    const Point x = b.vertex(slot, int(v));
    const Vector slope{x.x / (a[0] * a[0]), x.y / (a[1] * a[1]), x.z / (a[2] * a[2])};
    const double outward = dot(pressing[v], slope);
    if (dot(x, slope) > 1 - within && outward > 0) force[v] = (-outward / dot(slope, slope)) * slope;
  }
  return force;
}

/// The outer forces of a whole world, each evaluated once.
struct OuterForces {
  std::optional<Reals> contact, bareContact, connections;  // bareContact: without adhesion
  std::vector<Reals> others;
};

OuterForces outerForces(World& world) {
  Bodies& b = *world.bodies;
  OuterForces outer;
  const auto addContacts = [&] {
    for (int block = 0; block < b.blockCount(); ++block)
      addContactForces(*world.contacts, b, block, world.clock.timeStep);
  };
  if (world.contacts) outer.contact = addedToAll(b, addContacts);
  if (world.contacts && world.contacts->parameters.adhesion) {
    Adhesion& adhesion = world.contacts->adhesion;
    Adhesion kept = adhesion;
    for (auto& ofBlock : adhesion.ofPairs) std::ranges::fill(ofBlock, 0.0);
    std::ranges::fill(adhesion.saturation, 0.0);
    outer.bareContact = addedToAll(b, addContacts);
    adhesion = std::move(kept);
  }
  if (world.connections)
    outer.connections = addedToAll(b, [&] { addConnectionForces(*world.connections, world.cells.path, b); });
  if (world.motility) outer.others.push_back(addedToAll(b, [&] { addMotility(world); }));
  if (world.swirls) outer.others.push_back(addedToAll(b, [&] { addSwirlForces(world); }));
  return outer;
}

ForcesByKind forcesOf(const World& world, int slot, const OuterForces& outer) {
  const Bodies& b = *world.bodies;
  const int vertices = b.vertexCount(slot);
  ForcesByKind of;
  for (auto& force : of) force.resize(vertices);
  const auto at = [&](ForceKind kind) -> std::vector<Vector>& { return of[std::size_t(kind)]; };
  const auto add = [&](ForceKind kind, const std::optional<Reals>& forces, double times = 1) {
    if (forces) addTo(at(kind), ofSlot(b, slot, *forces, times));
  };
  if (b.model().hasMembrane) {
    at(ForceKind::spring) = springForces(b, slot);
    addTo(at(ForceKind::spring), measureBendingForces(b, slot));
    at(ForceKind::pressure) =
        scaled(b.pressureConstant[slot] / b.volume[slot] - b.parameters.pressure.outside, volumeGradients(b, slot));
    at(ForceKind::other) = dragForces(b, slot);
  }
  add(ForceKind::contact, outer.bareContact ? outer.bareContact : outer.contact);
  if (outer.bareContact) {
    add(ForceKind::adhesion, outer.contact);
    add(ForceKind::adhesion, outer.bareContact, -1);
  }
  add(ForceKind::adhesion, outer.connections);
  for (const Reals& forces : outer.others) add(ForceKind::other, forces);

  std::vector<Vector> left = wholeForces(b, slot), sum(vertices);  // forces without a name yet, and with one
  for (const auto& force : of) addTo(sum, force);
  takeFrom(left, sum);
  const ShellShape shape = shellShapeOf(b.parameters);
  if (b.model().hasMembrane && (shape == ShellShape::sphere || shape == ShellShape::ellipsoid)) {
    at(ForceKind::shell) = shellForces(b, slot, sum);
    takeFrom(left, at(ForceKind::shell));
  }
  // If several planes may bear at once, or the shell does not hold vertices, the rest of the force is the shell's part.
  // In other scenes the rest has no name.
  const bool leftIsShell = shape == ShellShape::planes || shape == ShellShape::surface;
  double most = 0;
  for (const Vector& f : sum) most = std::max(most, norm(f));
  for (int v = 0; v < vertices; ++v) {
    const bool isRounding = norm(left[v]) <= 1e-12 * most;
    at(b.model().hasMembrane && leftIsShell && !isRounding ? ForceKind::shell : ForceKind::other)[v] += left[v];
  }
  return of;
}

}  // namespace

std::vector<VertexForces> measureForces(World& world, int slot) {
  Bodies& b = *world.bodies;
  std::vector<VertexForces> all;
  const auto add = [&](const char* name, auto addForces) {
    all.push_back({name, ofSlot(b, slot, addedToAll(b, addForces))});
  };
  if (b.model().hasMembrane) {
    const std::vector<Vector> gradient = volumeGradients(b, slot);
    all.push_back({"springs", springForces(b, slot)});
    if (b.parameters.membrane.bending > 0) all.push_back({"bending", measureBendingForces(b, slot)});
    all.push_back({"contents", scaled(b.pressureConstant[slot] / b.volume[slot], gradient)});
    all.push_back({"outer pressure", scaled(-b.parameters.pressure.outside, gradient)});
  }
  if (world.contacts)
    add("contacts", [&] { addContactForces(*world.contacts, b, slot / blockLanes, world.clock.timeStep); });
  if (world.connections) add("connections", [&] { addConnectionForces(*world.connections, world.cells.path, b); });
  if (world.motility) add("crawling", [&] { addMotility(world); });
  if (b.model().hasRestShape) {
    VertexForces shape{"its shape", wholeForces(b, slot)};  // the rest of the whole
    for (const VertexForces& other : all) takeFrom(shape.onVertex, other.onVertex);
    all.push_back(std::move(shape));
  }
  return all;
}

void checkHasForces(const PhysicsParameters& physics) {
  if (kindOf(physics.integrator).solvesForces)
    throw InputError(
        "forces cannot be shown with physics.integrator xpbd, which moves vertices to where springs and contents want "
        "them; choose another integrator, such as velocity-verlet");
}

std::vector<ForcesByKind> forcesByKind(World& world) {
  checkHasForces(world.bodies->parameters);
  evaluateForces(world);
  const OuterForces outer = outerForces(world);
  std::vector<ForcesByKind> cells;
  for (const int slot : world.bodies->slots) cells.push_back(forcesOf(world, slot, outer));
  return cells;
}

std::vector<ForcesByKind> forcesByKind(const World& world, World& scratch) {
  scratch.clock = world.clock;
  scratch.cells = world.cells;
  scratch.bodies = world.bodies;
  scratch.contacts = world.contacts;
  scratch.connections = world.connections;
  scratch.motility = world.motility;
  scratch.swirls = world.swirls;
  return forcesByKind(scratch);
}

}  // namespace morula
