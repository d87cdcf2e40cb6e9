#include "engines/bullet_check.h"

#include "base/error.h"
#include "engines/bullet_scene.h"
#include "engines/engine_comparison.h"
#include "engines/engine_worker.h"
#include "system/child_process.h"

namespace morula {
namespace {

constexpr const char* skipped = "not checked: this build has no Bullet";

CheckResult about(const char* failureClass, const std::string& text) {
  return judged({.check = "bullet", .kind = "bullet", .expected = "an answer", .actual = text}, false,
                "bullet: " + text, failureClass);
}

/// Bullet's step is that of either Verlet (BulletScene::physics).
bool isVerlet(Integrator integrator) {
  return integrator == Integrator::thesisVerlet || integrator == Integrator::velocityVerlet;
}

}  // namespace

bool wasSkipped(const CheckResult& result) { return result.kind == "bullet" && result.expected == skipped; }

BulletCheck tolerancesFor(const Scenario& scenario) {
  BulletCheck check = *scenario.check.bullet;
  if (check.hasTolerances()) return check;
  const MechanicsScene& mechanics = *scenario.scene.mechanics;
  if (mechanics.contact && scenario.scene.cells.size() > 1) {
    check.distance = 0.01, check.volume = 0.001, check.aspect = 0.02;
  } else if (check.baseline == Baseline::b1 && isVerlet(mechanics.physics.integrator)) {
    check.positions = 1e-10 * mechanics.physics.cell.radius;
  } else {
    check.radius = check.volume = check.baseline == Baseline::b3 ? 1e-8 : 1e-6;
  }
  return check;
}

BulletFindings checkAgainstBullet(const Scenario& scenario, const World& end, bool quiet,
                                  const std::vector<double>& frameTimes) {
  if (!scenario.check.bullet) return {};
  if (!bulletIsAvailable())
    return {{{.check = "bullet", .kind = "bullet", .expected = skipped, .actual = skipped}}, {}};
  const BulletCheck check = tolerancesFor(scenario);
  tell("the same in Bullet, " + std::string(name(check.baseline)), quiet);
  ExternalRun bullet;
  try {
    bullet = runExternally(scenario,
                           {.engine = engineOf(check.baseline),
                            .margin = check.margin,
                            .integrator = scenario.scene.mechanics->physics.integrator,
                            .frameTimes = frameTimes},
                           ownProgram());
  } catch (const FileError& error) { return {{about("SETUP", error.what())}, {}}; }
  const bool silent = bullet.end == ExternalRun::End::silent;
  if (bullet.end != ExternalRun::End::done)
    return {{about(silent ? "SETUP" : "COMPUTATION", judge({}, bullet).text)}, {}};
  if (bullet.step != end.clock.step || bullet.shapes.size() != end.cells.path.size())
    return {{about("COMPUTATION", "came to another end: step " + std::to_string(bullet.step) + ", ours " +
                                      std::to_string(end.clock.step))},
            {}};
  return {compareWithBullet(end, bullet.shapes, check), bullet};
}

}  // namespace morula
