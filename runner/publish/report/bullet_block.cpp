// Comparisons with Bullet on a page, of runs and of checked scenarios.
#include "report/bullet_block.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/number_text.h"
#include "mesh/distance.h"
#include "mesh/mesh_measures.h"
#include "observation/measures.h"
#include "pictures/pictures.h"
#include "system/installation.h"

namespace morula {
namespace {

constexpr std::size_t maxCells = 12;     // max number of rows in the table of distances
constexpr double roundingRadii = 1e-11;  // [radii] rounding of doubles near 1 adds up to less in ten thousand steps

/// The distance of one cell's surface in Morula from that in Bullet, over its vertices.
struct CellDistance {
  std::string cell;
  double largest = 0, meanSquare = 0;  // [length], [length²]
  Point at;                            // the vertex with the largest distance
  std::size_t vertices = 0;
  double ourVolume = 0, bulletVolume = 0;  // [length³]
};

std::vector<CellDistance> distancesOf(const Scenario& scenario, const World& ours,
                                      const std::vector<std::vector<Point>>& shapes) {
  std::vector<CellDistance> all;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const CellPath& path = ours.cells.path[i];
    const Mesh own = cellMesh(ours, path);
    const Mesh theirs{shapes[i], own.faces};
    CellDistance d{.cell = cellWords(scenario.names.function(), path), .at = {}};
    const auto distances = measureDistances(own, theirs);
    for (std::size_t v = 0; v < distances.size(); ++v) {
      if (v == 0 || distances[v] > d.largest) d.largest = distances[v], d.at = own.vertices[v];
      d.meanSquare += distances[v] * distances[v] / static_cast<double>(distances.size());
    }
    d.vertices = distances.size();
    d.ourVolume = measureVolume(own.vertices, own.faces);
    d.bulletVolume = measureVolume(theirs.vertices, own.faces);
    all.push_back(std::move(d));
  }
  return all;
}

const char* baselineWords(Baseline baseline) {
  switch (baseline) {
    case Baseline::b1: return "b1: Morula's forces, moved by Bullet's integrator, with Bullet's contact";
    case Baseline::b2: return "b2: Bullet's own springs and pressure, integrator and contact";
    case Baseline::b3: return "b3: Morula's springs and pressure in Bullet's implicit solver";
  }
  return "";
}

std::string quantityWords(const CheckResult& r) {
  if (r.field == "positions") return "place of the vertex with the largest distance [length]";
  if (r.field == "radius") return "mean radius of each cell [length]";
  if (r.field == "volume") return "volume of each cell [length³]";
  if (r.field == "distance") return "distance of the centres of two cells, less Bullet's gap [length]";
  if (r.field == "aspect") return "length over thickness of each cell";
  return r.field;
}

/// Tells which geometry decides the comparison, and which does not.
std::string decidingWords(const BulletCheck& check, bool touching) {
  std::string text =
      "The quantities of this table decide whether the check passes; the pictures and the map of "
      "distances illustrate them. ";
  if (check.positions)
    return text +
           "No cells touch and both programs take the same steps, so the two results are compared vertex by vertex.";
  if (touching)
    return text + "Bullet keeps surfaces that touch two margins of " + numberText(check.margin, 4) +
           " radii apart, and its contact forces differ from Morula's, so places, sizes and flatness of cells are "
           "compared, not their surfaces point by point.";
  return text +
         "Both programs reach the same rest in different ways, so each cell is compared as a whole, not vertex by "
         "vertex.";
}

std::string digits(const std::string& text) {
  double number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  return problem == std::errc() && end == text.data() + text.size() ? numberText(number, 10) : text;
}

Table resultTable(const Scenario& scenario, const std::vector<CheckResult>& results) {
  Table table{"What decides", {"Compared", "Ours", "Bullet's", "Tolerance", "Share of it", "Result", "Worst of"}};
  for (const CheckResult& r : results) {
    const bool off = r.field == "positions";
    table.rows.push_back({quantityWords(r), digits(r.actual) + (off ? " off" : ""), off ? "" : digits(r.expected),
                          r.tolerance, r.share ? (*r.share == 0 ? "0" : numberText(100 * *r.share, 3)) + " %" : "",
                          mark(r.passed, "holds", "does not hold"),
                          r.cell ? withNames(cellName(*r.cell), scenario.names.function()) : ""});
  }
  return table;
}

Document distances(std::vector<CellDistance> all, double radius) {
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.largest > b.largest; });
  Table table{"Distances of the surfaces",
              {"Cell", "Largest distance [radii of the egg]", "Root mean square [radii]", "Morula's volume [length³]",
               "Bullet's volume [length³]"}};
  for (std::size_t i = 0; i < std::min(all.size(), maxCells); ++i)
    table.rows.push_back({all[i].cell, number(all[i].largest / radius, 3),
                          number(std::sqrt(all[i].meanSquare) / radius, 3), number(all[i].ourVolume, 8),
                          number(all[i].bulletVolume, 8)});
  Document body;
  body.add(std::move(table));
  if (all.size() > maxCells)
    body.note("The " + std::to_string(maxCells) + " farthest of " + std::to_string(all.size()) + " cells.");
  return body;
}

std::string farthestWords(const std::vector<CellDistance>& all, double radius) {
  const auto worst =
      std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.largest < b.largest; });
  // Coordinates within rounding are shown as 0.
  const auto place = [&](double x) { return std::abs(x) < 1e-9 * radius ? "0" : numberText(x, 3); };
  if (worst->largest < roundingRadii * radius)
    return "The surfaces are nowhere farther apart than " + numberText(worst->largest / radius, 2) +
           " radii of the egg; the map of distances shows rounding errors only.";
  double squares = 0, count = 0;
  for (const CellDistance& d : all)
    squares += d.meanSquare * static_cast<double>(d.vertices), count += static_cast<double>(d.vertices);
  return "The surfaces are farthest apart at " + worst->cell + ": " + numberText(worst->largest / radius, 3) +
         " radii of the egg, near (" + place(worst->at.x) + ", " + place(worst->at.y) + ", " + place(worst->at.z) +
         ") [length]. The root mean square over all vertices is " + numberText(std::sqrt(squares / count) / radius, 3) +
         " radii.";
}

Document pictures(const Scenario& scenario, const World& ours, const ExternalRun& bullet, const BulletShown& where) {
  const ComparisonImages images = imagesBesideBullet(ours, bullet.shapes, scenario);
  const std::string when = "at time " + shownTime(scenario.units, ours.clock.time, 6);
  Picture theirs = pngPicture(images.other, "Bullet's cells " + when, "Bullet's, " + when, where.swipe ? "bullet" : "");
  theirs.id = where.picture;
  Document three, all;
  three.add(pngPicture(images.one, "our cells " + when, "ours, " + when, where.swipe ? "ours" : ""))
      .add(std::move(theirs));
  three.add(pngPicture(images.distance, "a map of the distances of the surfaces",
                       "distance of each of Morula's vertices from Bullet's surface"));
  all.add(Group{Group::Kind::pictures, "", std::move(three)});
  if (where.swipe) all.add(Swipe{"ours", "bullet", "ours | Bullet's"});
  return all;
}

/// Returns the failure of Bullet's run as a whole; "" if it reached an end that can be compared.
std::string whyNone(const BulletAgain& again) {
  if (again.found.bullet || again.found.results.empty()) return {};
  const CheckResult& r = again.found.results.front();
  return wasSkipped(r) ? "Not compared with Bullet, because this program was built without it" : "Bullet: " + r.actual;
}

/// Returns "Ours and Bullet's are within every tolerance; the one used most …".
std::string sentenceOf(const std::vector<CheckResult>& results) {
  const auto failed = std::count_if(results.begin(), results.end(), [](const auto& r) { return !r.passed; });
  if (failed > 0)
    return "Morula's result and Bullet's differ by more than the tolerance in " + std::to_string(failed) + " of " +
           std::to_string(results.size()) + (results.size() == 1 ? " quantity" : " quantities") + ".";
  std::string text = "Morula's result and Bullet's agree within every tolerance";
  const CheckResult* most = nullptr;
  for (const CheckResult& r : results)
    if (r.share && (!most || *r.share > *most->share)) most = &r;
  if (most)
    text += "; the largest share of a tolerance is that of the " + most->field + ", " +
            numberText(100 * *most->share, 3) + " %";
  return text + ".";
}

Words storedWords(const std::vector<CheckResult>& found, const std::vector<CheckResult>& stored) {
  switch (compareWithStored(found, stored)) {
    case BulletStored::none:
      return "The database holds no comparison with Bullet; this comparison was made for the "
             "page.";
    case BulletStored::same:
      return "The comparison, repeated for this page, gives the numbers that are stored with the run, digit for "
             "digit.";
    case BulletStored::other:
      return warning() +
             "The comparison, repeated for this page, gives other numbers than are stored with the run; the checks "
             "show the stored ones.";
  }
  return {};
}

bool heldAgainstBullet(const CheckedScenario& c) {
  return std::any_of(c.report.results.begin(), c.report.results.end(),
                     [](const CheckResult& r) { return r.kind == CheckKind::bullet && !wasSkipped(r); });
}

bool differsFromBullet(const CheckedScenario& c) {
  return std::any_of(c.report.results.begin(), c.report.results.end(),
                     [](const CheckResult& r) { return r.kind == CheckKind::bullet && !r.passed; });
}

}  // namespace

Document besideBullet(const Scenario& scenario, const World& ours, const BulletAgain& again,
                      const std::vector<CheckResult>* stored, const BulletShown& where) {
  if (const std::string why = whyNone(again); !why.empty()) return Document().say(warning() + why + ".");
  if (!again.found.bullet) return {};
  const BulletCheck check = tolerancesFor(scenario);
  const double radius = scenario.scene.mechanics->physics.cell.radius;
  const auto apart = distancesOf(scenario, ours, again.found.bullet->shapes);
  const bool touching = scenario.scene.mechanics->contact && scenario.scene.cells.size() > 1;
  Document body;
  body.say(bold(sentenceOf(again.found.results)) + " " + bulletName() + ", " + baselineWords(check.baseline) +
           "; margin " + numberText(check.margin, 4) + " radii.");
  if (stored) body.say(storedWords(again.found.results, *stored));
  body.add(pictures(scenario, ours, *again.found.bullet, where));
  body.say(farthestWords(apart, radius)).add(distances(apart, radius));
  return body.say(decidingWords(check, touching)).add(resultTable(scenario, again.found.results));
}

void judgeBullet(const RunFacts& run, std::vector<Finding>& findings) {
  if (!run.bullet) return;
  using Kind = Finding::Kind;
  const auto& found = run.bullet->found;
  const bool stored = std::any_of(run.checks.begin(), run.checks.end(),
                                  [](const CheckResult& r) { return r.kind == CheckKind::bullet && !wasSkipped(r); });
  if (const std::string why = whyNone(*run.bullet); !why.empty()) {
    findings.push_back({Kind::warning, why + (stored ? "; the checks are the stored ones" : "")});
    return;
  }
  const bool sameProgram = buildId(run.run.record.build) == buildId(buildInfo());
  if (compareWithStored(found.results, run.checks) == BulletStored::other && run.again && run.again->same)
    findings.push_back({sameProgram ? Kind::bad : Kind::warning,
                        "Bullet, run again for this page, gives other numbers than are stored" +
                            std::string(sameProgram ? ", though by the same program"
                                                    : ", with another program; the checks are the stored ones")});
  if (!stored)
    for (const CheckResult& r : found.results)
      if (!r.passed) findings.push_back({Kind::bad, "Beside Bullet: " + r.message});
}

PageSection bulletSection(const std::vector<RunFacts>& runs) {
  PageSection section{"bullet", "Beside Bullet", {}};
  std::size_t asked = 0, made = 0;
  for (const RunFacts& run : runs) {
    asked += run.scenario.check.bullet && run.again;
    if (!run.bullet) continue;
    const std::string source = shellWord(sourceOf(run));
    if (runs.size() > 1) section.body.heading(titleOf(run));
    section.body.add(besideBullet(run.scenario, run.again->simulation.world, *run.bullet, &run.checks,
                                  {"picture-" + std::to_string(runs.size() + made), runs.size() == 1}));
    if (made++ == 0)
      section.commands = {programWord() + " run " + source, programWord() + " check " + source,
                          programWord() + " report " + shellWord(run.database)};
  }
  if (made > 0 && asked > made)
    section.body.note("The first " + std::to_string(made) + " of " + counted(asked, "run") +
                      " that are compared with Bullet.");
  return section;
}

void runCheckedInBullet(std::vector<CheckedScenario>& checked, const ReportQuestion& question) {
  std::size_t made = 0;
  for (const bool wantDiffering : {true, false})
    for (CheckedScenario& c : checked) {
      if (made == maxInBullet) return;
      if (!heldAgainstBullet(c) || differsFromBullet(c) != wantDiffering) continue;
      runCheckedAgain(c, question);
      if (!c.again || !c.again->scenario.check.bullet || c.again->simulation.end.status != RunStatus::done) continue;
      c.bullet = runInBulletAgain(c.again->scenario, c.again->simulation.world, question.frames, question.quiet);
      ++made;
    }
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
                              " that were compared with Bullet; morula report shows the comparison of any run.");
  return sections;
}

}  // namespace morula
