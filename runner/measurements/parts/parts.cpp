#include "parts/parts.h"

#include <fmt/format.h>

#include "document/words.h"
#include "loop/simulate.h"
#include "physics/integrator.h"

namespace morula {
namespace {

class Reasons {
 public:
  explicit Reasons(const Scenario& scenario) : scenario_(scenario) {}

  bool given(const std::string& path) const { return scenario_.places.contains(path); }

  /// Where the first of these that is given stands.
  std::string of(std::initializer_list<const char*> paths) const {
    for (const std::string path : paths)
      if (const auto place = scenario_.places.find(path); place != scenario_.places.end())
        return place->second + (place->second.ends_with(path) ? "" : ": " + path);
    return "default";
  }

 private:
  const Scenario& scenario_;
};

Part absent(const char* name, const std::string& key) { return {name, false, "", key}; }

/// What slows cells does not matter where none moves.
const char* ofMotion(const PhysicsParameters& p) {
  return kindOf(p.integrator).settles ? "without effect on where cells rest" : "";
}

void addModel(std::vector<Part>& parts, const PhysicsParameters& p, const Reasons& why) {
  if (!kindOf(p.cell.model).hasMembrane) {
    for (const char* name : {"springs", "damping", "pressure"})
      parts.push_back(absent(name, "physics.cell.model: shell"));
    parts.push_back(kindOf(p.cell.model).hasRestShape ? Part{"shape-matching", true, "", why.of({"physics.cell.model"})}
                                                      : absent("shape-matching", "physics.cell.model: shape-matching"));
    return;
  }
  parts.push_back({"springs", true, "", why.of({"physics.membrane.stiffness"})});
  parts.push_back(p.membrane.damping > 0 ? Part{"damping", true, ofMotion(p), why.of({"physics.membrane.damping"})}
                                         : absent("damping", "physics.membrane.damping > 0"));
  parts.push_back({"pressure", true, "", why.of({"physics.pressure"})});
  parts.push_back(absent("shape-matching", "physics.cell.model: shape-matching"));
}

void addBodies(std::vector<Part>& parts, const Scenario& scenario, const Reasons& why) {
  if (!scenario.scene.mechanics) {
    for (const char* name : {"bodies", "springs", "damping", "pressure", "shape-matching", "drag", "integration",
                             "motility", "growth", "shell"})
      parts.push_back(absent(name, "physics"));
    return;
  }
  const MechanicsScene& m = *scenario.scene.mechanics;
  const PhysicsParameters& p = m.physics;
  const bool spheres = !kindOf(p.cell.model).hasMesh;
  parts.push_back({"bodies", true,
                   fmt::format("{}{}{}", spheres ? "spheres" : fmt::format("{} vertices each", m.mesh.vertices.size()),
                               p.coarsen ? ", fewer when small" : "",
                               p.precision == Precision::binary32 ? ", in single precision" : ""),
                   spheres ? why.of({"physics.cell.model"}) : why.of({"physics.mesh", "physics"})});
  addModel(parts, p, why);
  parts.push_back(p.drag > 0 ? Part{"drag", true, ofMotion(p), why.of({"physics.drag"})}
                             : absent("drag", "physics.drag > 0"));
  parts.push_back({"integration", true,
                   fmt::format("{}, {}{}", kindOf(p.integrator).title,
                               p.timeStep                     ? "fixed time step"
                               : kindOf(p.integrator).settles ? "masses have no effect"
                                                              : "automatic time step",
                               p.substeps.value_or(1) > 1 ? fmt::format(" in {} sub-steps", *p.substeps) : ""),
                   why.of({"physics.integrator", "physics.time_step"})});
  parts.push_back(p.motility ? Part{"motility", true, "", why.of({"physics.motility"})}
                             : absent("motility", "physics.motility"));
  parts.push_back(p.growth ? Part{"growth", true, "", why.of({"physics.growth"})} : absent("growth", "physics.growth"));
  if (!p.shell) {
    parts.push_back(absent("shell", "physics.shell"));
    return;
  }
  if (p.shell->mesh) {
    parts.push_back(
        {"shell", true, fmt::format("mesh of {} planes", p.shell->mesh->planes.size()), why.of({"physics.shell"})});
    return;
  }
  const double* a = p.shell->semiAxes;
  parts.push_back({"shell", true, a[0] == a[1] && a[1] == a[2] ? "sphere" : "ellipsoid", why.of({"physics.shell"})});
}

void addContact(std::vector<Part>& parts, const Scenario& scenario, const RunAsk& ask, const Reasons& why) {
  const auto& mechanics = scenario.scene.mechanics;
  if (!mechanics || !mechanics->contact) {
    for (const char* name : {"contact", "friction", "adhesion", "search"})
      parts.push_back(absent(name, "physics.contact"));
    return;
  }
  const ContactParameters& c = *mechanics->contact;
  const bool thesis = c.law == ContactLaw::thesis;
  parts.push_back({"contact", true,
                   thesis                                           ? "the thesis' law"
                   : !kindOf(mechanics->physics.cell.model).hasMesh ? "of spheres"
                                                                    : "pair law",
                   why.of({"physics.contact.law", "physics.contact"})});
  parts.push_back(!thesis && c.friction > 0
                      ? Part{"friction", true, ofMotion(mechanics->physics), why.of({"physics.contact.friction"})}
                      : absent("friction", thesis ? "physics.contact.law: pair, and friction > 0"
                                                  : "physics.contact.friction > 0"));
  parts.push_back(c.adhesion
                      ? Part{"adhesion", true, c.adhesion->pairs.empty() ? "of all cells" : "by pairs of substances",
                             why.of({"physics.contact.adhesion"})}
                      : absent("adhesion", "physics.contact.adhesion"));
  parts.push_back({"search", true, nameOf(ask.search),
                   ask.search == ContactSearch::grid ? why.of({"physics.contact"}) : "--search"});
}

void addRecord(std::vector<Part>& parts, const Scenario& scenario, const RunAsk& ask, const Reasons& why) {
  const auto& record = scenario.record;
  parts.push_back(record.every
                      ? Part{"samples", true, fmt::format("every {:.6g}", *record.every), why.of({"record.every"})}
                      : Part{"samples", true, "start and end", "default"});
  parts.push_back(record.meshes ? Part{"surfaces", true, fmt::format("of all cells, every {:.6g}", *record.meshes),
                                       why.of({"record.meshes"})}
                                : absent("surfaces", "record.meshes"));
  const std::string golden = ask.golden.empty() ? "" : "golden file " + ask.golden;
  if (wantsHashes(scenario, !golden.empty()))
    parts.push_back({"hashes", true, "of the states on the way", golden.empty() ? why.of({"check"}) : golden});
  else parts.push_back(absent("hashes", "a golden file, or check"));
  parts.push_back(golden.empty() ? absent("golden", "morula review SCENARIO --accept")
                                 : Part{"golden", true, "the result against the accepted one", golden});
  if (!ask.pictures) parts.push_back(absent("pictures", "a run without --no-pictures"));
  else
    parts.push_back({"pictures", true,
                     record.pictures && scenario.scene.mechanics
                         ? fmt::format("at the end, and every {:.6g}", *record.pictures)
                         : "at the end",
                     why.of({"record.pictures"})});
}

std::string describeDivision(const DivisionParameters& division) {
  const std::size_t rules = division.rules.size();
  const char* turning = longestChirality(division) > 0 ? "; daughters turn against each other" : "";
  return std::string("across ") + kindOf(division.otherwise.plane).meaning +
         (rules == 0   ? ""
          : rules == 1 ? ", unless 1 rule says otherwise"
                       : fmt::format(", unless one of {} rules says otherwise", rules)) +
         turning;
}

}  // namespace

std::vector<Part> partsOf(const Scenario& scenario, const RunAsk& ask) {
  const Reasons why(scenario);
  const auto& mechanics = scenario.scene.mechanics;
  std::vector<Part> parts;
  const std::size_t genes = scenario.scene.dna.genes.size();
  const std::size_t senses = scenario.scene.senses.size();
  parts.push_back({"biology", true, counted(genes, "gene") + (senses > 0 ? ", " + counted(senses, "sense") : ""),
                   why.of({"dna.file", "dna"})});
  addBodies(parts, scenario, why);
  addContact(parts, scenario, ask, why);
  parts.push_back(mechanics && mechanics->connections ? Part{"connections", true, "", why.of({"connections"})}
                                                      : absent("connections", "connections"));
  parts.push_back(mechanics ? Part{"division", true, describeDivision(mechanics->division),
                                   why.of({"division.rules", "division.plane", "division"})}
                            : absent("division", "physics"));
  if (scenario.scene.variation != VariationParameters{})
    parts.push_back({"variation", true, "a seed makes cells differ", why.of({"variation"})});
  addRecord(parts, scenario, ask, why);
  return parts;
}

}  // namespace morula
