// The part of the playground's module beside the simulator's (core/wasm/module.cpp): scenarios as people write them,
// their costs, and the picture of a run while it goes on. JSON goes in and out.
#include "wasm/module.h"

#include <algorithm>

#include "base/floating_point.h"
#include "observation/measures.h"
#include "physics/integrator.h"
#include "scenario/scenario.h"
#include "simulation/genes_alone.h"
#include "simulation/memory.h"
#include "simulation/settle.h"
#include "system/json.h"
#include "values/measure_list.h"

namespace morula::module {
namespace {

constexpr double memoryLimit = 1.5e9;      // [byte] limit of a run: browsers have less memory than programs
constexpr std::size_t maxCells = 4096;     // max cells to which a lineage is followed beforehand

std::optional<Scenario> scenario;
std::size_t entriesTold = 0;

/// Estimates how many steps of how many vertices a run will take. Its lineage runs beforehand without bodies, which
/// takes no time. Genes that sense bodies may make more or fewer cells.
Json costOf(const Scenario& of) {
  Scene lineage = of.scene;
  const bool hasBodies = lineage.mechanics.has_value();
  const double vertices = hasBodies ? double(lineage.mechanics->mesh.vertices.size()) : 0;
  const bool settles = hasBodies && kindOf(lineage.mechanics->physics.integrator).settles;
  double timeStep = 0, vertexSteps = 0, before = 0;
  if (hasBodies) {
    Execution execution;
    execution.memoryLimit = memoryLimit;
    timeStep =
        settles ? 1 / evaluationsPerTime(of.scene, int(vertices)) : makeWorld(of.scene, execution).clock.timeStep;
    lineage = genesAlone(std::move(lineage));
    lineage.senses.clear();
  }
  World world = makeWorld(lineage);
  std::size_t cells = world.cells.path.size();
  while (!finished(world) && world.cells.path.size() <= maxCells) {
    cells = world.cells.path.size();
    step(world);
    if (timeStep > 0) vertexSteps += (world.clock.time - before) / timeStep * double(cells) * vertices;
    before = world.clock.time;
  }
  cells = std::max(cells, world.cells.path.size());
  return {{"cells", cells},
          {"isMore", cells > maxCells},
          {"vertexSteps", vertexSteps},
          {"steps", timeStep > 0 ? before / timeStep
                                 : double(world.clock.step)},
          {"memory", predictMemory(of.scene, 2.0 * double(cells), vertices * double(cells))}};
}

Json flat(const std::vector<Point>& points) {
  Json all = Json::array();
  for (const Point& p : points) all.insert(all.end(), {p.x, p.y, p.z});
  return all;
}
Json flat(const std::vector<Face>& faces) {
  Json all = Json::array();
  for (const Face& f : faces) all.insert(all.end(), {f[0], f[1], f[2]});
  return all;
}

Json shellOf(const Scene& scene) {
  if (!scene.mechanics || !scene.mechanics->physics.shell) return {};
  const auto& shell = *scene.mechanics->physics.shell;
  if (shell.mesh) return {{"vertices", flat(shell.mesh->mesh.vertices)}, {"faces", flat(shell.mesh->mesh.faces)}};
  return {{"axes", {shell.semiAxes[0], shell.semiAxes[1], shell.semiAxes[2]}}};
}

}  // namespace

/// Reads {name, text, files: [[role, path, content]…]}. Answers with main values, or all mistakes, one a line.
MORULA_EXPORT(readScenario) int read() {
  return outcomeOf([] {
    setFloatingPoint();
    scenario.reset();
    const Json asked = Json::parse(given);
    std::vector<NamedFile> files;
    for (const Json& file : asked["files"]) files.push_back({file[0], file[1], file[2]});
    Scenario read = readScenario(asked["text"], asked["name"], "", {}, files);
    const Json cost = [&] {  // errors of makeWorld name no line
      try {
        return costOf(read);
      } catch (const InputError& error) { throw InputError(read.file + ": " + error.what()); }
    }();
    const auto end = plannedEnd(read.scene);
    Json colours = Json::object();
    for (const auto& [substance, colour] : read.colours) colours[substance] = colour;
    Json cellColours = Json::object();
    for (const CellColour& one : read.cellColours) cellColours[one.text] = one.colour;
    const Json told{{"name", read.scene.name},
                    {"seed", read.scene.seed},
                    {"summary", read.summary},
                    {"genes", read.scene.dna.genes.size()},
                    {"warnings", read.warnings},
                    {"hasBodies", read.scene.mechanics.has_value()},
                    {"end", end ? Json(*end) : Json()},
                    {"radius", read.scene.mechanics ? read.scene.mechanics->physics.cell.radius : 1},
                    {"shell", shellOf(read.scene)},
                    {"colours", colours},
                    {"cellColours", cellColours},
                    {"cost", cost}};
    said = jsonText(told);
    scenario = std::move(read);
  });
}

/// Makes the world of the scenario that was read.
MORULA_EXPORT(beginScenario) int beginScenario() {
  return outcomeOf([] {
    setFloatingPoint();
    entriesTold = 0;
    begin(scenario.value().scene, memoryLimit);
  });
}

/// Answers with living cells, measures and contacts, and with all cells ever if one was born since the last snapshot.
MORULA_EXPORT(snapshot) int snapshot() {
  return outcomeOf([] {
    const Observation now(*world);
    Json told{{"time", world->clock.time}, {"step", world->clock.step}};
    const auto& entries = world->lineage.entries;
    if (entriesTold != entries.size() || finished(*world)) {
      entriesTold = entries.size();
      for (const LineageEntry& cell : entries) {
        const auto called = scenario->names.of(cell.path);
        const CellColour* own = cellColourOf(*scenario, cell.path);
        told["lineage"].push_back({cell.path.text(), called.value_or(""), cell.born,
                                   cell.fate == Fate::alive ? world->clock.time : cell.ended, name(cell.fate),
                                   world->biology->describe(cell.state), own ? own->colour : ""});
      }
    }
    const auto measured = measureCells(now);
    for (std::size_t i = 0; i < world->cells.path.size(); ++i) {
      Json values = Json::array();
      if (!measured.empty())
        for (const auto& value : measured[i].values) values.push_back(value ? Json(*value) : Json());
      told["cells"].push_back({world->cells.entry[i], world->biology->describe(world->cells.state[i]), values,
                               cellVertices(*world, world->cells.path[i]).size()});
    }
    for (const ContactArea& c : now.contacts()) told["contacts"].push_back({c.a, c.b, c.area});
    for (const auto& value : measureWorld(now).values) told["world"].push_back(value ? Json(*value) : Json());
    said = jsonText(told);
  });
}

/// Answers with the faces of a living cell's surface.
MORULA_EXPORT(facesOf) int facesOf(std::size_t cell) {
  return outcomeOf([&] { said = jsonText(flat(cellMesh(*world, world->cells.path.at(cell)).faces)); });
}

/// Answers with the names of the measures in snapshots, and the units in which people see them.
MORULA_EXPORT(measureNames) int measureNames() {
  return outcomeOf([] {
    Json names{
        {"cell", Json::array()}, {"world", Json::array()}, {"units", shownUnits(scenario ? scenario->units : Units{})}};
    for (const CellMeasure& m : sampledMeasures<CellContext>()) names["cell"].push_back(m.name);
    for (const WorldMeasure& m : sampledMeasures<Observation>()) names["world"].push_back(m.name);
    said = jsonText(names);
  });
}

}  // namespace morula::module
