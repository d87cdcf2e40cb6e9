#include "accuracy/setting.h"

#include <fmt/format.h>

#include "base/number_text.h"
#include "physics/cell_model.h"
#include "physics/integrator.h"

namespace morula {

std::uint64_t evaluationsPerStep(const Setting& s) {
  return static_cast<std::uint64_t>(kindOf(s.integrator).evaluations) * s.substeps.value_or(1);
}

Setting settingOf(const Scenario& scenario, double timeStep) {
  const MechanicsScene& m = *scenario.scene.mechanics;
  Setting s;
  s.integrator = m.physics.integrator;
  s.timeStep = timeStep;
  s.precision = m.physics.precision;
  s.substeps = m.physics.substeps;
  if (!scenario.mesh.file) s.level = scenario.mesh.icosphere;
  if (m.contact) s.law = m.contact->law;
  return s;
}

Setting settingAsItIs(const Scenario& scenario, double leastTimeStep) {
  Setting s = settingOf(scenario, leastTimeStep);
  s.automatic = !scenario.scene.mechanics->physics.timeStep;
  s.autoShare = scenario.scene.mechanics->physics.autoShare;
  return s;
}

namespace {

void addChanges(const OtherModel& other, std::vector<std::string>& changes) {
  const auto take = [&](const char* path) { changes.push_back(fmt::format("{}=null", path)); };
  changes.push_back(fmt::format("physics.cell.model={}", nameOf(other.model)));
  take("physics.membrane");
  take("physics.pressure");
  if (kindOf(other.model).hasRestShape) {
    const auto give = [&](const char* key, double value) {
      changes.push_back(fmt::format("physics.shape-matching.{}={}", key, numberText(value)));
    };
    give("stiffness", other.matched.stiffness);
    give("linear", other.matched.linear);
    give("damping", other.matched.damping);
  } else {
    for (const char* path : {"physics.shape-matching", "physics.mesh.coarsen", "physics.contact.radius"}) take(path);
  }
}

}  // namespace

std::string timeStepChange(const Setting& s) {
  if (!s.automatic) return "physics.time_step=" + exactText(s.timeStep);
  return s.autoShare == 1 ? "physics.time_step=auto" : "physics.time_step.auto=" + exactText(s.autoShare);
}

std::vector<std::string> changesFor(const Setting& s) {
  std::vector<std::string> changes{fmt::format("physics.integrator={}", nameOf(s.integrator)), timeStepChange(s),
                                   fmt::format("physics.precision={}", nameOf(s.precision))};
  if (s.substeps) changes.push_back(fmt::format("physics.substeps={}", *s.substeps));
  if (s.level) changes.push_back(fmt::format("physics.mesh.icosphere={}", *s.level));
  if (s.coarsen) changes.push_back("physics.mesh.coarsen=" + exactText(*s.coarsen));
  if (s.law) changes.push_back(fmt::format("physics.contact.law={}", nameOf(*s.law)));
  if (s.model) addChanges(*s.model, changes);
  return changes;
}

std::string seriesName(const Setting& s, const Setting& usual) {
  std::string text = nameOf(s.integrator);
  if (s.automatic) text += ", automatic";
  if (s.substeps.value_or(1) > 1) text += fmt::format(", {} sub-steps", *s.substeps);
  if (s.level != usual.level && s.level) text += fmt::format(", icosphere {}", *s.level);
  if (s.precision != usual.precision) text += fmt::format(", {}", nameOf(s.precision));
  if (s.law != usual.law && s.law) text += fmt::format(", {} contact", nameOf(*s.law));
  if (s.model) text += fmt::format(", {}", nameOf(s.model->model));
  return text;
}

}  // namespace morula
