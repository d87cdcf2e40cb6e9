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

bool isQuasiStatic(const Scenario& s) {
  return s.scene.mechanics && s.scene.mechanics->physics.integrator == Integrator::quasiStatic;
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
      {.path = "cycle", .meaning = "Times of cell cycles"},
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
       .meaning = "Growth of cells while their genes produce grow or shrink",
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
       .meaning = "Crawling of cells through the medium, each in its own direction, which changes at random; needs "
                  "physics.drag",
       .absent = "cells do not move on their own",
       .later = true,
       .make = [](Scenario& s) { s.scene.mechanics->physics.motility.emplace(); },
       .exists = [](const Scenario& s) { return s.scene.mechanics->physics.motility.has_value(); }},
      {.path = "physics.quasi-static",
       .meaning = "With integrator quasi-static: the settling of cells after each event",
       .later = true,
       .exists = isQuasiStatic},
      {.path = "physics.contact",
       .meaning = "Contact of cells",
       .absent = "cells pass through one another",
       .make = [](Scenario& s) { s.scene.mechanics->contact.emplace(); },
       .exists = [](const Scenario& s) { return s.scene.mechanics->contact.has_value(); }},
      {.path = "division",
       .meaning = "Planes, shares and sizes of divisions",
       .needs = "physics",
       .make = makeMechanics,
       .exists = [](const Scenario& s) { return s.scene.mechanics.has_value(); }},
      {.path = "division.chirality",
       .meaning = "Turning of both daughters about the division axis, against each other and with the medium around "
                  "them; needs physics.drag",
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
       .meaning = "Springs: connections pull and push along the centres, instead of pulling with one strength",
       .absent = "a constant pull",
       .later = true,
       .make = [](Scenario& s) { s.scene.mechanics->connections->spring.emplace(); },
       .exists =
           [](const Scenario& s) {
             return s.scene.mechanics && s.scene.mechanics->connections && s.scene.mechanics->connections->spring;
           }},
      {.path = "variation",
       .meaning = "Variation between seeds: standard deviations of normal deviates, cut off at 3. The path of a "
                  "cell keys its deviates, so nothing else in the scene changes them",
       .absent = "nothing varies",
       .members = atLeastOne,
       .later = true,
       .exists = [](const Scenario& s) { return s.scene.variation != VariationParameters{}; }},
      {.path = "senses",
       .meaning = "Senses of cells. The keys are substances: at a cell's cycle the simulator inserts a substance if "
                  "its condition holds, as it inserts A and B, and removes it if not",
       .entries = senses(),
       .details = sensesAsMarkdown()},
      {.path = "record", .meaning = "Records of the run"},
      {.path = "names",
       .meaning = "Names of cells in tables, pictures and messages: the name given for the path of a cell, or else "
                  "the mother's name with a daughter's ending",
       .absent = "cells are called by their paths",
       .members = atLeastOne,
       .decides = Decides::presentation,
       .exists = [](const Scenario& s) { return !s.names.empty(); }},
      {.path = "units",
       .meaning = "Units in which people see lengths and times in pictures, charts, pages and sentences. Values "
                  "that are computed, stored, exported and given to programs stay in the scene's own units, and so "
                  "do masses and forces",
       .absent = "the scene's own",
       .members = atLeastOne,
       .decides = Decides::presentation,
       .exists = [](const Scenario& s) { return s.units.any(); }},
      {.path = "check", .meaning = "Checks of the run besides its golden file", .decides = Decides::presentation},
      {.path = "check.reference",
       .meaning = "Reference with which measures of record.measures compare the organism",
       .absent = "there is no reference",
       .members = atLeastOne,
       .decides = Decides::presentation,
       .make = [](Scenario& s) { s.check.reference.emplace(); },
       .exists = [](const Scenario& s) { return s.check.reference.has_value(); }},
      {.path = "check.bullet",
       .meaning = "Comparison with the same scene computed by Bullet, with tolerances at the end. Defaults without "
                  "any tolerance: if nothing touches and the integrator is velocity-verlet or thesis-verlet, which "
                  "Bullet then uses, too, positions 1e-10 radii; if nothing touches with another integrator, radius "
                  "and volume 1e-6 with b1, 1e-8 with b3; if cells touch, distance 0.01, volume 0.001 and aspect "
                  "0.02",
       .absent = "not compared with Bullet",
       .decides = Decides::presentation,
       .make = [](Scenario& s) { s.check.bullet.emplace(); },
       .exists = [](const Scenario& s) { return s.check.bullet.has_value(); }},
  };
}

}  // namespace morula::scenario
