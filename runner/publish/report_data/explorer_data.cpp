#include "report_data/explorer_data.h"

#include <algorithm>
#include <cstdio>

#include "drawing/palette.h"
#include "files/printable.h"
#include "pictures/pictures.h"
#include "report_data/run_words.h"
#include "values/measure_list.h"
#include "views/picture_maker.h"

namespace morula {
namespace {

constexpr std::size_t colourSteps = 33;  // number of colours in the scale

std::string hex(Colour colour) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", colour.r, colour.g, colour.b);
  return text;
}

/// Returns faces as one flat list of numbers.
Json flat(const std::vector<Face>& faces) {
  Json numbers = Json::array();
  for (const Face& face : faces)
    for (const auto vertex : face) numbers.push_back(vertex);
  return numbers;
}

Json flat(const std::vector<Point>& points) {
  Json numbers = Json::array();
  for (const Point& p : points)
    for (const double x : {p.x, p.y, p.z}) numbers.push_back(x);
  return numbers;
}

Json shellOf(const Scenario& scenario) {
  if (!scenario.scene.mechanics || !scenario.scene.mechanics->physics.shell) return {};
  const auto& shell = *scenario.scene.mechanics->physics.shell;
  if (!shell.mesh) return {{"axes", {shell.semiAxes[0], shell.semiAxes[1], shell.semiAxes[2]}}};
  return {{"vertices", flat(shell.mesh->mesh.vertices)}, {"faces", flat(shell.mesh->mesh.faces)}};
}

/// The states that any cell of the run had, with their substances and colours.
class States {
 public:
  explicit States(const ExplorerRun& run) : run_(run), palette_(*run.scenario) {
    if (run.frames)
      for (const StateId state : run.frames->states) number(state);
  }
  std::size_t number(StateId state) {
    const auto [entry, isNew] = numbers_.emplace(state, numbers_.size());
    if (!isNew) return entry->second;
    const std::string substances = run_.describe(state);
    texts_.push_back(printableLine(substances));
    colours_.push_back(hex(palette_.colourOf(substances)));
    return entry->second;
  }
  /// Returns the colour that the scenario gives this cell; "" if it gives none.
  std::string ownColour(const LineageEntry& cell) {
    return cellColourOf(*run_.scenario, cell.path) ? hex(palette_.colourOf(cell.path, run_.describe(cell.state))) : "";
  }
  void addTo(Json& json) const {
    json["states"] = texts_, json["colours"] = colours_;
    json["legend"] = Json::array();
    for (const LegendEntry& e : palette_.legend()) json["legend"].push_back({printableLine(e.label), hex(e.colour)});
  }

 private:
  const ExplorerRun& run_;
  Palette palette_;
  std::map<StateId, std::size_t> numbers_;
  Json texts_ = Json::array(), colours_ = Json::array();
};

// Version of the explorer's data and of frames.h; the explorer rejects others (reports/explorer/src/data.ts).
constexpr int explorerFormat = 5;

/// Returns the cells that ever lived, a row of each, and the colours that the scenario gives single cells.
Json cellsOf(const ExplorerRun& run, States& states) {
  Json cells = Json::array(), own = Json::object();
  for (std::size_t i = 0; i < std::min(run.lineage->size(), maxTreeCells); ++i) {
    const LineageEntry& cell = (*run.lineage)[i];
    const auto called = run.scenario->names.of(cell.path);
    cells.push_back({cell.path.text(), called ? printableLine(*called) : "", cell.born,
                     cell.fate == Fate::alive ? run.end : cell.ended, name(cell.fate), states.number(cell.state)});
    if (const std::string colour = states.ownColour(cell); !colour.empty()) own[cell.path.text()] = colour;
  }
  return {{"cells", std::move(cells)}, {"cellColours", std::move(own)}};
}

/// `meshes`: the meshes of all runs, each once.
Json dataOf(const ExplorerRun& run, std::vector<FrameMesh>& meshes) {
  Json json{
      {"title", printableLine(run.title)}, {"scenario", printableLine(run.scenario->scene.name)}, {"end", run.end}};
  States states(run);
  cellsOf(run, states);  // numbers the states
  states.addTo(json);
  json["shell"] = shellOf(*run.scenario);
  json["radius"] = run.scenario->scene.mechanics ? run.scenario->scene.mechanics->physics.cell.radius : 1;
  json["measures"] = Json::array(), json["frames"] = Json::array(), json["meshes"] = Json::array();
  json["forces"] = Json::array(), json["netForces"] = Json::array();
  if (!run.frames) return json;
  json["measures"] = run.frames->measures;
  for (const ForceKind kind : run.frames->forces) json["forces"].push_back(nameOf(kind));
  for (const ForceKind kind : kindsWithNetForce(run.frames->forces)) json["netForces"].push_back(nameOf(kind));
  for (const FrameMesh& mesh : run.frames->meshes) {
    const auto known = std::ranges::find(meshes, mesh);
    json["meshes"].push_back(known - meshes.begin());
    if (known == meshes.end()) meshes.push_back(mesh);
  }
  for (const Frame& f : run.frames->frames)
    json["frames"].push_back({f.time, f.step, f.cells, f.contacts, f.connections, f.bytes.size(), f.vertexForces});
  return json;
}

}  // namespace

void addPalette(Json& data) {
  data["scale"] = Json::array(), data["series"] = Json::array();
  for (std::size_t i = 0; i < colourSteps; ++i)
    data["scale"].push_back(hex(scaleColour(double(i) / (colourSteps - 1))));
  for (std::size_t i = 0; i < manySeries; ++i) data["series"].push_back(hex(seriesColour(i)));
  for (const char* founder : {"", "A", "B", "AA", "AB", "BA", "BB"})
    data["clones"][founder] = hex(cloneColour(founder));
}

Json explorerData(const std::vector<ExplorerRun>& runs) {
  const Units units = unitsOfAll(runs, [](const ExplorerRun& r) { return r.scenario->units; });
  Json json{{"morula", explorerFormat}, {"units", shownUnits(units)}, {"scale", Json::array()},
            {"series", Json::array()},  {"forces", Json::array()},    {"runs", Json::array()}};
  addPalette(json);
  for (const auto& kind : choices<ForceKind>)
    json["forces"].push_back({kind.name, hex(forceColour(kind.value)), kind.meaning});
  std::vector<FrameMesh> meshes;
  for (const ExplorerRun& run : runs) json["runs"].push_back(dataOf(run, meshes));
  json["meshes"] = Json::array(), json["balls"] = Json::array();
  for (const FrameMesh& mesh : meshes) json["meshes"].push_back(flat(mesh.faces)), json["balls"].push_back(flat(mesh.ball));
  return json;
}

std::vector<PageBytes> explorerBytes(const std::vector<ExplorerRun>& runs) {
  std::vector<PageBytes> all;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    PageBytes bytes{"frames-" + std::to_string(i), ""};
    if (runs[i].frames && !runs[i].frames->frames.empty()) bytes.bytes = packedFrames(*runs[i].frames);
    all.push_back(std::move(bytes));
    States states(runs[i]);
    all.push_back({"cells-" + std::to_string(i), deflated(jsonText(cellsOf(runs[i], states)))});
  }
  return all;
}

std::string thinnedText(const std::vector<ExplorerRun>& runs) {
  std::vector<std::size_t> kept;
  std::size_t taken = 0;
  std::string title;
  for (const ExplorerRun& run : runs)
    if (const Frames* f = run.frames; f && !f->frames.empty() && f->frames.size() < f->worlds.size()) {
      kept.push_back(f->frames.size());
      taken = f->worlds.size();
      title = run.title;
    }
  if (kept.empty()) return "";
  const auto [least, most] = std::ranges::minmax(kept);
  return (kept.size() == 1 ? title : counted(kept.size(), "run")) + ": " + std::to_string(least) +
         (least < most ? " to " + std::to_string(most) : "") + " of " + std::to_string(taken) +
         " frames fit into the page";
}

Document leftOutOf(const std::vector<ExplorerRun>& runs) {
  Document all;
  const auto say = [&](const ExplorerRun& run, const std::string& what) {
    all.note((runs.size() > 1 ? run.title + ": " : "") + what);
  };
  for (const ExplorerRun& run : runs) {
    if (run.lineage->size() > maxTreeCells)
      say(run, "The tree shows the " + std::to_string(maxTreeCells) + " cells that were born first, of " +
                   std::to_string(run.lineage->size()) + ".");
    if (!run.scenario->scene.mechanics)
      say(run, "These cells have no bodies: there is a tree, and nothing to see in three dimensions.");
    if (run.frames && run.frames->frames.empty() && !run.frames->worlds.empty())
      say(run, "One frame alone would make the page too large: a larger --size-limit shows it in three dimensions.");
    if (run.frames && run.frames->coarser > 0)
      say(run, "In frames with more than " + std::to_string(maxDrawnVertices) +
                   " vertices cells are drawn with fewer vertices than they have, with the same volumes; "
                   "morula export --format ply has all.");
  }
  if (const std::string thinned = thinnedText(runs); !thinned.empty())
    all.note("Thinned: " + thinned + "; a larger --size-limit keeps more.");
  return all;
}

}  // namespace morula
