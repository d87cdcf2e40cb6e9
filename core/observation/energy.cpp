
#include "observation/energy.h"

#include "base/maths.h"
#include "contacts/pair_energy.h"
#include "observation/body_measures.h"
#include "observation/membrane_edges.h"
#include "physics/bending.h"

namespace morula {
namespace {

double membraneEnergy(const Bodies& b, int slot) {
  double sum = 0;
  forEachEdge(b, slot, [&](const MembraneEdge& e) {
    const double off = norm(e.d) - e.rest;
    sum += e.weight * (off * off);
  });
  return 0.5 * b.parameters.membrane.stiffness * sum;
}

double contentsEnergy(const Bodies& b, int slot) {
  const double k = b.pressureConstant[slot], outside = b.parameters.pressure.outside;
  if (k == 0) return outside * b.volume[slot];
  const double r = outside * b.volume[slot] / k;
  return k * (r - 1 - naturalLog(r));
}

double membranePower(const Bodies& b, int slot) {
  double sum = 0;
  forEachEdge(b, slot, [&](const MembraneEdge& e) {
    const double square = dot(e.d, e.d), along = dot(e.rate, e.d);
    if (square > 0) sum += e.weight * (along * along / square);
  });
  return b.parameters.membrane.damping.of(b.parameters.membrane.stiffness, b.vertexMass[slot]) * sum;
}

/// Returns −Σ F·v of the forces that damping and viscosity add to contact.
double contactPower(const World& world) {
  if (!world.contacts || world.bodies->areSpheres() || world.contacts->parameters.law != ContactLaw::pair) return 0;
  Bodies b = *world.bodies;
  const auto powerOf = [&](double damping, double viscosity) {
    Contacts c = *world.contacts;
    c.damping = damping;
    c.parameters.viscosity = viscosity;
    b.acceleration.assign(b.acceleration.size(), 0);
    for (int block = 0; block < b.blockCount(); ++block) addContactForces(c, b, block, world.clock.timeStep);
    double power = 0;
    for (int slot : b.slots)
      for (int v = 0; v < b.vertexCount(slot); ++v)
        power += dot(b.read(b.acceleration, slot, v), b.read(b.velocity, slot, v));
    return power;
  };
  const double damping = world.contacts->damping, viscosity = world.contacts->parameters.viscosity;
  return damping > 0 || viscosity > 0 ? powerOf(0, 0) - powerOf(damping, viscosity) : 0;
}

}  // namespace

Energy measureEnergy(const Bodies& b) {
  Energy e;
  for (int slot : b.slots) {
    e.kinetic += measureKineticEnergy(b, slot);
    e.membrane += membraneEnergy(b, slot) + measureBendingEnergy(b, slot);
    e.contents += contentsEnergy(b, slot);
  }
  return e;
}

Energy measureEnergy(const World& world) {
  const Bodies& b = *world.bodies;
  Energy e = measureEnergy(b);
  if (world.connections) e.connections = measureConnectionEnergy(*world.connections, world.cells.path, b);
  if (world.contacts && !b.areSpheres() && world.contacts->parameters.law == ContactLaw::pair)
    for (const PairSum& pair : sumPairs(*world.contacts, b)) e.contact += pair.repulsion, e.adhesion += pair.adhesion;
  return e;
}

double measureDissipation(const World& world) {
  const Bodies& b = *world.bodies;
  double power = contactPower(world);
  for (int slot : b.slots) {
    power += 2 * b.parameters.drag * measureKineticEnergy(b, slot);
    if (b.model().hasMembrane) power += membranePower(b, slot);
  }
  return power;
}

}  // namespace morula
