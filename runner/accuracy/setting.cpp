#include "accuracy/setting.h"

#include <fmt/format.h>

#include "base/number_text.h"

namespace morula {

namespace {

const char* name(Precision precision) { return precision == Precision::binary64 ? "double" : "single"; }
const char* name(ContactLaw law) { return law == ContactLaw::pair ? "pair" : "thesis"; }

}  // namespace

const char* name(Integrator integrator) {
  switch (integrator) {
    case Integrator::velocityVerlet:
      return "velocity-verlet";
    case Integrator::thesisVerlet:
      return "thesis-verlet";
    case Integrator::explicitEuler:
      return "explicit-euler";
    case Integrator::symplecticEuler:
      return "symplectic-euler";
    case Integrator::rungeKutta4:
      return "rk4";
    case Integrator::xpbd:
      return "xpbd";
  }
  return "";
}

double orderOf(Integrator integrator) {
  if (integrator == Integrator::rungeKutta4) return 4;
  return integrator == Integrator::velocityVerlet ? 2 : 1;
}

std::uint64_t evaluationsPerStep(const Setting& s) {
  return s.integrator == Integrator::rungeKutta4 ? 4 : s.substeps.value_or(1);
}

Setting settingOf(const Scenario& scenario, double timeStep) {
  const MechanicsScene& m = *scenario.scene.mechanics;
  Setting s{m.physics.integrator, timeStep, m.physics.precision, {}, {}, m.physics.substeps};
  if (!scenario.mesh.file) s.level = scenario.mesh.icosphere;
  if (m.contact) s.law = m.contact->law;
  return s;
}

Setting settingAsItIs(const Scenario& scenario, double leastTimeStep) {
  Setting s = settingOf(scenario, leastTimeStep);
  s.automatic = !scenario.scene.mechanics->physics.timeStep;
  return s;
}

std::vector<std::string> changesFor(const Setting& s) {
  std::vector<std::string> changes{fmt::format("physics.integrator={}", name(s.integrator)),
                                   "physics.time_step=" + (s.automatic ? "auto" : exactText(s.timeStep)),
                                   fmt::format("physics.precision={}", name(s.precision))};
  if (s.substeps) changes.push_back(fmt::format("physics.substeps={}", *s.substeps));
  if (s.level) changes.push_back(fmt::format("physics.mesh.icosphere={}", *s.level));
  if (s.law) changes.push_back(fmt::format("physics.contact.law={}", name(*s.law)));
  return changes;
}

std::string seriesName(const Setting& s, const Setting& usual) {
  std::string text = name(s.integrator);
  if (s.substeps.value_or(1) > 1) text += fmt::format(", {} sub-steps", *s.substeps);
  if (s.level != usual.level && s.level) text += fmt::format(", icosphere {}", *s.level);
  if (s.precision != usual.precision) text += fmt::format(", {}", name(s.precision));
  if (s.law != usual.law && s.law) text += fmt::format(", {} contact", name(*s.law));
  return text;
}

}  // namespace morula
