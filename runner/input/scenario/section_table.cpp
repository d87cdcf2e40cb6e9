// Every section of a scenario: a map of parameters, and what makes and shows the part that it describes.
#include "physics/cell_model.h"
#include "physics/integrator.h"
#include "scenario/parameter_table.h"
#include "values/value_types.h"

namespace morula::scenario {
namespace {

bool hasMembrane(const Scenario& s) {
  return s.scene.mechanics && kindOf(s.scene.mechanics->physics.cell.model).hasMembrane;
}

bool hasRestShape(const Scenario& s) {
  return s.scene.mechanics && kindOf(s.scene.mechanics->physics.cell.model).hasRestShape;
}

bool hasSettling(const Scenario& s) {
  return s.scene.mechanics && kindOf(s.scene.mechanics->physics.integrator).settles;
}

/// Makes the mechanics, also if the scenario's `physics` could not be read, which has been reported.
void makeMechanics(Scenario& s) {
  if (!s.scene.mechanics) s.scene.mechanics.emplace();
}

}  // namespace

std::vector<Section> sections() {
  using enum Section::Members;
  return {
      {.path = "", .meaning = "A scenario: an organism, how it grows, and how it is shown"},
      {.path = "cycle", .meaning = "The pace of biology"},
      {.path = "stop", .meaning = "The run ends at the first of these limits", .required = true, .members = atLeastOne},
      {.path = "physics",
       .meaning = "The mechanics of cells. Units are the scene's own: a length, a mass, a time",
       .absent = "lineage only: cells have no bodies",
       .make = makeMechanics,
       .exists = [](const Scenario& s) { return s.scene.mechanics.has_value(); }},
      {.path = "physics.mesh",
       .meaning = "The egg's surface; without coarsen every cell keeps its connectivity",
       .members = exactlyOne,
       .make =
           [](Scenario& s) {
             s.mesh = {std::nullopt, std::nullopt};
           }},
      {.path = "physics.cell", .meaning = "The egg; each division halves volume and mass"},
      {.path = "physics.membrane",
       .meaning = "With cell.model shell: every mesh edge is a damped spring [Nilsson 2008, eq. 4.2]",
       .exists = hasMembrane},
      {.path = "physics.pressure",
       .meaning = "With cell.model shell: P = constant / V − outside [Nilsson 2008, eq. 4.3]",
       .exists = hasMembrane},
      {.path = "physics.shape-matching",
       .meaning = "With cell.model shape-matching: every vertex is drawn to its place in the shape at rest "
                  "[Müller et al. 2005]",
       .exists = hasRestShape},
      {.path = "physics.growth",
       .meaning = "What cells do while their genes produce grow or shrink",
       .absent = "cells keep their size",
       .make = [](Scenario& s) { s.scene.mechanics->physics.growth.emplace(); },
       .exists = [](const Scenario& s) { return s.scene.mechanics->physics.growth.has_value(); }},
      {.path = "physics.shell",
       .meaning = "The egg shell, which no cell leaves",
       .absent = "no shell",
       .members = exactlyOne,
       .make = [](Scenario& s) { s.scene.mechanics->physics.shell.emplace(); },
       .exists = [](const Scenario& s) { return s.scene.mechanics->physics.shell.has_value(); }},
      {.path = "physics.motility",
       .meaning = "Cells crawl through the medium, each its own way, which turns now and then as the seed says; "
                  "needs physics.drag",
       .absent = "cells do not move on their own",
       .later = true,
       .make = [](Scenario& s) { s.scene.mechanics->physics.motility.emplace(); },
       .exists = [](const Scenario& s) { return s.scene.mechanics->physics.motility.has_value(); }},
      {.path = "physics.settle",
       .meaning = "With integrator fire: how near to equilibrium cells come after each event",
       .later = true,
       .exists = hasSettling},
      {.path = "physics.contact",
       .meaning = "How cells touch",
       .absent = "cells pass through one another",
       .make = [](Scenario& s) { s.scene.mechanics->contact.emplace(); },
       .exists = [](const Scenario& s) { return s.scene.mechanics->contact.has_value(); }},
      {.path = "division",
       .meaning = "Where cells divide",
       .needs = "physics",
       .make = makeMechanics,
       .exists = [](const Scenario& s) { return s.scene.mechanics.has_value(); }},
      {.path = "division.chirality",
       .meaning = "Both daughters turn about the division axis, against each other and with the medium around them; "
                  "needs physics.drag",
       .absent = "daughters do not turn",
       .make = [](Scenario& s) { s.scene.mechanics->division.chirality.emplace(); },
       .exists = [](const Scenario& s) { return s.scene.mechanics && s.scene.mechanics->division.chirality; }},
      {.path = "connections",
       .meaning = "Cells that hold on to one another [Nilsson 2008, §4.4.3]",
       .absent = "no cell holds another",
       .needs = "physics",
       .make =
           [](Scenario& s) {
             makeMechanics(s);
             s.scene.mechanics->connections.emplace();
           },
       .exists = [](const Scenario& s) { return s.scene.mechanics && s.scene.mechanics->connections; }},
      {.path = "connections.spring",
       .meaning = "Connections pull and push along the centres, instead of pulling with one strength",
       .absent = "a constant pull",
       .later = true,
       .make = [](Scenario& s) { s.scene.mechanics->connections->spring.emplace(); },
       .exists =
           [](const Scenario& s) {
             return s.scene.mechanics && s.scene.mechanics->connections && s.scene.mechanics->connections->spring;
           }},
      {.path = "variation",
       .meaning = "What a seed changes: standard deviations of normal deviates within 3 of them, each keyed by a "
                  "cell's path, so that it is the same whatever else the scene does",
       .absent = "no two runs differ by it",
       .members = atLeastOne,
       .later = true,
       .exists = [](const Scenario& s) { return s.scene.variation != VariationParameters{}; }},
      {.path = "senses",
       .meaning = "What cells perceive. The keys are substances: at a cell's cycle the simulator inserts one if its "
                  "condition holds, as it inserts A and B, and takes it away if not",
       .entries = senses(),
       .details = sensesAsMarkdown()},
      {.path = "record", .meaning = "What is written down while the scene runs"},
      {.path = "names",
       .meaning = "What people call the cells, in tables, pictures and messages: a cell goes by the name that "
                  "is given for its path, or else by her mother's with a daughter's ending",
       .absent = "cells go by their paths",
       .members = atLeastOne,
       .decides = Decides::presentation,
       .exists = [](const Scenario& s) { return !s.names.empty(); }},
      {.path = "units",
       .meaning = "In which units people see lengths and times: in pictures, charts, pages and sentences. What is "
                  "computed, stored, exported and given to programs stays in the scene's own, and so does all that "
                  "holds a mass or a force",
       .absent = "the scene's own",
       .members = atLeastOne,
       .decides = Decides::presentation,
       .exists = [](const Scenario& s) { return s.units.any(); }},
      {.path = "check",
       .meaning = "What must hold of the run besides its golden file",
       .decides = Decides::presentation},
      {.path = "check.reference",
       .meaning = "What the organism is compared with, by measures that record.measures names",
       .absent = "compared with nothing",
       .members = atLeastOne,
       .decides = Decides::presentation,
       .make = [](Scenario& s) { s.check.reference.emplace(); },
       .exists = [](const Scenario& s) { return s.check.reference.has_value(); }},
      {.path = "check.bullet",
       .meaning = "The same scene computed by Bullet, and how far apart the two may be at the end. Without any "
                  "tolerance: positions 1e-10 radii where nothing touches and the integrator is velocity-verlet or "
                  "thesis-verlet, as Bullet's then is too; where nothing touches otherwise radius and volume, 1e-6 "
                  "with b1, 1e-8 with b3; where cells touch distance 0.01, volume 0.001 and aspect 0.02",
       .absent = "not held against Bullet",
       .decides = Decides::presentation,
       .make = [](Scenario& s) { s.check.bullet.emplace(); },
       .exists = [](const Scenario& s) { return s.check.bullet.has_value(); }},
  };
}

}  // namespace morula::scenario
