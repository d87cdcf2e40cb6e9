// Scenarios of a check that were held against Bullet.
#include <algorithm>

#include "report/bullet_block.h"
#include "system/installation.h"

namespace morula {
namespace {

bool heldAgainstBullet(const CheckedScenario& c) {
  return std::any_of(c.report.results.begin(), c.report.results.end(),
                     [](const CheckResult& r) { return r.kind == "bullet" && !wasSkipped(r); });
}

bool differsFromBullet(const CheckedScenario& c) {
  return std::any_of(c.report.results.begin(), c.report.results.end(),
                     [](const CheckResult& r) { return r.kind == "bullet" && !r.passed; });
}

}  // namespace

int runCheckedInBullet(std::vector<CheckedScenario>& checked, const ReportQuestion& question) {
  std::size_t made = 0;
  for (const bool wantDiffering : {true, false})
    for (CheckedScenario& c : checked) {
      if (made == mostInBullet) return 0;
      if (!heldAgainstBullet(c) || differsFromBullet(c) != wantDiffering) continue;
      if (const int signal = runCheckedAgain(c, question)) return signal;
      if (!c.again || !c.again->scenario.check.bullet || c.again->simulation.end.status != RunStatus::done) continue;
      c.bullet = runInBulletAgain(c.again->scenario, c.again->simulation.world, question.frames, question.quiet);
      ++made;
    }
  return 0;
}

std::vector<PageSection> bulletSections(const std::vector<CheckedScenario>& checked) {
  std::vector<PageSection> sections;
  for (const CheckedScenario& c : checked) {
    if (!c.bullet) continue;
    sections.push_back({"bullet-" + std::to_string(sections.size() + 1),
                        "Beside Bullet: " + c.report.scenario,
                        besideBullet(c.again->scenario, c.again->simulation.world, *c.bullet, &c.report.results, {}),
                        {programWord() + " check " + shellWord(c.file), programWord() + " run " + shellWord(c.file)}});
  }
  const auto held = static_cast<std::size_t>(std::count_if(checked.begin(), checked.end(), heldAgainstBullet));
  if (!sections.empty() && held > sections.size())
    sections.back().body.note("Shown of " + std::to_string(sections.size()) + " of " + counted(held, "scenario") +
                              " that were held against Bullet; morula report shows it of any run.");
  return sections;
}

}  // namespace morula
