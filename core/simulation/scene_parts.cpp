#include "simulation/scene_parts.h"

#include "simulation/scene.h"

namespace morula {

namespace {

void add(Hasher& h, const std::optional<double>& a) { h.add(a.has_value()).add(a.value_or(0)); }

template <class Enum>
int number(Enum e) {
  return static_cast<int>(e);
}

std::string hashOf(const Dna& dna) {
  Hasher h;
  h.field("substances").add(std::uint64_t{dna.substances.size()});
  for (const std::string& name : dna.substances) h.add(name);
  h.field("start").add(std::uint64_t{dna.start.size()});
  for (SubstanceId s : dna.start) h.add(std::uint64_t{s});
  h.field("genes").add(std::uint64_t{dna.genes.size()});
  for (const Gene& gene : dna.genes) {
    h.add(std::uint64_t{gene.product}).add(std::uint64_t{gene.inputs.size()});
    for (SubstanceId s : gene.inputs) h.add(std::uint64_t{s});
    if (gene.repressors.empty()) continue;
    h.field("repressors").add(std::uint64_t{gene.repressors.size()});
    for (SubstanceId s : gene.repressors) h.add(std::uint64_t{s});
  }
  return h.digest().text();
}

std::string hashOf(const CycleParameters& p) {
  Hasher h;
  h.field("cycle").add(p.length).add(std::uint64_t{p.perSubstance.size()});
  for (const auto& [name, length] : p.perSubstance) h.add(name).add(length);
  return h.digest().text();
}

std::string hashOf(std::uint64_t seed) {
  Hasher h;
  h.field("seed").add(seed);
  return h.digest().text();
}

std::string hashOf(const PhysicsParameters& p) {
  Hasher h;
  h.field("physics").add(number(p.integrator)).add(number(p.precision)).add(p.drag);
  if (p.substeps) h.field("substeps").add(*p.substeps);
  add(h, p.coarsen);
  add(h, p.timeStep);
  if (p.autoShare != 1) h.field("share of the automatic time step").add(p.autoShare);
  h.field("cell").add(number(p.cell.model)).add(p.cell.radius).add(p.cell.mass);
  h.field("membrane").add(p.membrane.stiffness).add(p.membrane.damping).add(p.membrane.production);
  if (p.cell.model == CellModel::shapeMatching)
    h.field("shape matching")
        .add(p.shapeMatching.stiffness)
        .add(p.shapeMatching.linear)
        .add(p.shapeMatching.damping);
  h.field("pressure").add(p.pressure.constant).add(p.pressure.outside);
  h.field("growth").add(p.growth.has_value()).add(p.growth ? p.growth->rate : 0);
  h.field("shell").add(p.shell.has_value());
  if (p.shell) h.add(std::span<const double>(p.shell->semiAxes));
  return h.digest().text();
}

void add(Hasher& h, const Mesh& mesh) {
  h.field("vertices").add(std::uint64_t{mesh.vertices.size()});
  for (const Point& x : mesh.vertices) h.add(x.x).add(x.y).add(x.z);
  h.field("faces").add(std::uint64_t{mesh.faces.size()});
  for (const Face& f : mesh.faces) h.add(f[0]).add(f[1]).add(f[2]);
}

std::string hashOfMeshes(const MechanicsScene& m) {
  Hasher h;
  add(h, m.mesh);
  h.field("coarser").add(std::uint64_t{m.coarser.size()});
  for (const Mesh& mesh : m.coarser) add(h, mesh);
  return h.digest().text();
}

std::string hashOf(const ContactParameters& p) {
  Hasher h;
  h.field("contact")
      .add(number(p.law))
      .add(p.stiffness)
      .add(p.damping)
      .add(p.friction)
      .add(p.slipSpeed)
      .add(p.radius);
  return h.digest().text();
}

std::string hashOf(const DivisionParameters& p) {
  Hasher h;
  h.field("division").add(number(p.plane)).add(p.axis.x).add(p.axis.y).add(p.axis.z);
  return h.digest().text();
}

std::string hashOf(const ConnectionParameters& p) {
  Hasher h;
  h.field("connections").add(number(p.make)).add(number(p.onDivision));
  if (p.strength) h.add(*p.strength);
  else h.add("shared");
  add(h, p.releaseDistance);
  return h.digest().text();
}

}  // namespace

std::vector<ScenePart> hashSceneParts(const Scene& scene) {
  const auto& m = scene.mechanics;
  const bool touches = m && m->contact, connects = m && m->connections;
  return {{"dna", hashOf(scene.dna)},
          {"cycle", hashOf(scene.cycle)},
          {"seed", hashOf(scene.seed)},
          {"physics", m ? hashOf(m->physics) : ""},
          {"physics.mesh", m ? hashOfMeshes(*m) : ""},
          {"physics.contact", touches ? hashOf(*m->contact) : ""},
          {"division", m ? hashOf(m->division) : ""},
          {"connections", connects ? hashOf(*m->connections) : ""}};
}

}  // namespace morula
