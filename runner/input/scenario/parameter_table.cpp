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
      required(presentation(name("name", "Names the results", AT(scene.name)))),
      presentation(text("summary", "One line for people", AT(summary))),
      natural("seed", {}, "Chooses the random numbers; equal seeds give equal results", AT(scene.seed)),
      dna(),
      startCells(),
      experiments(),
      colourPerSubstance("colours", "Cells mix the colours of their substances; longer patterns win", AT(colours)),

      real("cycle.length", "time", positive, "Time between a cell's cycles", AT(scene.cycle.length)),
      timePerSubstance("cycle.per-substance", "The same for cells that hold a substance; the shortest wins",
                       AT(scene.cycle.perSubstance)),
      later(timePerSubstance("cycle.at-birth",
                             "From birth to the first cycle, by a substance that the newborn's genes will make; the "
                             "shortest wins, and goes before per-substance",
                             AT(scene.cycle.atBirth))),
      later(choice("cycle.first", AT(scene.cycle.first))),

      optionalNatural("stop.cycles", {1, 1'000'000'000}, "no limit", "When so many times cycle.length have passed",
                      AT(scene.stop.cycles)),
      optionalReal("stop.time", "time", positive, "", "no limit", "At this simulated time", AT(scene.stop.time)),
      optionalNatural("stop.cells", {1, 1'000'000'000}, "no limit",
                      "When at least so many cells live; alone, it fails where they do not within 1000 cycles",
                      AT(scene.stop.cells)),
      stopWhen(),
      later(refines("when", optionalReal("stop.every", "time", positive, "", "a twentieth of cycle.length",
                                         "Time between looks at the conditions of stop.when", AT(scene.stop.every)))),

      timeStep(),
      choice("physics.integrator", PHYSICS(integrator)),
      optionalNatural("physics.substeps", {1, 10'000}, "1",
                      "Of a time step, with integrator xpbd only; more: more exact and slower", PHYSICS(substeps)),
      real("physics.settle.tolerance", "", {1e-12, 1},
           "A settling ends when the tractions left are this small beside the pressure in cells (root mean squares)",
           PHYSICS(settle.tolerance)),
      natural("physics.settle.evaluations", {1, 1'000'000'000},
              "Max force evaluations per settling; reaching it is reported", PHYSICS(settle.evaluations)),
      real("physics.settle.together", "time", notNegative,
           "Events that follow each other by no more share one settling", PHYSICS(settle.together)),
      optionalNatural("physics.settle.sample", {1, 1'000'000'000}, "none",
                      "Measure every N-th settling: how far from rest it ends (table settling). It changes no "
                      "result",
                      PHYSICS(settle.sample)),
      of("Of the numbers that physics computes with", choice("physics.precision", PHYSICS(precision))),
      real("physics.drag", "1/time", notNegative, "The medium slows every vertex: acceleration −drag·v", PHYSICS(drag)),

      optionalNatural("physics.mesh.icosphere", {0, 4}, "see file",
                      "Times that an icosahedron is refined: 12, 42, 162, 642, 2562 vertices", AT(mesh.icosphere)),
      refines("icosphere",
              optionalReal("physics.mesh.coarsen", "length", positive, "", "every cell keeps the egg's mesh",
                           "A daughter takes the coarsest icosphere, 2 at least, whose mean edge at rest is no "
                           "longer than this",
                           PHYSICS(coarsen))),
      optionalFile("physics.mesh.file", "Wavefront OBJ of a closed surface of roughly equal triangles", AT(mesh.file)),

      later(choice("physics.cell.model", PHYSICS(cell.model))),
      real("physics.cell.radius", "length", positive, "Of the sphere whose volume the egg encloses, whatever its mesh",
           PHYSICS(cell.radius)),
      real("physics.cell.mass", "mass", positive, "Of the egg, spread evenly over the vertices [Nilsson 2008, eq. 4.1]",
           PHYSICS(cell.mass)),

      real("physics.membrane.stiffness", "force/length", positive, "k_s; higher: rounder cells, shorter time steps",
           PHYSICS(membrane.stiffness)),
      real("physics.membrane.damping", "force·time/length", notNegative, "k_d, along the edge",
           PHYSICS(membrane.damping)),
      real("physics.membrane.production", "", positive,
           "Membrane of both daughters over their mother's; 1.26 keeps a sphere's tension",
           PHYSICS(membrane.areaFactor)),
      later(choice("physics.membrane.springs", PHYSICS(membrane.springs))),

      real("physics.pressure.constant", "force·length", notNegative, "k_p of the egg; daughters share it by volume",
           PHYSICS(pressure.constant)),
      real("physics.pressure.outside", "force/length²", notNegative, "P_0", PHYSICS(pressure.outside)),

      real("physics.shape-matching.stiffness", "1/time²", positive,
           "k of a = −k (x − goal): a cell rings √k/2π times per time; higher: firmer, shorter time steps",
           PHYSICS(shapeMatching.stiffness)),
      real("physics.shape-matching.linear", "", {0, 1},
           "β: how far goals follow stretching and shear at the volume at rest; 1: nothing but volume is restored",
           PHYSICS(shapeMatching.linear)),
      real("physics.shape-matching.damping", "1/time", notNegative,
           "κ, of all motion but the cell's flight and spin; 2√k: no swinging", PHYSICS(shapeMatching.damping)),

      real("physics.growth.rate", "1/time", positive,
           "Relative change of mass and k_p; lengths grow at a third of this rate", PHYSICS(growth->rate)),
      later(optionalReal("physics.growth.until", "", positive, "", "growth goes on",
                         "Volume at rest over the egg's at which a cell stops growing", PHYSICS(growth->until))),

      shellSphere(),
      shellEllipsoid(),
      shellMesh(),
      shellFill(),
      later(beside(of("Which part of a meshed cell the shell, a sphere or an ellipsoid, keeps inside",
                      choice("physics.shell.holds", PHYSICS(shell->holds))))),

      real("physics.motility.speed", "length/time", positive, "Of a cell alone in the medium",
           PHYSICS(motility->speed)),
      real("physics.motility.persistence", "time", positive, "For which a cell keeps its direction",
           PHYSICS(motility->persistence)),

      choice("physics.contact.law", MECHANICS(contact->law)),
      real("physics.contact.stiffness", "force/length", positive, "K of a vertex pair; not of law thesis",
           MECHANICS(contact->stiffness)),
      real("physics.contact.damping", "force·time/length", notNegative, "C against approach; not of law thesis",
           MECHANICS(contact->damping)),
      real("physics.contact.friction", "", notNegative, "Coulomb's coefficient; not of law thesis",
           MECHANICS(contact->friction)),
      real(
          "physics.contact.slip-speed", "length/time", positive,
          "Friction grows in proportion to slip up to this speed; of a pair it is at most 0.3 √(stiffness × mass of the "
          "lightest vertex) × slip",
          MECHANICS(contact->slipSpeed)),
      real("physics.contact.radius", "", positive, "Reach of a vertex, in mean rest lengths of its cell's edges",
           MECHANICS(contact->radius)),
      adhesion(),

      divisionPlane(),
      real("division.chirality.angle", "degree", chiralAngle,
           "Of daughter A in all, clockwise seen along the axis, which points to her; B turns by as much the other "
           "way; below 0: the mirror image",
           MECHANICS(division.chirality->angle)),
      real("division.chirality.time", "time", positive, "In which the turning falls to 1/e",
           MECHANICS(division.chirality->time)),
      later(divisionRules()),
      divisionSize(),

      makeConnections(),
      choice("connections.on-division", MECHANICS(connections->onDivision)),
      optionalReal("connections.strength", "force", notNegative, "shared",
                   "shared: all connections of a cell together pull with at most 0.2, times its share of the "
                   "egg, so that no number of them crushes",
                   "k_c, constant pull of each connection, however many a cell has [Nilsson 2008, eq. 4.9]",
                   MECHANICS(connections->strength)),
      optionalReal("connections.release-distance", "", positive, "", "never by distance",
                   "Released beyond this distance of the centres, in sums of the two radii",
                   MECHANICS(connections->releaseDistance)),
      optionalReal("connections.release-tension", "force", positive, "", "never by tension",
                   "Released when a spring pulls harder than this", MECHANICS(connections->releaseTension)),
      optionalReal("connections.release-age", "time", positive, "", "never by age",
                   "Released so long after it was made; a daughter's is made at her birth",
                   MECHANICS(connections->releaseAge)),
      optionalNatural("connections.most", {1, 1'000'000}, "any number",
                      "Connections of a cell: one that would be one too many for either is not made. Those of a "
                      "cell that divides pass on first, by the other cell's path, then comes that of the sisters",
                      MECHANICS(connections->most)),
      real("connections.spring.stiffness", "force/length", positive,
           "k of the tension k (d − rest (r₁ + r₂)), d the distance of the centres, r the radii of spheres with the "
           "cells' volumes",
           MECHANICS(connections->spring->stiffness)),
      real("connections.spring.rest", "", notNegative,
           "Distance of the centres at rest, in sums of the two radii; 1: as they touch",
           MECHANICS(connections->spring->rest)),

      real("variation.cycle", "", {0, 0.3}, "Of a cell's cycle lengths, over those of its state; one for all its life",
           AT(scene.variation.cycle)),
      real("variation.share", "", {0, 0.13}, "Of daughter A's share of the volume, about a rule's or a half",
           AT(scene.variation.share)),
      real("variation.start", "", {0, 10},
           "Of the places of the first cells, along x, y and z in radii of the egg; none leaves the shell",
           AT(scene.variation.start)),
      real("variation.tilt", "degree", {0, 90}, "Of the axes of divisions whose rule gives no tilt",
           AT(scene.variation.tilt)),
      later(real("variation.adhesion", "", {0, 0.3},
                 "Of how strongly a cell sticks, over physics.contact.adhesion; two cells by the mean of both",
                 AT(scene.variation.adhesion))),

      optionalReal("record.every", "time", positive, "", "only start and end", "Time between samples",
                   AT(record.every)),
      presentation(optionalReal("record.pictures", "time", positive, "", "one picture, of the end",
                                "Time between pictures of a sequence", AT(record.pictures))),
      later(optionalReal("record.meshes", "time", positive, "", "no surfaces are kept",
                         "Time between samples that also keep the surface of every cell, 16 bits a "
                         "coordinate; there is one at the end, and where at-cells asks for a sample",
                         AT(record.meshes))),
      recordAtCells(),
      recordMeasures(),

      nameOfEgg(),
      namesOfDaughters(),
      namesOfCells(),
      namesFile(),

      unitName("units.length", "What people see lengths in, as µm; areas and volumes too", AT(units.length)),
      refines("length", presentation(real("units.per-length", "", positive,
                                          "So many of them are one length of the scene", AT(units.perLength)))),
      unitName("units.time", "What people see times in, as min", AT(units.time)),
      refines("time", presentation(real("units.per-time", "", positive, "So many of them are one time of the scene",
                                        AT(units.perTime)))),

      optionalBounds("check.volume", "Always: of every cell, over that of its mesh at rest; positive is not inside out",
                     AT(check.volume)),
      presentation(optionalReal("check.extent", "length", positive, "", "not checked",
                                "Always: the most that a vertex is away from the origin", AT(check.extent))),
      presentation(optionalReal("check.energy", "force·length", positive, "", "not checked",
                                "Always: the most that motion, membranes, contents, connections, contacts and "
                                "adhesion (which lowers it) hold together; needs pressure.outside > 0",
                                AT(check.energy))),
      presentation(optionalReal("check.momentum", "mass·length/time", notNegative, "", "not checked",
                                "Always: the most that the momentum of all is off from that at the start",
                                AT(check.momentum))),
      optionalBounds("check.end-volume", "At the end: as volume", AT(check.endVolume)),
      presentation(optionalReal("check.end-roundness", "", {0, 1}, "", "not checked",
                                "At the end: the least sphericity of a cell; 1 is a sphere", AT(check.endRoundness))),
      presentation(optionalReal("check.end-overlap", "", {0, 1}, "", "not checked",
                                "At the end: the most of a cell's volume that lies in another too, in the mean",
                                AT(check.endOverlap))),
      texts("check.fails",
            "The run must stop with an error (exit 3 or 4) that names all of these; it then needs no golden file",
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
                        "Of each surface in Bullet, in radii of the egg: what touches is two of them apart",
                        AT(check.bullet->margin))),
      presentation(optionalReal("check.bullet.positions", "length", positive, "", "see bullet",
                                "The most that a vertex may be off", AT(check.bullet->positions))),
      presentation(optionalReal("check.bullet.radius", "", positive, "", "see bullet",
                                "The most that a cell's mean radius may be off, over Bullet's",
                                AT(check.bullet->radius))),
      presentation(optionalReal("check.bullet.volume", "", positive, "", "see bullet",
                                "The most that a cell's volume may be off, over Bullet's", AT(check.bullet->volume))),
      presentation(optionalReal("check.bullet.distance", "", positive, "", "see bullet",
                                "The most that the distance of two centres may be off, less Bullet's gap of "
                                "two margins where cells touch",
                                AT(check.bullet->distance))),
      presentation(optionalReal("check.bullet.aspect", "", positive, "", "see bullet",
                                "The most that a cell's length over its thickness may be off, over Bullet's",
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
