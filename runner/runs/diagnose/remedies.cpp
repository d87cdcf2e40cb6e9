#include "diagnose/remedies.h"

#include "base/maths.h"
#include "base/number_text.h"
#include "contacts/contacts.h"
#include "mesh/mesh_measures.h"
#include "simulation/make_world.h"
#include "simulation/simulation.h"

namespace morula {
namespace {

void add(std::vector<Remedy>& remedies, const char* key, double value, std::function<void(World&)> apply) {
  remedies.push_back({key, exactText(value), std::move(apply)});
}

/// Rounds a number so that it is easy to read and to type.
double rounded(double a) { return std::stod(numberText(a, 3)); }

void addTimeSteps(std::vector<Remedy>& remedies, const World& world, double advised) {
  std::vector<double> steps{powerOfTwoBelow(0.5 * world.clock.timeStep), powerOfTwoBelow(0.125 * world.clock.timeStep)};
  if (advised > 0) steps = {advised};
  for (const double step : steps) {
    add(remedies, "physics.time_step", step, [step](World& w) { w.bodies->parameters.timeStep = step; });
  }
}

void addContact(std::vector<Remedy>& remedies, const World& world) {
  if (!world.contacts) return;
  const ContactParameters& p = world.contacts->parameters;
  if (p.law != ContactLaw::thesis)
    for (const double factor : {4.0, 16.0}) {
      const double stiffness = rounded(factor * p.stiffness);
      add(remedies, "physics.contact.stiffness", stiffness,
          [stiffness](World& w) { w.contacts->parameters.stiffness = stiffness; });
    }
  if (world.bodies->areSpheres() || p.radius >= 1) return;
  add(remedies, "physics.contact.radius", 1, [](World& w) {
    w.contacts->parameters.radius = 1;
    setInfluenceRadii(*w.contacts, *w.bodies);
  });
}

void setOutside(World& w, double outside) {
  w.bodies->parameters.pressure.outside = w.bodies->kernelParameters.outsidePressure = outside;
}

/// Adds a pressure with which contents are at rest at the volume at which the membrane is at rest.
void addPressure(std::vector<Remedy>& remedies, const World& world) {
  const Bodies& b = *world.bodies;
  if (!b.model().hasMembrane) return;
  const PressureParameters& p = b.parameters.pressure;
  const Mesh& egg = b.mesh.mesh;
  const double volume = measureVolume(egg.vertices, egg.faces);
  if (p.constant > 0) {
    const double outside = rounded(p.constant / volume);
    if (outside > 1.02 * p.outside || outside < 0.98 * p.outside)
      add(remedies, "physics.pressure.outside", outside, [outside](World& w) { setOutside(w, outside); });
  } else if (p.outside > 0) {
    const double constant = rounded(p.outside * volume);
    add(remedies, "physics.pressure.constant", constant, [constant, volume](World& w) {
      Bodies& own = *w.bodies;
      own.parameters.pressure.constant = constant;
      for (int slot : own.slots) {
        const double scale = own.restScale[slot];
        own.pressureConstant[slot] = constant * scale * scale * scale;
      }
    });
  }
}

void addMembrane(std::vector<Remedy>& remedies, const World& world) {
  if (!world.bodies->model().hasMembrane) return;
  for (const double factor : {4.0, 0.25, 0.0625}) {
    const double stiffness = rounded(factor * world.bodies->parameters.membrane.stiffness);
    add(remedies, "physics.membrane.stiffness", stiffness, [stiffness](World& w) {
      w.bodies->parameters.membrane.stiffness = w.bodies->kernelParameters.stiffness = stiffness;
    });
  }
}

void addConnections(std::vector<Remedy>& remedies, const World& world) {
  if (!world.connections || !world.connections->parameters.strength) return;
  remedies.push_back({"connections.strength", "shared", [](World& w) { w.connections->parameters.strength.reset(); }});
}

/// Adds so much drag that the motion of a few hundred time steps dies away.
void addDrag(std::vector<Remedy>& remedies, const World& world) {
  const double drag = rounded(world.bodies->parameters.drag + 0.01 / world.clock.timeStep);
  add(remedies, "physics.drag", drag, [drag](World& w) {
    w.bodies->parameters.drag = w.bodies->kernelParameters.drag = drag;
    setStages(w, w.execution.isa);
  });
}

}  // namespace

std::vector<Remedy> remediesFor(const World& world, double timeStep) {
  std::vector<Remedy> remedies;
  addTimeSteps(remedies, world, timeStep);
  addContact(remedies, world);
  addPressure(remedies, world);
  addConnections(remedies, world);
  addMembrane(remedies, world);
  addDrag(remedies, world);
  return remedies;
}

}  // namespace morula
