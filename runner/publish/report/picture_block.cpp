// Pictures of runs: organisms, meshes, trees.
#include <cmath>
#include <set>

#include "base/number_text.h"
#include "pictures/pictures.h"
#include "report/run_blocks.h"
#include "report_data/run_words.h"
#include "views/cell_colours.h"

namespace morula {
namespace {

constexpr std::size_t maxPictured = 8;    // max number of runs with pictures
constexpr std::size_t treeLimit = 20000;  // max number of cells in a tree that is drawn
constexpr std::size_t fewCells = 32;      // max number of cells in a tree that is legible when small

/// Returns a key that is equal for runs with the same tree: the same cells, times, fates and substances.
std::string treeKey(const RunFacts& facts) {
  std::string key = numberText(facts.run.time, 17);
  for (const LineageEntry& c : facts.results.lineage)
    key += '|' + c.path.text() + ' ' + exactText(c.born) + ' ' + exactText(c.ended) + ' ' + name(c.fate) + ' ' +
           facts.results.stateTexts.at(c.state);
  return key;
}

Picture treeOf(const RunFacts& facts, const std::string& of) {
  const auto describe = [&](StateId state) { return facts.results.stateTexts.at(state); };
  TreePicture tree = lineagePictureOf(facts.results.lineage, describe, facts.run.time, facts.scenario,
                                      facts.results.experiments);
  const bool few = facts.results.lineage.size() <= fewCells;
  if (few) tree.width = 560, tree.height = 420;
  const Drawing drawing = drawLineage(tree);
  const std::string what = of + "the tree of " + counted(facts.results.lineage.size(), "cell"),
                    caption = of + "the lineage";
  return few ? svgPicture(drawing, what, caption) : pngPicture(drawing.pixels(), what, caption);
}

/// Returns true if the last state can be drawn; that of a failed run may hold NaN.
bool canBeDrawn(const RunFacts& facts) {
  if (!facts.again || !facts.again->simulation.world.bodies) return false;
  const OrganismPicture picture = pictureOf(facts.again->simulation.world, facts.scenario);
  for (const CellShape& cell : picture.cells)
    for (const Point& p : cell.vertices)
      // Pixels and depths have single precision.
      if (!(std::abs(p.x) < 1e6 && std::abs(p.y) < 1e6 && std::abs(p.z) < 1e6)) return false;
  return true;
}

/// Returns the organism in the colours of its scenario, or of clones if the scenario gives none.
OrganismPicture colouredPicture(const RunFacts& facts) {
  const World& world = facts.again->simulation.world;
  std::vector<OrganismPicture> pictures{pictureOf(world, facts.scenario)};
  const Colouring clones{.by = Colouring::By::clone};
  if (pictures[0].legend.empty())
    colourCells(pictures, {colourValues(world, clones, facts.scenario)}, clones, facts.scenario);
  return pictures[0];
}

struct Pictured {
  const RunFacts* run;
  OrganismPicture picture;
};

/// Returns the places in `all` of the first two runs of one scenario; both are 0 if there are no two.
std::pair<std::size_t, std::size_t> firstTwo(const std::vector<Pictured>& all) {
  for (std::size_t b = 1; b < all.size(); ++b)
    for (std::size_t a = 0; a < b; ++a)
      if (all[a].run->run.record.scenario == all[b].run->run.record.scenario) return {a, b};
  return {0, 0};
}

void overlay(std::vector<Pictured>& all, Document& body) {
  const auto [a, b] = firstTwo(all);
  if (a == b) return;
  std::vector<OrganismPicture> both{all[a].picture, all[b].picture};
  shareLegend(both);
  both[0].camera.framing = both[1].camera.framing = fitFraming(both);
  all[a].picture = both[0], all[b].picture = both[1];
  body.add(Swipe{std::to_string(a), std::to_string(b), titleOf(*all[a].run) + " | " + titleOf(*all[b].run)});
}

/// Returns true if the edges of cells' meshes can be told apart in a picture; spheres have none.
bool showsMeshes(const RunFacts& r) {
  constexpr std::uint64_t most = 1024;  // cells
  return r.run.cells <= most && r.scenario.scene.mechanics->physics.cell.model != CellModel::sphere;
}

}  // namespace

PageSection pictureSection(const std::vector<RunFacts>& runs) {
  PageSection section{"pictures", "Pictures", {}};
  std::vector<Pictured> pictured;
  for (const RunFacts& r : runs)
    if (pictured.size() < maxPictured && canBeDrawn(r))
      pictured.push_back({&r, colouredPicture(r)});
  for (Pictured& p : pictured)  // a study's page has many organisms
    if (!p.run->label.empty()) p.picture.width = p.picture.height = 600;
  overlay(pictured, section.body);
  Document pictures;
  const auto before = [&](const RunFacts& r) { return runs.size() > 1 ? titleOf(r) + ": " : ""; };
  for (std::size_t i = 0; i < pictured.size(); ++i) {
    const RunFacts& r = *pictured[i].run;
    const std::string when = r.run.status == RunStatus::done ? "at the end" : "where it failed";
    Picture picture = pngPicture(drawOrganism(pictured[i].picture),
                                 before(r) + "the organism at time " + shownTime(r.scenario.units, r.run.time, 6) +
                                     ", " + counted(r.run.cells, "cell"),
                                 before(r) + "the organism " + when, std::to_string(i));
    picture.id = "picture-" + std::to_string(i);
    pictures.add(std::move(picture));
    if (runs.size() == 1 && showsMeshes(r))
      pictures.add(pngPicture(drawOrganism(pictured[i].picture, Style::wireframe), before(r) + "the organism as meshes",
                              before(r) + "the meshes"));
    if (r.run.status == RunStatus::done) section.commands.push_back(commandFor(r, "render", "-o organism.png"));
  }
  std::set<std::string> trees;
  std::size_t drawn = 0;
  for (const RunFacts& r : runs) {
    if (r.results.lineage.empty() || r.results.lineage.size() > treeLimit || drawn >= maxPictured) continue;
    if (!trees.insert(treeKey(r)).second) continue;
    ++drawn;
    pictures.add(treeOf(r, before(r)));
    section.commands.push_back(commandFor(r, "lineage", "-o lineage.png"));
  }
  section.body.add(Group{Group::Kind::pictures, "", std::move(pictures)});
  if (runs.size() == 1 && runs[0].beside) section.body.add(goldenPictures(*runs[0].beside, titleOf(runs[0])));
  if (runs.size() > 1 && trees.size() == 1 && drawn == 1) section.body.note("The lineage is the same in all runs.");
  if (section.commands.size() > 6) section.commands.resize(6);
  return section;
}

Document goldenPictures(const BesideGolden& beside, const std::string& name) {
  Document all, pictures;
  const ComparisonImages& images = beside.images;
  if (beside.source == BesideGolden::Source::none) {
    pictures.add(pngPicture(images.other, name + ": the organism as it is now", "as it is now"));
  } else {
    all.add(Swipe{"accepted", "now", "as accepted | as it is now"});
    const auto add = [&](const Image& image, const std::string& id, const std::string& what) {
      pictures.add(pngPicture(image, name + ": " + what, what, id));
    };
    add(images.one, "accepted", "as accepted");
    add(images.other, "now", "as it is now");
    add(images.distance, "distance", "distance from the accepted result");
  }
  all.add(Group{Group::Kind::pictures, "", std::move(pictures)});
  for (const std::string& note : beside.notes) all.note(note);
  if (!images.unmatched.empty()) all.note(images.unmatched);
  return all;
}

}  // namespace morula
