// Values of a scenario arrive in the structs, and omitted keys have the structs' defaults.
#include <numbers>

#include "helpers.h"
#include "mesh/mesh_measures.h"
#include "state/scene_parts.h"

using namespace morula;
using namespace morula::test;

TEST_CASE("every key arrives in its field") {
  const auto s = read(everyPart);
  CHECK(s.summary == "All keys at once");
  CHECK(s.colours == std::map<std::string, std::string>{{"a*", "#abcdef"}, {"a0", "#102030"}});
  CHECK(s.record.every == 0.25);
  CHECK(s.record.pictures == 0.5);
  CHECK(s.record.meshes == 0.75);
  CHECK(s.record.atCells == std::vector<std::uint64_t>{2, 3});
  CHECK(s.record.measures == std::vector<std::string>{"contact_f1", "position_rmsd"});
  CHECK(s.names.given.size() == 2);
  CHECK(s.names.daughters == std::vector<std::string>{"l", "r"});
  CHECK(s.shellFill == 0.020833333333333332);
  CHECK_FALSE(s.eggIsStretched);
  const auto& scene = s.scene;
  CHECK(scene.name == "every-part");
  CHECK(scene.seed == 7);
  CHECK(scene.dna.genes.size() == 2);
  CHECK(scene.cycle.length == 2);
  CHECK(scene.cycle.perSubstance == std::map<std::string, double>{{"a0", 1.5}});
  CHECK(scene.cycle.atBirth == std::map<std::string, double>{{"a0", 1.25}});
  REQUIRE(scene.cycle.divisionSize);
  CHECK(scene.cycle.divisionSize->rule == DivisionSize::Rule::adder);
  CHECK(scene.cycle.divisionSize->size == 0.25);
  CHECK(scene.stop.cycles == 3u);
  CHECK(scene.stop.time == 9.5);
  CHECK(scene.stop.cells == 4u);
  REQUIRE(scene.mechanics);
  const auto& physics = scene.mechanics->physics;
  CHECK(physics.timeStep == 0.001953125);
  CHECK(physics.integrator == Integrator::thesisVerlet);
  CHECK(physics.drag == 0.25);
  CHECK(physics.cell.radius == 0.5);
  CHECK(physics.cell.mass == 2);
  CHECK(physics.membrane.stiffness == 41);
  CHECK(physics.membrane.damping == 0.5);
  CHECK(physics.membrane.areaFactor == 1.2);
  CHECK(physics.membrane.springs == Springs::dual);
  CHECK(physics.pressure.constant == 5);
  CHECK(physics.pressure.outside == 1.25);
  REQUIRE(physics.growth);
  CHECK(physics.growth->rate == 0.2);
  CHECK(physics.growth->until == 1.5);
  REQUIRE(physics.shell);
  CHECK(physics.shell->semiAxes[0] == 3);
  CHECK(physics.shell->semiAxes[1] == 2);
  CHECK(physics.shell->semiAxes[2] == 1);
  CHECK(physics.shell->holds == Held::surface);
  REQUIRE(scene.mechanics->contact);
  CHECK(scene.mechanics->contact->law == ContactLaw::thesis);
  CHECK(scene.mechanics->contact->stiffness == 30);
  CHECK(scene.mechanics->contact->damping == 0.1);
  CHECK(scene.mechanics->contact->viscosity == 0.3);
  CHECK(scene.mechanics->contact->slipSpeed == 0.02);
  CHECK(scene.mechanics->contact->radius == 1.1);
  CHECK(scene.mechanics->division.otherwise.plane == DivisionPlane::axis);
  CHECK(scene.mechanics->division.otherwise.axis == Vector{0, 1, -1});
  const auto& rules = scene.mechanics->division.rules;
  REQUIRE(rules.size() == 2);
  CHECK(rules[0].of == std::vector<std::string>{"a1", "divide"});
  CHECK(rules[0].plane == PlaneChoice{DivisionPlane::axis, {1, 0, 2}});
  CHECK((rules[0].share == 0.4 && rules[0].tilt == 10.0));
  CHECK(rules[1].of == std::vector<std::string>{"a1"});
  CHECK(rules[1].plane == PlaneChoice{DivisionPlane::random});
  CHECK((!rules[1].share && !rules[1].tilt));
  CHECK(scene.variation == VariationParameters{0.1, 0.05, 0.125, 5});
  REQUIRE(scene.mechanics->connections);
  CHECK(scene.mechanics->connections->make == MakeConnections::byGene);
  CHECK(scene.mechanics->connections->onDivision == ConnectionsOnDivision::both);
  CHECK(scene.mechanics->connections->strength == 0.4);
  CHECK(scene.mechanics->connections->releaseDistance == 1.5);
  CHECK(scene.mechanics->connections->releaseAge == 4);
  CHECK(scene.mechanics->connections->most == 3);
  REQUIRE(scene.cells.size() == 2);
  CHECK(scene.cells[0].at == Point{0.4, 0, 0.25});
  CHECK(scene.cells[0].velocity == Vector{0, 2, 0});
  CHECK(scene.cells[0].scale == 0.5);
  CHECK(scene.cells[0].stretch == Vector{1, 2, 1});
  CHECK(scene.cells[0].mass == 3.0);
  CHECK(scene.cells[0].substances == std::vector<std::string>{"A", "a0"});
  CHECK(scene.cells[1].at == Point{-0.4, 0, 0});
  CHECK(scene.cells[1].scale == 1);
  CHECK(scene.cells[1].stretch == Vector{1, 1, 1});
  CHECK((!scene.cells[1].mass && !scene.cells[1].substances));
  CHECK((s.check.volume->least == 0.5 && s.check.volume->most == 2));
  CHECK(s.check.extent == 9.0);
  CHECK(s.check.energy == 100.0);
  CHECK(s.check.momentum == 0.5);
  CHECK((s.check.endVolume->least == 0.9 && s.check.endVolume->most == 1.1));
  CHECK(s.check.endRoundness == 0.75);
  CHECK(s.check.endOverlap == 0.125);
  CHECK(s.check.fails == std::vector<std::string>{"springs", "physics.time_step"});
  CHECK((!s.check.sane && s.check.because == "it stops"));
  const auto cell = [](const char* path) { return CellPath::parse(path); };
  REQUIRE(s.check.reference);
  CHECK(s.check.reference->contacts ==
        std::set<std::pair<CellPath, CellPath>>{{cell("A"), cell("B")}, {cell("AA"), cell("AB")}});
  CHECK(s.check.reference->positions ==
        std::map<CellPath, Point>{{cell("A"), {1, 0, 0}}, {cell("AB"), {0, 2, 0}}, {cell("B"), {-1, 0, 0}}});
  // The mesh has the volume of a sphere with the cell's radius, so its vertices lie farther out, all equally.
  REQUIRE(scene.mechanics->mesh.vertices.size() == 642);
  REQUIRE(scene.mechanics->coarser.size() == 1);
  CHECK(scene.mechanics->coarser[0].vertices.size() == 162);
  CHECK(scene.mechanics->physics.coarsen == 0.5);
  const Mesh& mesh = scene.mechanics->mesh;
  CHECK(measureVolume(mesh.vertices, mesh.faces) == Approx(4 * std::numbers::pi / 3 / 8).epsilon(1e-14));
  const double farthest = norm(mesh.vertices[0]);
  CHECK(farthest > 0.501);
  for (const auto& v : mesh.vertices) CHECK(norm(v) == Approx(farthest).epsilon(1e-15));
}

TEST_CASE("what is not said has the defaults of the structs") {
  const auto s = read(small + "physics: {shell: {sphere: 1}, contact: {}, growth: {}}\nconnections: {}\n");
  Scene usual;
  usual.dna = s.scene.dna;
  MechanicsScene& m = usual.mechanics.emplace();
  m.mesh = s.scene.mechanics->mesh;
  m.physics.shell = ShellParameters{{1, 1, 1}};
  m.physics.growth.emplace();
  m.contact.emplace();
  m.connections.emplace();
  const auto parts = hashSceneParts(s.scene), expected = hashSceneParts(usual);
  REQUIRE(parts.size() == expected.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    INFO(parts[i].name);
    CHECK(parts[i].hash == expected[i].hash);
  }
  CHECK(s.scene.variation == VariationParameters{});
  CHECK(m.mesh.vertices.size() == 162);
  CHECK(!s.record.every);
  CHECK(!s.record.meshes);
}

TEST_CASE("a share of automatic time steps is part of what a scenario means, and all of it is not") {
  const std::string text =
      "morula: 1\nname: one\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 1}\nphysics: {time_step: ";
  const Scenario all = readScenario(text + "auto}\n", "x.yaml", ".");
  const Scenario half = readScenario(text + "{auto: 0.5}}\n", "x.yaml", ".");
  CHECK_FALSE(half.scene.mechanics->physics.timeStep);
  CHECK(half.scene.mechanics->physics.autoShare == 0.5);
  CHECK(half.resolved.find("\"auto\"") != std::string::npos);
  CHECK(half.meaning.text() != all.meaning.text());
  CHECK(readScenario(text + "{auto: 1}}\n", "x.yaml", ".").meaning.text() == all.meaning.text());
  const Scenario set = readScenario(text + "0.01}\n", "x.yaml", ".", {parseOverride("physics.time_step.auto=0.5")});
  CHECK(set.meaning.text() == half.meaning.text());
}

TEST_CASE("parts that are not named do not exist") {
  CHECK(!read(small).scene.mechanics);
  const auto t = read(small + "physics: {}\n");
  CHECK(!t.scene.mechanics->contact);
  CHECK(!t.scene.mechanics->connections);
  CHECK(!t.scene.mechanics->physics.shell);
  CHECK(!t.scene.mechanics->physics.growth);
  CHECK(t.scene.cells.empty());
  CHECK((!t.check.volume && !t.check.energy && t.check.fails.empty() && t.check.sane));
}

TEST_CASE("CRLF, a byte order mark and a document marker are no mistakes") {
  auto text = "\xEF\xBB\xBF---\n" + everyPart;
  std::string crlf;
  for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  CHECK(read(crlf).meaning == read(everyPart).meaning);
}

TEST_CASE("colours: a name before patterns, a longer pattern before a shorter one") {
  Scenario s;
  s.colours = {{"AB*", "#000001"}, {"ABa*", "#000002"}, {"ABab", "#000003"}, {"*", "#000004"}};
  CHECK(colourOf(s, "ABab") == "#000003");
  CHECK(colourOf(s, "ABaa") == "#000002");
  CHECK(colourOf(s, "AB") == "#000001");
  CHECK(colourOf(s, "P0") == "#000004");
  s.colours.erase("*");
  CHECK(!colourOf(s, "P0"));
}

TEST_CASE("colours of cells: her own, else that of the smallest clone, else that of her generation") {
  const std::string text = "morula: 1\nname: x\ndna: \"START: a0\\ng1(a1|a0)\"\nstop: {cells: 1}\n"
                           "names: {daughters: [a, p], cells: {A: AB, B: P1}}\n"
                           "colours: {a0: '#000001', 'cell ABa': '#000002', clone AB: '#000003', 'path ABB*': '#000004', "
                           "generation 1: '#000005', substance a1: '#000006'}\n";
  const Scenario s = read(text);
  const auto colour = [&](const char* path) {
    const CellColour* found = cellColourOf(s, CellPath::parse(path));
    return found ? found->colour : "none";
  };
  CHECK(colour("AA") == "#000002");
  CHECK(colour("AAB") == "#000003");
  CHECK(colour("ABBA") == "#000004");  // of the smaller clone, which is ABp's daughter
  CHECK(colour("A") == "#000003");     // a clone before a generation
  CHECK(colour("B") == "#000005");
  CHECK(colour("BA") == "none");
  CHECK(s.colours == std::map<std::string, std::string>{{"a0", "#000001"}, {"a1", "#000006"}});
  const Scenario again = read(s.resolved);
  CHECK(again.cellColours.size() == s.cellColours.size());
  CHECK(again.meaning == s.meaning);
  CHECK_THAT(complaints(replaced(text, "clone AB:", "clone ABx:")), Catch::Contains("no cell is called 'ABx'"));
  CHECK_THAT(complaints(replaced(text, "generation 1", "genration 1")), Catch::Contains("did you mean generation 1?"));
}
