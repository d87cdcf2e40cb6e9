#include "parts/parts.h"

#include <fmt/format.h>

#include "document/words.h"
#include "loop/simulate.h"
#include "physics/integrator.h"

namespace morula {
namespace {

using Paths = std::initializer_list<const char*>;

class PartList {
 public:
  explicit PartList(const Scenario& scenario) : scenario_(scenario) {}

  /// Adds an engaged part. `asks`: keys that ask for it; the first given one is told.
  void add(const char* name, const std::string& what, Paths asks) { parts.push_back({name, true, what, whyOf(asks)}); }
  /// Adds a part that is engaged; otherwise tells by `needs` what would engage it.
  void add(const char* name, bool engaged, const std::string& what, Paths asks, const std::string& needs) {
    if (engaged) add(name, what, asks);
    else absent({name}, needs);
  }
  void absent(Paths names, const std::string& needs) {
    for (const char* name : names) parts.push_back({name, false, "", needs});
  }

  std::vector<Part> parts;

 private:
  std::string whyOf(Paths paths) const {
    for (const std::string path : paths)
      if (const auto place = scenario_.places.find(path); place != scenario_.places.end())
        return place->second + (place->second.ends_with(path) ? "" : ": " + path);
    return "default";
  }

  const Scenario& scenario_;
};

/// Returns the remark on parts that slow cells: in settling scenes they do not change where cells rest.
const char* ofMotion(const PhysicsParameters& p) {
  return kindOf(p.integrator).settles ? "without effect on where cells rest" : "";
}

void addModel(PartList& list, const PhysicsParameters& p) {
  const CellModelKind& model = kindOf(p.cell.model);
  if (model.hasMembrane) {
    list.add("springs", "", {"physics.membrane.stiffness"});
    list.add("damping", p.membrane.damping.acts(), ofMotion(p), {"physics.membrane.damping"},
             "physics.membrane.damping > 0");
    list.add("bending", p.membrane.bending > 0, "", {"physics.membrane.bending"}, "physics.membrane.bending > 0");
    list.add("pressure", "", {"physics.pressure"});
  } else {
    list.absent({"springs", "damping", "bending", "pressure"}, "physics.cell.model: shell");
  }
  list.add("shape-matching", model.hasRestShape, "", {"physics.cell.model"}, "physics.cell.model: shape-matching");
}

std::string shapeOf(const ShellParameters& shell) {
  if (shell.mesh) return fmt::format("mesh of {} planes", shell.mesh->planes.size());
  const double* a = shell.semiAxes.data();
  return a[0] == a[1] && a[1] == a[2] ? "sphere" : "ellipsoid";
}

void addBodies(PartList& list, const Scenario& scenario) {
  if (!scenario.scene.mechanics)
    return list.absent({"bodies", "springs", "damping", "bending", "pressure", "shape-matching", "drag", "integration",
                        "motility", "growth", "shell"},
                       "physics");
  const MechanicsScene& m = *scenario.scene.mechanics;
  const PhysicsParameters& p = m.physics;
  const bool spheres = !kindOf(p.cell.model).hasMesh;
  const std::string shape = spheres ? "spheres" : fmt::format("{} vertices each", m.mesh.vertices.size());
  const std::string bodies = shape + (p.coarsen ? ", fewer when small" : "") +
                             (p.precision == Precision::binary32 ? ", in single precision" : "");
  if (spheres) list.add("bodies", bodies, {"physics.cell.model"});
  else list.add("bodies", bodies, {"physics.mesh", "physics"});
  addModel(list, p);
  list.add("drag", p.drag > 0, ofMotion(p), {"physics.drag"}, "physics.drag > 0");
  list.add("integration",
           fmt::format("{}, {}{}", kindOf(p.integrator).title,
                       p.timeStep                     ? "fixed time step"
                       : kindOf(p.integrator).settles ? "masses have no effect"
                                                      : "automatic time step",
                       p.substeps.value_or(1) > 1 ? fmt::format(" in {} sub-steps", *p.substeps) : ""),
           {"physics.integrator", "physics.time_step"});
  list.add("motility", p.motility.has_value(), "", {"physics.motility"}, "physics.motility");
  list.add("growth", p.growth.has_value(), "", {"physics.growth"}, "physics.growth");
  list.add("shell", p.shell.has_value(), p.shell ? shapeOf(*p.shell) : "", {"physics.shell"}, "physics.shell");
}

void addContact(PartList& list, const Scenario& scenario, const RunAsk& ask) {
  const auto& mechanics = scenario.scene.mechanics;
  if (!mechanics || !mechanics->contact)
    return list.absent({"contact", "viscosity", "adhesion", "search"}, "physics.contact");
  const ContactParameters& c = *mechanics->contact;
  const bool thesis = c.law == ContactLaw::thesis;
  list.add("contact",
           thesis                                           ? "the thesis' law"
           : !kindOf(mechanics->physics.cell.model).hasMesh ? "of spheres"
                                                            : "pair law",
           {"physics.contact.law", "physics.contact"});
  list.add("viscosity", !thesis && c.viscosity > 0, ofMotion(mechanics->physics), {"physics.contact.viscosity"},
           thesis ? "physics.contact.law: pair, and viscosity > 0" : "physics.contact.viscosity > 0");
  list.add("adhesion", c.adhesion.has_value(),
           c.adhesion && c.adhesion->pairs.empty() ? "of all cells" : "by pairs of substances",
           {"physics.contact.adhesion"}, "physics.contact.adhesion");
  list.add("search", nameOf(ask.search), {"physics.contact"});
  if (ask.search != ContactSearch::grid) list.parts.back().why = "--search";
}

void addRecord(PartList& list, const Scenario& scenario, const RunAsk& ask) {
  const auto& record = scenario.record;
  const auto every = [](const std::optional<double>& time) { return fmt::format("every {:.6g}", time.value_or(0)); };
  list.add("samples", record.every ? every(record.every) : "start and end", {"record.every"});
  list.add("surfaces", record.meshes.has_value(), "of all cells, " + every(record.meshes), {"record.meshes"},
           "record.meshes");
  const std::string golden = ask.golden.empty() ? "" : "golden file " + ask.golden;
  list.add("hashes", wantsHashes(scenario, !golden.empty()), "of the states on the way", {"check"},
           "a golden file, or check");
  if (!golden.empty()) list.parts.back().why = golden;
  list.add("golden", !golden.empty(), "comparison with the accepted result", {}, "morula review SCENARIO --accept");
  if (!golden.empty()) list.parts.back().why = golden;
  list.add("pictures", ask.pictures,
           record.pictures && scenario.scene.mechanics ? "at the end, and " + every(record.pictures) : "at the end",
           {"record.pictures"}, "a run without --no-pictures");
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
  const auto& mechanics = scenario.scene.mechanics;
  PartList list(scenario);
  const std::size_t genes = scenario.scene.dna.genes.size();
  const std::size_t senses = scenario.scene.senses.size();
  list.add("biology", counted(genes, "gene") + (senses > 0 ? ", " + counted(senses, "sense") : ""),
           {"dna.file", "dna"});
  addBodies(list, scenario);
  addContact(list, scenario, ask);
  list.add("connections", mechanics && mechanics->connections, "", {"connections"}, "connections");
  list.add("division", mechanics.has_value(), mechanics ? describeDivision(mechanics->division) : "",
           {"division.rules", "division.plane", "division"}, "physics");
  if (scenario.scene.variation != VariationParameters{}) list.add("variation", "the seed varies cells", {"variation"});
  addRecord(list, scenario, ask);
  return std::move(list.parts);
}

}  // namespace morula
