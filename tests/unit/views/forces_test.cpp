// Forces on vertices by kind: together they are the forces that move the cells.
#include <cmath>

#include "base/error.h"
#include "catch.h"
#include "diagnose/vertex_forces.h"
#include "drawing/palette.h"
#include "observation/measures.h"
#include "pictures/pictures.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"
#include "state/state_hash.h"
#include "views/picture_maker.h"

namespace morula {

namespace {

Scenario scenario(const std::string& physics) {
  return readScenario(
      "morula: 1\nname: forces\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 2.5}\nphysics: " + physics + "\n",
      "forces.yaml", "");
}

/// Returns the scene's world at `time`: two cells, some time after a division.
World worldOf(const Scenario& scenario, double time) {
  World world = makeWorld(scenario.scene);
  while (world.clock.time < time) step(world);
  return world;
}

const std::string squeezed = "{mesh: {icosphere: 1}, cell: {radius: 0.95}, shell: {sphere: 1}, contact: {}, drag: 1}";

}  // namespace

TEST_CASE("the kinds of forces add up to mass times acceleration, and nothing is left unnamed", "[forces]") {
  for (const std::string& physics :
       {squeezed,
        std::string("{mesh: {icosphere: 1}, cell: {radius: 0.85}, shell: {ellipsoid: [1.2, 0.9, 0.9]}, "
                    "contact: {}, drag: 0}"),
        std::string("{mesh: {icosphere: 1}, contact: {adhesion: {default: 0.5}}, drag: 0}")}) {
    CAPTURE(physics);
    const Scenario s = scenario(physics);
    World world = worldOf(s, 1.3);
    const auto forces = forcesByKind(world);
    REQUIRE(forces.size() == world.cells.path.size());
    const Bodies& bodies = *world.bodies;
    const bool dragged = bodies.parameters.drag > 0;
    for (std::size_t cell = 0; cell < forces.size(); ++cell) {
      const int slot = bodies.slots[cell];
      Vector net, sum;
      double most = 0, unnamed = 0, borne = 0;
      for (int v = 0; v < bodies.vertexCount(slot); ++v) {
        const Vector whole = bodies.vertexMass[slot] * bodies.read(bodies.acceleration, slot, v);
        Vector all;
        for (const auto& kind : forces[cell]) all += kind[v], most = std::max(most, norm(kind[v]));
        net += whole, sum += all;
        unnamed = std::max(unnamed, norm(forces[cell][std::size_t(ForceKind::other)][v]));
        borne += norm(forces[cell][std::size_t(ForceKind::shell)][v]);
        CHECK(norm(all - whole) <= 1e-12 * most);
      }
      // The kernels sum some hundred terms in another order, so rounding differs.
      CHECK(norm(sum - net) <= 1e-10 * most);
      if (!dragged) CHECK(unnamed <= 1e-10 * most);
      if (bodies.parameters.shell) CHECK(borne > 0);
    }
  }
}

TEST_CASE("springs and contents of a closed cell have no net force, and contacts are equal and opposite", "[forces]") {
  const Scenario s = scenario(squeezed);
  World world = worldOf(s, 1.3);
  const auto forces = forcesByKind(world);
  Vector contact;
  double most = 0;
  for (const auto& cell : forces) {
    for (const ForceKind kind : {ForceKind::spring, ForceKind::pressure}) {
      Vector net;
      double largest = 0;
      for (const Vector& f : cell[std::size_t(kind)]) net += f, largest = std::max(largest, norm(f));
      CHECK(largest > 0);
      CHECK(norm(net) <= 1e-12 * 100 * largest);  // 42 vertices
    }
    for (const Vector& f : cell[std::size_t(ForceKind::contact)]) contact += f, most = std::max(most, norm(f));
  }
  CHECK(most > 0);
  CHECK(norm(contact) <= 1e-10 * most);
}

TEST_CASE("the arrows of a cell add up to its net force", "[forces]") {
  const Scenario s = scenario(squeezed);
  World world = worldOf(s, 1.3);
  PictureWishes wishes;
  const auto kinds = valuesOf<ForceKind>();
  wishes.forces = {kinds.begin(), kinds.end()};
  PictureMaker maker(s, wishes);
  maker.add(world);
  const OrganismPicture picture = maker.take()[0];
  forcesByKind(world);  // brings the accelerations to the end of the step
  REQUIRE(picture.instruments.arrowKey);
  const double scale = picture.instruments.arrowKey->lengthPerUnit;
  const Bodies& bodies = *world.bodies;
  std::size_t arrows = 0;
  double longest = 0;
  for (std::size_t cell = 0; cell < world.cells.path.size(); ++cell) {
    const int slot = bodies.slots[cell];
    Vector net, drawn;
    double most = 0;
    for (int v = 0; v < bodies.vertexCount(slot); ++v)
      net += bodies.vertexMass[slot] * bodies.read(bodies.acceleration, slot, v);
    for (const LineMark& line : picture.lines)
      for (const Point& vertex : picture.cells[cell].vertices)
        if (line.from == vertex) {
          drawn += (line.to - line.from) / scale, ++arrows;
          most = std::max(most, norm(line.to - line.from) / scale);
          longest = std::max(longest, norm(line.to - line.from));
          CHECK(line.arrow);
        }
    CHECK(norm(drawn - net) <= 1e-9 * most);
  }
  CHECK(arrows == picture.lines.size());
  CHECK(longest < 1);
  CHECK(picture.legend.size() < kinds.size());  // no cells stick together in this scene
}

TEST_CASE("pictures of several times have their forces on one scale, and looking at them changes nothing", "[forces]") {
  const Scenario s = scenario(squeezed);
  World world = makeWorld(s.scene), unseen = makeWorld(s.scene);
  PictureWishes wishes;
  wishes.forces = {ForceKind::contact, ForceKind::shell, ForceKind::adhesion};
  PictureMaker maker(s, wishes);
  std::vector<std::vector<ForcesByKind>> expected;
  for (int frame = 0; frame < 4; ++frame) {
    maker.add(world);
    World scratch = makeWorld(s.scene);
    expected.push_back(forcesByKind(world, scratch));
    for (const double until = 0.5 * (frame + 1); world.clock.time < until;) step(world), step(unseen);
  }
  CHECK(stateHash(world) == stateHash(unseen));
  const Pictures pictures = maker.take();
  REQUIRE(pictures.size() == 4);
  const double scale = pictures[0].instruments.arrowKey->lengthPerUnit;
  double most = 0, longest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const OrganismPicture picture = pictures[i];
    CHECK(picture.instruments.arrowKey->lengthPerUnit == scale);
    CHECK(picture.legend.size() == pictures[0].legend.size());
    CHECK(picture.camera.framing->distance == pictures[0].camera.framing->distance);
    Vector drawn, sum;
    for (const LineMark& line : picture.lines)
      drawn += (line.to - line.from) / scale, longest = std::max(longest, norm(line.to - line.from));
    for (const ForcesByKind& cell : expected[i])
      for (const ForceKind kind : wishes.forces)
        for (const Vector& f : cell[std::size_t(kind)]) sum += f, most = std::max(most, norm(f));
    CHECK(norm(drawn - sum) <= 1e-9 * most);
  }
  CHECK(longest == Approx(scale * most));
  CHECK(longest < 0.8 * 0.95);  // an arrow is at most 0.8 mean radii long
  std::vector<std::string> words;
  for (const LegendEntry& entry : pictures[0].legend) words.push_back(entry.label);
  CHECK(words == std::vector<std::string>{"contact force", "shell force"});  // no cells stick together
}

TEST_CASE("an integrator without forces between its steps says so", "[forces]") {
  const Scenario s = scenario("{mesh: {icosphere: 1}, integrator: xpbd, time_step: 0.01}");
  World world = worldOf(s, 0.1);
  CHECK_THROWS_WITH(forcesByKind(world), ContainsSubstring("xpbd") && ContainsSubstring("velocity-verlet"));
  PictureWishes wishes;
  wishes.forces = {ForceKind::spring};
  CHECK_THROWS_AS(PictureMaker(s, wishes), InputError);
}

TEST_CASE("cells are coloured by measures, generations and clones, and the bar's ends are the data's", "[colours]") {
  const Scenario s = scenario(squeezed);
  const World world = worldOf(s, 2.2);
  REQUIRE(world.cells.path.size() == 2);
  const auto pictureBy = [&](const char* what) {
    PictureWishes wishes;
    wishes.colouring = parseColouring(what);
    PictureMaker maker(s, wishes);
    maker.add(world);
    return maker.take()[0];
  };
  const OrganismPicture volume = pictureBy("volume");
  REQUIRE(volume.instruments.colourBar);
  double low = INFINITY, high = -INFINITY;
  for (const CellMeasures& cell : measureCells(world))
    low = std::min(low, cell.at("volume")), high = std::max(high, cell.at("volume"));
  CHECK(volume.instruments.colourBar->low == low);
  CHECK(volume.instruments.colourBar->high == Approx(high).epsilon(1e-9));  // up to rounding
  CHECK(volume.instruments.colourBar->title == "volume [length³]");
  CHECK(pictureBy("volume_over_rest").instruments.colourBar);
  const OrganismPicture generation = pictureBy("generation");
  CHECK(generation.legend.size() == 1);
  CHECK(generation.legend[0].label == "generation 1");
  const OrganismPicture clones = pictureBy("clone:1");
  REQUIRE(clones.legend.size() == 2);
  CHECK(clones.legend[0].label == "A");
  CHECK(clones.legend[1].label == "B");
  CHECK(clones.cells[0].colour == clones.legend[0].colour);
  CHECK(clones.cells[1].colour == clones.legend[1].colour);
  CHECK(clones.cells[0].colour == cloneColour("A"));
  for (const char* same : {"cell.volume", "volume-over-rest", "cell.volume_over_rest"})
    CHECK(pictureBy(same).instruments.colourBar);
  for (const char* wrong : {"volum", "clone:0", "clone:5", "clone:", "", "world.volume", "cell.cells", "pair.area"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(parseColouring(wrong), InputError);
  }
  CHECK_THROWS_WITH(parseColouring("volum"), ContainsSubstring("did you mean volume?"));
}

TEST_CASE("a film shows in each picture what is in it, and keeps room for the rest; mixtures are called so",
          "[colours]") {
  Scenario s = scenario(squeezed);
  PictureWishes wishes;
  wishes.colouring = parseColouring("clone");
  PictureMaker maker(s, wishes);
  maker.add(worldOf(s, 0));
  maker.add(worldOf(s, 2.2));
  const Pictures film = maker.take();
  const auto shownIn = [&](std::size_t i) {
    std::vector<std::string> labels;
    for (const LegendEntry& entry : film[i].legend)
      if (entry.shown) labels.push_back(entry.label);
    return labels;
  };
  CHECK(shownIn(0) == std::vector<std::string>{"egg"});
  CHECK(shownIn(1) == std::vector<std::string>{"A", "B"});
  CHECK(film[0].legend.size() == film[1].legend.size());

  s.colours = {{"a", "#ff0000"}, {"b*", "#0000ff"}};
  Palette palette(s);
  const Colour mauve = palette.colourOf("a b1 other");
  REQUIRE(palette.legend().size() == 1);  // neither red nor blue is seen
  CHECK(palette.legend()[0].label == "a + b*");
  CHECK(palette.legend()[0].colour == mauve);
  palette.colourOf("a");
  CHECK(palette.legend().size() == 2);
  s.cellColours = {{{.kind = CellSelection::Kind::clone, .path = CellPath::parse("A")}, "clone AB", "#00ff00"}};
  CHECK(palette.colourOf(CellPath::parse("AB"), "a") == parseColour("#00ff00"));
  CHECK(palette.colourOf(CellPath::parse("B"), "a") == parseColour("#ff0000"));
  REQUIRE(palette.legend().size() == 3);
  CHECK(palette.legend()[2].label == "clone AB");
}

}  // namespace morula
