#include "check/beside_golden.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "base/error.h"
#include "check/check_run.h"
#include "check/golden_scenario.h"
#include "document/words.h"
#include "files/folders.h"
#include "golden/read_number.h"
#include "loop/simulate.h"
#include "mesh/mesh_measures.h"
#include "pictures/pictures.h"

namespace morula {
namespace {

constexpr int side = 700;  // [pixel] of each picture

/// The golden's scenario, run to its end.
struct MadeAgain {
  std::optional<OrganismPicture> picture;  // if it came to the golden's state
  std::string whyNot;
};

MadeAgain makeAgain(const Scenario& scenario, const Golden& golden, const Execution& how, bool quiet) {
  const auto before = goldenScenario(scenario, golden);
  if (!before)
    return {{},
            "the full scenario of the golden is not known (goldens hold DNA and meshes as hashes, and git does "
            "not have these files)"};
  if (before->meaning == scenario.meaning) return {{}, "this build computes other bits from the same scenario"};
  try {
    const auto run = simulate(*before, how, {.label = before->scene.name + ", the golden's", .quiet = quiet});
    if (run.end.want != Want::nothing) return {{}, "the memory does not suffice for the golden's scenario"};
    if (run.end.status != RunStatus::done || run.end.stateHash->text() != acceptedBits(golden))
      return {{}, "this build computes other bits from the golden's scenario"};
    return {pictureOf(run.world, *before), ""};
  } catch (const InputError&) { return {{}, "this build no longer reads the golden's scenario"}; }
}

/// The living cells of a golden as spheres of their volumes, at their places. Empty where it holds no values of cells.
OrganismPicture spheresOf(const Golden& golden, const Scenario& scenario) {
  std::map<CellPath, std::map<std::string, double>> values;  // of the end
  for (const auto* value : all<GoldenValue>(golden.data))
    if (!value->name.time && value->name.cell && value->value)
      values[*value->name.cell][value->name.measure] = *value->value;
  Palette palette(scenario);
  OrganismPicture picture;
  const Mesh ball = makeIcosphere(3);
  picture.faces = ball.faces;
  for (const auto* cell : all<GoldenCell>(golden.data)) {
    const auto& of = values[cell->path];
    if (!of.contains("volume") || !of.contains("x") || !of.contains("y") || !of.contains("z")) continue;
    const double radius = std::cbrt(of.at("volume") / measureVolume(ball.vertices, ball.faces));
    CellShape shape{cell->path.text(), {}, palette.colourOf(cell->path, cell->state.text)};
    for (const Point& p : ball.vertices)
      shape.vertices.push_back(Point{of.at("x"), of.at("y"), of.at("z")} + radius * p);
    picture.cells.push_back(std::move(shape));
  }
  picture.caption = counted(picture.cells.size(), "cell");
  return picture;
}

}  // namespace

Drawing BesideGolden::sheet() const {
  if (source == Source::none) return contactSheet({images.other}, 1, 8, notes);
  return comparisonSheet(images, notes);
}

BesideGolden drawBesideGolden(const Scenario& scenario, const World& world, const Golden& golden, const Execution& how,
                              bool quiet) {
  BesideGolden result;
  OrganismPicture now = pictureOf(world, scenario);
  now.width = now.height = side;
  const auto alone = [&](const std::string& why) {
    now.legend.clear();
    result.images.other = drawOrganism(now);
    result.notes = {why};
    return result;
  };
  if (stateHash(world).text() == acceptedBits(golden))
    return alone("The final state equals the golden's bit for bit, so no place and no shape differs.");
  MadeAgain again = makeAgain(scenario, golden, how, quiet);
  OrganismPicture before;
  if (again.picture) {
    result.source = BesideGolden::Source::again;
    before = std::move(*again.picture);
    result.notes = {
        "Golden: the accepted state, from its scenario run again, bit for bit. Colours of the third picture: "
        "distance of each present vertex from the same cell's surface in the golden."};
  } else {
    before = spheresOf(golden, scenario);
    if (before.cells.empty())
      return alone("The golden's organism cannot be shown: " + again.whyNot +
                   ", and the golden holds no places of cells.");
    result.source = BesideGolden::Source::centres;
    before.shell = now.shell, before.shellPlanes = now.shellPlanes;
    result.notes = {
        "Golden: spheres with the accepted volumes at the accepted places. Its shapes cannot be made again: " +
            again.whyNot + ".",
        "Colours of the third picture, and arrows where they are long enough: displacement of each cell's centroid."};
  }
  before.width = before.height = side;
  before.title = scenario.scene.name + ": golden";
  now.title = scenario.scene.name + ": now";
  result.images =
      compareOrganisms(std::move(before), std::move(now), scenario.scene.mechanics->physics.cell.radius,
                       {.ofOther = true, .ofCentres = !again.picture, .named = [&](const std::string& words) {
                          return withNames(words, scenario.names.function());
                        }});
  return result;
}

std::optional<BesideGolden> drawBesideGoldenFile(const Scenario& scenario, const World& now, const Execution& how,
                                                 bool quiet) {
  const auto file = goldenFile(scenario);
  if (!now.bodies || !fileExists(file)) return std::nullopt;
  try {
    return drawBesideGolden(scenario, now, readAccepted(scenario, file), how, quiet);
  } catch (const InputError&) { return std::nullopt; }
}

}  // namespace morula
