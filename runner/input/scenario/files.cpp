#include "base/error.h"
#include "biology/substances.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "mesh/mesh_measures.h"
#include "scenario/loading.h"

namespace morula {

std::filesystem::path sharedFolder(const std::filesystem::path& folder) {
  for (auto at = absolutePath(folder); at.has_relative_path(); at = at.parent_path())
    if (at.filename() == "scenarios") return at;
  return folder;
}

namespace scenario {

namespace {

constexpr int coarsestLevel = 2;  // a sphere's area on 42 vertices is off by more than 1 %

/// Calls `read` and turns its InputErrors into problems; each line of an error names its own place.
template <class Read>
void guarded(Problems& problems, const Place& place, Read read) {
  try {
    read();
  } catch (const InputError& error) { problems.addForeign(place, error.what()); }
}

/// Adds a file that the scenario names to its files, and returns it; null and a problem if it cannot be read. The
/// content may reach messages and the database, so a stranger's scenario must not read files of others.
const NamedFile* readNamedFile(Scenario& scenario, const std::string& role, const std::string& name, const Place& place,
                               const Places& places, Problems& problems) {
  for (const auto& stored : places.stored)
    if (stored.role == role) return &scenario.files.emplace_back(stored);
  const auto path = role == "dna"         ? "dna.file"
                    : role == "cells"     ? "cells.file"
                    : role == "names"     ? "names.file"
                    : role == "reference" ? "check.reference.file"
                    : role == "shell"     ? "physics.shell.mesh"
                                          : "physics.mesh.file";
  if (places.folder.empty()) {
    problems.add(place, path, "'" + name + "' is not stored with the scenario",
                 "a stored scenario reads no other files");
    return nullptr;
  }
  try {
    const auto file = (places.folder / name).lexically_normal();
    if (!places.allowOutside && !liesWithin(file, sharedFolder(places.folder))) {
      problems.add(place, path, "'" + name + "' lies outside of the scenario's folder",
                   "move it there, or give --allow-outside if you trust this scenario with your files");
      return nullptr;
    }
    return &scenario.files.emplace_back(NamedFile{role, file.string(), readFile(file)});
  } catch (const FileError& error) {
    problems.add(place, path, error.what(), "names count from the scenario's folder");
    return nullptr;
  }
}

/// Returns the scenario's uses of substances outside its DNA.
DnaSurroundings surroundingsOf(const Scenario& scenario, const Reading& reading) {
  DnaSurroundings around;
  for (const SubstanceUse& use : reading.substances) {
    if (use.path.starts_with("cells")) around.given.insert(use.name);
    else around.read.push_back(use.name);
  }
  around.read.insert(around.read.end(), reading.measured.begin(), reading.measured.end());
  around.sensed = reading.senses;
  const auto& mechanics = scenario.scene.mechanics;
  if (!mechanics) return around;  // a DNA made for bodies may run as a lineage alone
  if (!mechanics->physics.growth)
    for (const auto& name : {substance::grow, substance::shrink})
      around.inert[name] =
          "cells neither grow nor shrink without physics.growth; add 'growth: {}' to physics, or remove this";
  for (const auto& name : {substance::connect, substance::release})
    if (!mechanics->connections)
      around.inert[name] =
          "cells do not connect without a section connections; add 'connections: {make: by-gene}', "
          "or remove this";
    else if (mechanics->connections->make == MakeConnections::atDivision)
      around.inert[name] = "connections.make is at-division; set it to by-gene or both, or remove this";
  return around;
}

void readDna(Scenario& scenario, const Reading& reading, const Places& places) {
  const DnaSource& dna = reading.dna;
  Problems& problems = reading.problems;
  const DnaSurroundings around = surroundingsOf(scenario, reading);
  const auto parse = [&](const std::string& text, const std::string& file, int line = 1, int column = 1,
                         const std::string& path = "") {
    scenario.scene.dna = parseDna(text, file, line, column, path, &around);
  };
  if (dna.file) {
    if (const auto* file = readNamedFile(scenario, "dna", *dna.file, dna.place, places, problems))
      guarded(problems, dna.place, [&] { parse(file->content, file->path); });
  } else if (dna.text) {
    const Node& text = *dna.text;
    guarded(problems, text.place, [&] {
      const auto& place = text.place;
      if (!place.option.empty()) parse(text.text, place.option);
      else if (text.style == '|') parse(text.text, problems.file(), place.line + 1, text.textColumn, "dna");
      else
        // DNA in quotes has no lines in the file; line numbers within the text still help.
        parse(text.text, problems.file() + ":" + std::to_string(place.line) + ": dna");
    });
  }
}

void readMesh(Scenario& scenario, const Node& root, Problems& problems, const Places& places) {
  auto& mechanics = *scenario.scene.mechanics;
  if (scenario.mesh.icosphere) {
    const int level = static_cast<int>(*scenario.mesh.icosphere);
    mechanics.mesh = makeIcosphere(level);
    if (mechanics.physics.coarsen)
      for (int i = level - 1; i >= coarsestLevel; --i) mechanics.coarser.push_back(makeIcosphere(i));
  } else if (scenario.mesh.file) {
    const auto& place = root.find("physics")->value.find("mesh")->value.find("file")->value.place;
    if (const auto* file = readNamedFile(scenario, "mesh", *scenario.mesh.file, place, places, problems))
      guarded(problems, place, [&] { mechanics.mesh = readObj(file->content, file->path); });
  }
  const double radius = mechanics.physics.cell.radius;
  if (!mechanics.mesh.faces.empty()) mechanics.mesh = scaleToRadius(std::move(mechanics.mesh), radius);
  for (auto& mesh : mechanics.coarser) mesh = scaleToRadius(std::move(mesh), radius);
}

/// Reads the shell's mesh; the shell stays without a mesh if the file cannot be read.
void readShell(Scenario& scenario, const Node& root, Problems& problems, const Places& places) {
  if (!scenario.shellMesh || !scenario.scene.mechanics->physics.shell) return;
  const auto& place = root.find("physics")->value.find("shell")->value.find("mesh")->value.place;
  if (const auto* file = readNamedFile(scenario, "shell", *scenario.shellMesh, place, places, problems))
    guarded(problems, place, [&] {
      scenario.scene.mechanics->physics.shell->mesh =
          std::make_shared<ConvexShell>(readConvexShell(file->content, file->path));
    });
}

}  // namespace

void readReferences(Scenario& scenario, Reading& reading, const Node& root, const Places& places) {
  if (const auto& cells = reading.cellsFile)
    if (const auto* file = readNamedFile(scenario, "cells", cells->first, cells->second, places, reading.problems))
      guarded(reading.problems, cells->second,
              [&] { readStartCellTable(file->content, file->path, cells->second, scenario, reading); });
  readDna(scenario, reading, places);
  if (scenario.scene.mechanics) {
    readMesh(scenario, root, reading.problems, places);
    readShell(scenario, root, reading.problems, places);
    fitShell(scenario);
  }
  if (const auto& names = reading.namesFile)
    if (const auto* file = readNamedFile(scenario, "names", names->first, names->second, places, reading.problems))
      readCellNames(file->content, file->path, names->second, scenario, reading);
  const NamedFile* reference = nullptr;
  if (reading.reference && reading.reference->file) {
    const Node& file = *reading.reference->file;
    reference = readNamedFile(scenario, "reference", file.text, file.place, places, reading.problems);
  }
  readReference(reference, scenario, reading);
  readRuleCells(scenario, reading);
  readCellColours(scenario, reading);
  readRecordMeasures(scenario, reading);
  readExperiments(scenario, reading);
  readStopWhen(scenario, reading);
}

}  // namespace scenario

}  // namespace morula
