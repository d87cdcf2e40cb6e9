// The lineage of a scene without its bodies.
#include "simulation/genes_alone.h"

#include "catch.h"
#include "worlds.h"

using namespace morula;

namespace {

const CellSelection all{.kind = CellSelection::Kind::substance, .substance = "*"};

}  // namespace

TEST_CASE("Genes alone end where bodies decide, and go on to what genes decide") {
  Scene scene = scenes::withBodies("START: a0\nk(a0|a0)\n", 1);
  scene.stop = {};
  scene.stop.when = {{.event = StopEvent::touch, .of = {all, all}}};
  const Scene rest = genesAlone(scene);
  CHECK_FALSE(rest.mechanics);
  const World world = ranToEnd(rest);  // no failure: a run with bodies may end by its condition
  CHECK(world.clock.time == 1000 * scene.cycle.length);

  Scene lineage = scenes::withBodies(scenes::everybodyDivides, 1);
  lineage.stop = {.cycles = {}, .time = {}, .cells = 8};
  lineage.stop.when = {{.event = StopEvent::measure, .measure = "sphericity", .below = 0.1},
                       {.event = StopEvent::cells, .count = 4}};
  CHECK(ranToEnd(genesAlone(lineage)).cells.path.size() == 4);
}

TEST_CASE("Experiments on bodies are left out without them, and those on genes and cells are done") {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 3);
  scene.experiments = {
      {.deed = Deed::set, .name = "physics.drag", .value = 2, .at = 0.5},
      {.deed = Deed::kill, .of = {{.kind = CellSelection::Kind::cell, .path = CellPath::parse("A")}}, .at = 1.5}};
  const World bodies = ranToEnd(scene), genes = ranToEnd(genesAlone(scene));
  CHECK(pathsOf(bodies) == pathsOf(genes));
  CHECK(genes.experiments->size() == 1);
}
