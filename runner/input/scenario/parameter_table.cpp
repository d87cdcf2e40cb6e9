// Every parameter of a scenario, each described once. To add one: a field in its struct, a line here.
#include "scenario/parameter_table.h"

#include "values/value_types.h"

namespace morula::scenario {
namespace {

#define AT(expression)         \
  +[](Scenario & s) -> auto& { \
    return s.expression;       \
  }
#define MECHANICS(expression) AT(scene.mechanics->expression)
#define PHYSICS(expression) AT(scene.mechanics->physics.expression)

Parameter required(Parameter p) {
  p.required = true;
  return p;
}

Parameter refines(const char* key, Parameter p) {
  p.needs = key;
  return p;
}

Parameter beside(Parameter p) {
  p.beside = true;
  return p;
}

Parameter presentation(Parameter p) {
  p.decides = Decides::presentation;
  return p;
}

/// Puts the subject of a choice before its meaning.
Parameter of(const char* what, Parameter choice) {
  choice.meaning = what + ("; " + choice.meaning);
  return choice;
}

/// Marks a parameter that joined the format later [Parameter::later].
Parameter later(Parameter p) {
  p.later = true;
  return p;
}

std::vector<Parameter> parameters() {
  return {
      required(natural("morula", {1, 1}, "Version of this format", AT(format))),
      required(presentation(name("name", "Name of the results", AT(scene.name)))),
      presentation(text("summary", "Summary of the scenario in one line", AT(summary))),
      natural("seed", {}, "Key of the random numbers; equal seeds give equal results", AT(scene.seed)),
      dna(),
      startCells(),
      experiments(),
      colours(),

      real("cycle.length", "time", positive, "Time between the cycles of a cell", AT(scene.cycle.length)),
      timePerSubstance("cycle.per-substance",
                       "Time between cell cycles of cells that hold this substance; of "
                       "several, the shortest counts",
                       AT(scene.cycle.perSubstance)),
      later(timePerSubstance("cycle.at-birth",
                             "Time from birth to the first cycle of cells whose genes will make this substance; of "
                             "several, the shortest counts. It takes precedence over per-substance",
                             AT(scene.cycle.atBirth))),
      later(choice("cycle.first", AT(scene.cycle.first))),

      optionalNatural("stop.cycles", {1, 1'000'000'000}, "no limit", "Max simulated time, in units of cycle.length",
                      AT(scene.stop.cycles)),
      optionalReal("stop.time", "time", positive, "", "no limit", "Max simulated time", AT(scene.stop.time)),
      optionalNatural("stop.cells", {1, 1'000'000'000}, "no limit",
                      "Number of living cells that ends the run; a run with no other limit fails if it has fewer "
                      "after 1000 cycles",
                      AT(scene.stop.cells)),
      stopWhen(),
      later(refines("when", optionalReal("stop.every", "time", positive, "", "a twentieth of cycle.length",
                                         "Time between looks at the conditions of stop.when", AT(scene.stop.every)))),

      timeStep(),
      choice("physics.integrator", PHYSICS(integrator)),
      optionalNatural("physics.substeps", {1, 10'000}, "1",
                      "Number of substeps of a time step, for integrator xpbd only; more are more exact and slower",
                      PHYSICS(substeps)),
      real(
          "physics.quasi-static.evaluations", "", {1, 1e6},
          "Force evaluations in the shortest cell cycle, times √(vertices of a cell); more are nearer to rest and slower",
          PHYSICS(quasiStatic.evaluations)),
      real(
          "physics.quasi-static.drag", "", positive,
          "Drag on the motion of 128 cells, over the shortest cell cycle: less lets motion swing, more leaves it behind",
          PHYSICS(quasiStatic.drag)),
      real("physics.quasi-static.together", "time", notNegative, "Max time between events that share one settling",
           PHYSICS(quasiStatic.together)),
      optionalReal("physics.quasi-static.residual", "", {1e-12, 1}, "", "cells stop as they are",
                   "Residual to which the end of the run settles: the tractions left over the pressure in cells",
                   PHYSICS(quasiStatic.residual)),
      of("Precision of the numbers that physics computes with", choice("physics.precision", PHYSICS(precision))),
      real("physics.drag", "1/time", notNegative, "Drag of the medium on every vertex: acceleration −drag·v",
           PHYSICS(drag)),

      optionalNatural("physics.mesh.icosphere", {0, 4}, "see file",
                      "Number of refinements of an icosahedron: 12, 42, 162, 642, 2562 vertices", AT(mesh.icosphere)),
      refines("icosphere",
              optionalReal("physics.mesh.coarsen", "length", positive, "", "every cell keeps the egg's mesh",
                           "Max mean edge at rest of a daughter: she takes the coarsest icosphere, 2 at least, with "
                           "such edges",
                           PHYSICS(coarsen))),
      optionalFile("physics.mesh.file", "Wavefront OBJ of a closed surface of roughly equal triangles", AT(mesh.file)),

      later(choice("physics.cell.model", PHYSICS(cell.model))),
      real("physics.cell.radius", "length", positive,
           "Radius of the sphere whose volume the egg encloses, whatever "
           "its mesh",
           PHYSICS(cell.radius)),
      real("physics.cell.mass", "mass", positive,
           "Mass of the egg, spread evenly over the vertices [Nilsson 2008, "
           "eq. 4.1]",
           PHYSICS(cell.mass)),

      real("physics.membrane.stiffness", "force/length", positive,
           "Stiffness k_s of an edge; higher: rounder "
           "cells, shorter time steps",
           PHYSICS(membrane.stiffness)),
      damping("physics.membrane.damping", "Damping k_d along an edge", PHYSICS(membrane.damping)),
      real("physics.membrane.production", "", positive,
           "Membrane area of both daughters over their mother's; 1.26 keeps a sphere's tension",
           PHYSICS(membrane.areaFactor)),
      later(choice("physics.membrane.springs", PHYSICS(membrane.springs))),
      later(real("physics.membrane.bending", "force·length", notNegative,
                 "Bending rigidity κ of the membrane: its energy is ½ κ (2H)² per area, with the mean curvature H. "
                 "Higher: fewer folds, rounder cells; not for integrator xpbd",
                 PHYSICS(membrane.bending))),

      real("physics.pressure.constant", "force·length", notNegative,
           "Constant k_p of the egg; daughters share it "
           "by volume",
           PHYSICS(pressure.constant)),
      real("physics.pressure.outside", "force/length²", notNegative, "P_0", PHYSICS(pressure.outside)),

      real("physics.shape-matching.stiffness", "1/time²", positive,
           "Stiffness k of a = −k (x − goal): a cell oscillates √k/2π times per time; higher: firmer cells, shorter "
           "time steps",
           PHYSICS(shapeMatching.stiffness)),
      real("physics.shape-matching.linear", "", {0, 1},
           "Share β of stretching and shear that goals follow at the volume at rest; 1: only volume is restored",
           PHYSICS(shapeMatching.linear)),
      real("physics.shape-matching.damping", "1/time", notNegative,
           "Damping κ of all motion but the cell's translation and rotation; 2√k: no oscillation",
           PHYSICS(shapeMatching.damping)),

      real("physics.growth.rate", "1/time", positive,
           "Relative change of mass and k_p over time; lengths change at a third of this rate", PHYSICS(growth->rate)),
      later(optionalReal("physics.growth.until", "", positive, "", "growth goes on",
                         "Max volume at rest of a cell that grows, over the egg's", PHYSICS(growth->until))),

      shellSphere(),
      shellEllipsoid(),
      shellMesh(),
      shellFill(),
      later(beside(of("Part of a meshed cell that a spherical or ellipsoidal shell keeps inside",
                      choice("physics.shell.holds", PHYSICS(shell->holds))))),

      real("physics.motility.speed", "length/time", positive, "Speed of a cell alone in the medium",
           PHYSICS(motility->speed)),
      real("physics.motility.persistence", "time", positive, "Time for which a cell keeps its direction",
           PHYSICS(motility->persistence)),

      choice("physics.contact.law", MECHANICS(contact->law)),
      real("physics.contact.stiffness", "force/length", positive, "Stiffness K of a vertex pair; not for law thesis",
           MECHANICS(contact->stiffness)),
      damping("physics.contact.damping", "Damping C of the approach of a vertex pair; not for law thesis",
              MECHANICS(contact->damping)),
      real("physics.contact.viscosity", "", notNegative,
           "Contact viscosity: max force against sliding, per normal force; slow cells feel a weaker damper, "
           "nearly alike for all values above 0; not for law thesis",
           MECHANICS(contact->viscosity)),
      real("physics.contact.slip-speed", "length/time", positive,
           "Speed of slip up to which the limit grows in proportion; the force of a pair is at most 0.3 "
           "√(stiffness × mass of the lightest vertex) × slip",
           MECHANICS(contact->slipSpeed)),
      real("physics.contact.radius", "", positive, "Reach of a vertex, in mean rest lengths of its cell's edges",
           MECHANICS(contact->radius)),
      adhesion(),

      divisionPlane(),
      real("division.chirality.angle", "degree", chiralAngle,
           "Angle by which daughter A turns in all, clockwise as seen along the axis, which points to her; B turns "
           "as far the other way; below 0: the mirror image",
           MECHANICS(division.chirality->angle)),
      real("division.chirality.time", "time", positive, "Time in which the speed of turning falls to 1/e",
           MECHANICS(division.chirality->time)),
      later(divisionRules()),
      divisionSize(),

      makeConnections(),
      choice("connections.on-division", MECHANICS(connections->onDivision)),
      optionalReal("connections.strength", "force", notNegative, "shared",
                   "shared: all connections of a cell together pull with at most 0.2, times its share of the "
                   "egg, so that no number of them crushes",
                   "Constant pull k_c of each connection, however many a cell has [Nilsson 2008, eq. 4.9]",
                   MECHANICS(connections->strength)),
      optionalReal("connections.release-distance", "", positive, "", "never by distance",
                   "Max distance of the centres, in sums of the two radii; a longer connection is released",
                   MECHANICS(connections->releaseDistance)),
      optionalReal("connections.release-tension", "force", positive, "", "never by tension",
                   "Max tension of a spring; a connection that pulls harder is released",
                   MECHANICS(connections->releaseTension)),
      optionalReal("connections.release-age", "time", positive, "", "never by age",
                   "Max age of a connection; an older one is released. A daughter's is made at her birth",
                   MECHANICS(connections->releaseAge)),
      optionalNatural("connections.most", {1, 1'000'000}, "any number",
                      "Max number of connections of a cell; a connection that would exceed it for either cell is "
                      "not made. At a division the mother's connections pass on first, by the other cell's path, "
                      "then the sisters' is made",
                      MECHANICS(connections->most)),
      real("connections.spring.stiffness", "force/length", positive,
           "Stiffness k of the tension k (d − rest (r₁ + r₂)): d is the distance of the centres, r are the radii of "
           "spheres with the cells' volumes",
           MECHANICS(connections->spring->stiffness)),
      real("connections.spring.rest", "", notNegative,
           "Distance of the centres at rest, in sums of the two radii; 1: the spheres touch",
           MECHANICS(connections->spring->rest)),

      real("variation.cycle", "", {0, 0.3},
           "Deviation of a cell's cycle lengths, over those of its state; one "
           "value for all its life",
           AT(scene.variation.cycle)),
      real("variation.share", "", {0, 0.13},
           "Deviation of daughter A's share of the volume from a rule's share, or "
           "from a half",
           AT(scene.variation.share)),
      real("variation.start", "", {0, 10},
           "Deviation of the places of the first cells along x, y and z, in radii of the egg; no cell leaves the "
           "shell",
           AT(scene.variation.start)),
      real("variation.tilt", "degree", {0, 90}, "Deviation of the axes of divisions whose rule gives no tilt",
           AT(scene.variation.tilt)),
      later(real("variation.adhesion", "", {0, 0.3},
                 "Deviation of the strength with which a cell sticks, over physics.contact.adhesion; two cells "
                 "stick by the mean of both",
                 AT(scene.variation.adhesion))),

      optionalReal("record.every", "time", positive, "", "only start and end", "Time between samples",
                   AT(record.every)),
      presentation(optionalReal("record.pictures", "time", positive, "", "one picture, of the end",
                                "Time between pictures of a sequence", AT(record.pictures))),
      later(optionalReal("record.meshes", "time", positive, "", "no surfaces are kept",
                         "Time between samples that also keep the surface of every cell, 16 bits a coordinate; "
                         "surfaces are kept at the end, too, and at the samples of at-cells",
                         AT(record.meshes))),
      recordAtCells(),
      recordMeasures(),

      nameOfEgg(),
      namesOfDaughters(),
      namesOfCells(),
      namesFile(),

      unitName("units.length", "Unit in which people see lengths, areas and volumes, as µm", AT(units.length)),
      refines("length", presentation(real("units.per-length", "", positive,
                                          "Number of these units in one length of the scene", AT(units.perLength)))),
      unitName("units.time", "Unit in which people see times, as min", AT(units.time)),
      refines("time", presentation(real("units.per-time", "", positive,
                                        "Number of these units in one time of the scene", AT(units.perTime)))),

      optionalBounds("check.volume",
                     "Always: volume of every cell over that of its mesh at rest; a positive volume "
                     "is not inside out",
                     AT(check.volume)),
      presentation(optionalReal("check.extent", "length", positive, "", "not checked",
                                "Always: max distance of a vertex from the origin", AT(check.extent))),
      presentation(optionalReal("check.energy", "force·length", positive, "", "not checked",
                                "Always: max energy of motion, membranes, contents, connections, contacts and "
                                "adhesion (which is negative) together; needs pressure.outside > 0",
                                AT(check.energy))),
      presentation(optionalReal("check.momentum", "mass·length/time", notNegative, "", "not checked",
                                "Always: max change of the momentum of all cells since the start", AT(check.momentum))),
      optionalBounds("check.end-volume", "At the end: volume of every cell over that of its mesh at rest",
                     AT(check.endVolume)),
      presentation(optionalReal("check.end-roundness", "", {0, 1}, "", "not checked",
                                "At the end: min sphericity of a cell; 1 is a sphere", AT(check.endRoundness))),
      presentation(optionalReal("check.end-overlap", "", {0, 1}, "", "not checked",
                                "At the end: max share of a cell's volume that lies in another cell, too, in the "
                                "mean over the cells",
                                AT(check.endOverlap))),
      texts("check.fails",
            "Texts that the error of the run must contain: the run must stop (exit 3 or 4), and then needs no "
            "golden file",
            AT(check.fails)),
      saneEnd(),
      becauseText(),

      referenceContacts(),
      referencePositions(),
      referenceFile(),

      presentation(oneOf(
          "check.bullet.baseline", {"b1", "b3"},
          "b1: our forces, Bullet's integrator and contact; b3: Bullet's implicit solver, for one cell's rest",
          [](Scenario& s) { return s.check.bullet->baseline == Baseline::b3 ? 1 : 0; },
          [](Scenario& s, int i) { s.check.bullet->baseline = i == 1 ? Baseline::b3 : Baseline::b1; })),
      presentation(real("check.bullet.margin", "", positive,
                        "Margin of each surface in Bullet, in radii of the egg: surfaces that touch are two margins "
                        "apart",
                        AT(check.bullet->margin))),
      presentation(optionalReal("check.bullet.positions", "length", positive, "", "see bullet",
                                "Max distance of a vertex from Bullet's", AT(check.bullet->positions))),
      presentation(optionalReal("check.bullet.radius", "", positive, "", "see bullet",
                                "Max deviation of a cell's mean radius, over Bullet's", AT(check.bullet->radius))),
      presentation(optionalReal("check.bullet.volume", "", positive, "", "see bullet",
                                "Max deviation of a cell's volume, over Bullet's", AT(check.bullet->volume))),
      presentation(optionalReal("check.bullet.distance", "", positive, "", "see bullet",
                                "Max deviation of the distance of two centres, less Bullet's gap of two margins "
                                "where cells touch",
                                AT(check.bullet->distance))),
      presentation(optionalReal("check.bullet.aspect", "", positive, "", "see bullet",
                                "Max deviation of a cell's length over its thickness, over Bullet's",
                                AT(check.bullet->aspect))),
  };
}

#undef AT
#undef MECHANICS
#undef PHYSICS

}  // namespace

const ParameterTable& parameterTable() {
  static const ParameterTable table{sections(), parameters()};
  return table;
}

}  // namespace morula::scenario
