#include "simulation/scene_parts.h"

#include "physics/cell_model.h"
#include "physics/integrator.h"
#include "simulation/scene.h"

namespace morula {

// Each function takes its struct apart into all of its members: a new member that is not hashed does not compile. A
// member that joins when there are checkpoints is hashed only where it is not at its default, so that these stay valid.

namespace {

void add(Hasher& h, const std::optional<double>& a) { h.add(a.has_value()).add(a.value_or(0)); }

template <class Enum>
int number(Enum e) {
  return static_cast<int>(e);
}

void addPart(Hasher& h, const Dna& dna) {
  const auto& [substances, start, genes, source, warnings] = dna;  // the last two only tell of the text
  h.field("substances").add(std::uint64_t{substances.size()});
  for (const std::string& name : substances) h.add(name);
  h.field("start").add(std::uint64_t{start.size()});
  for (SubstanceId s : start) h.add(std::uint64_t{s});
  h.field("genes").add(std::uint64_t{genes.size()});
  for (const auto& [name, product, inputs, repressors] : genes) {  // a name does nothing
    h.add(std::uint64_t{product}).add(std::uint64_t{inputs.size()});
    for (SubstanceId s : inputs) h.add(std::uint64_t{s});
    if (repressors.empty()) continue;
    h.field("repressors").add(std::uint64_t{repressors.size()});
    for (SubstanceId s : repressors) h.add(std::uint64_t{s});
  }
}

void addPart(Hasher& h, const CycleParameters& cycle) {
  const auto& [length, perSubstance, atBirth, divisionSize] = cycle;
  h.field("cycle").add(length).add(std::uint64_t{perSubstance.size()});
  for (const auto& [name, own] : perSubstance) h.add(name).add(own);
  if (!atBirth.empty()) {
    h.field("at birth").add(std::uint64_t{atBirth.size()});
    for (const auto& [name, own] : atBirth) h.add(name).add(own);
  }
  if (divisionSize) {
    const auto& [rule, size] = *divisionSize;
    h.field("division size").add(number(rule)).add(size);
  }
}

void addPart(Hasher& h, const std::vector<SenseParameters>& senses) {
  h.field("senses").add(std::uint64_t{senses.size()});
  for (const auto& [substance, kind, is, of, amount, axis, lives] : senses) {
    h.add(substance).add(number(kind)).add(of).add(axis.x).add(axis.y).add(axis.z).add(lives);
    const auto& [below, above, atMost, atLeast, until] = is;
    for (const auto* one : {&below, &above, &atMost, &atLeast, &until, &amount}) add(h, *one);
  }
}

void addPart(Hasher& h, const std::uint64_t& seed) { h.field("seed").add(seed); }

void addMesh(Hasher& h, const Mesh& mesh) {
  const auto& [vertices, faces] = mesh;
  h.field("vertices").add(std::uint64_t{vertices.size()});
  for (const Point& x : vertices) h.add(x.x).add(x.y).add(x.z);
  h.field("faces").add(std::uint64_t{faces.size()});
  for (const Face& f : faces) h.add(f[0]).add(f[1]).add(f[2]);
}

void addPart(Hasher& h, const PhysicsParameters& physics) {
  const auto& [coarsen, timeStep, autoShare, integrator, substeps, precision, cell, membrane, pressure, shapeMatching,
               drag, growth, shell, motility, settle] = physics;
  h.field("physics").add(number(integrator)).add(number(precision)).add(drag);
  if (substeps) h.field("substeps").add(*substeps);
  add(h, coarsen);
  add(h, timeStep);
  if (autoShare != 1) h.field("share of the automatic time step").add(autoShare);
  const auto& [radius, mass, model] = cell;
  h.field("cell").add(number(model)).add(radius).add(mass);
  const auto& [stiffness, damping, areaFactor, springs] = membrane;
  h.field("membrane").add(stiffness).add(damping).add(areaFactor);
  if (springs != Springs::equal) h.field("springs").add(number(springs));
  if (kindOf(model).hasRestShape) {
    const auto& [pull, linear, resistance] = shapeMatching;
    h.field("shape matching").add(pull).add(linear).add(resistance);
  }
  const auto& [constant, outside] = pressure;
  h.field("pressure").add(constant).add(outside);
  const auto& [rate, until] = growth.value_or(GrowthParameters{.rate = 0, .until = {}});
  h.field("growth").add(growth.has_value()).add(rate);
  if (until) h.field("until").add(*until);
  h.field("shell").add(shell.has_value());
  if (shell) {
    const auto& [semiAxes, mesh, holds] = *shell;
    h.add(std::span<const double>(semiAxes));
    if (mesh) addMesh(h.field("shell mesh"), mesh->mesh);
    if (holds != Held::vertices) h.field("shell holds").add(number(holds));
  }
  if (motility) {
    const auto& [speed, persistence] = *motility;
    h.field("motility").add(speed).add(persistence);
  }
  if (kindOf(integrator).settles) {
    const auto& [tolerance, evaluations, together, sample] = settle;
    h.field("settle").add(tolerance).add(evaluations).add(together);
    if (sample) h.field("settle sample").add(*sample);
  }
}

struct Meshes {
  const Mesh& egg;
  const std::vector<Mesh>& coarser;
};
void addPart(Hasher& h, const Meshes& meshes) {
  addMesh(h, meshes.egg);
  h.field("coarser").add(std::uint64_t{meshes.coarser.size()});
  for (const Mesh& mesh : meshes.coarser) addMesh(h, mesh);
}

void addPart(Hasher& h, const ContactParameters& contact) {
  const auto& [law, stiffness, damping, friction, slipSpeed, radius, adhesion] = contact;
  h.field("contact").add(number(law)).add(stiffness).add(damping).add(friction).add(slipSpeed).add(radius);
  if (!adhesion) return;
  const auto& [strength, pairs] = *adhesion;
  h.field("adhesion").add(strength).add(std::uint64_t{pairs.size()});
  for (const auto& [a, b, own] : pairs) h.add(a).add(b).add(own);
}

void addPlane(Hasher& h, const PlaneChoice& choice) {
  const auto& [plane, axis, substance, turnsAway] = choice;
  h.add(number(plane)).add(axis.x).add(axis.y).add(axis.z);
  if (!substance.empty()) h.add(substance);
  if (turnsAway) h.add("away");
}

void addChirality(Hasher& h, const std::optional<Chirality>& chirality) {
  if (!chirality) return;
  const auto& [angle, time] = *chirality;
  h.field("chirality").add(angle).add(time);
}

void addPart(Hasher& h, const DivisionParameters& division) {
  const auto& [otherwise, rules, chirality] = division;
  addPlane(h.field("division"), otherwise);
  addChirality(h, chirality);
  if (rules.empty()) return;
  h.field("rules").add(std::uint64_t{rules.size()});
  for (const auto& [of, plane, share, tilt, own] : rules) {
    h.add(std::uint64_t{of.size()});
    for (const std::string& pattern : of) h.add(pattern);
    h.add(plane.has_value());
    if (plane) addPlane(h, *plane);
    add(h, share);
    add(h, tilt);
    addChirality(h, own);
  }
}

void addPart(Hasher& h, const ConnectionParameters& connections) {
  const auto& [make, onDivision, strength, releaseDistance, pairs, spring, releaseTension, releaseAge, most] =
      connections;
  h.field("connections").add(number(make)).add(number(onDivision));
  if (strength) h.add(*strength);
  else h.add("shared");
  add(h, releaseDistance);
  if (!pairs.empty()) h.field("pairs").add(std::uint64_t{pairs.size()});
  for (const auto& [a, b] : pairs) h.add(a).add(b);
  if (spring) {
    const auto& [stiffness, rest] = *spring;
    h.field("spring").add(stiffness).add(rest);
  }
  if (releaseTension) h.field("release tension").add(*releaseTension);
  if (releaseAge) h.field("release age").add(*releaseAge);
  if (most) h.field("most").add(*most);
}

void addPart(Hasher& h, const VariationParameters& variation) {
  const auto& [cycle, share, start, tilt, adhesion] = variation;
  h.field("variation").add(cycle).add(share).add(start).add(tilt);
  if (adhesion != 0) h.field("adhesion").add(adhesion);
}

}  // namespace

std::vector<ScenePart> hashSceneParts(const Scene& scene) {
  const auto& [title, seed, dna, cycle, stop, mechanics, cells, variation, senses] = scene;
  std::vector<ScenePart> parts;
  const auto add = [&]<class Part>(const char* name, const Part* part) {
    Hasher h;
    if (part) addPart(h, *part);
    parts.push_back({name, part ? h.digest().text() : ""});
  };
  add("dna", &dna);
  add("cycle", &cycle);
  add("seed", &seed);
  static const MechanicsScene none{};
  const auto& [physics, mesh, coarser, contact, division, connections] = mechanics ? *mechanics : none;
  const Meshes meshes{mesh, coarser};
  add("physics", mechanics ? &physics : nullptr);
  add("physics.mesh", mechanics ? &meshes : nullptr);
  add("physics.contact", contact ? &*contact : nullptr);
  add("division", mechanics ? &division : nullptr);
  add("connections", connections ? &*connections : nullptr);
  VariationParameters onTheWay = variation;
  onTheWay.start = 0;  // like the start cells: how a state came about does not decide how it goes on
  if (onTheWay != VariationParameters{}) add("variation", &onTheWay);
  if (!senses.empty()) add("senses", &senses);
  return parts;
}

}  // namespace morula
