#include "pictures/pictures.h"

#include <fmt/format.h>

#include <set>

#include "base/error.h"
#include "document/words.h"
#include "drawing/png_file.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "files/text.h"
#include "files/write_file.h"
#include "observation/measures.h"
#include "organism/shell_wall.h"
#include "pictures/frame_file.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

constexpr int sequenceSize = 600;  // [pixel] smaller than the picture of the end, since there are many

}  // namespace

Colour Palette::colourOf(const CellPath& cell, const std::string& substances) {
  const CellColour* own = cellColourOf(scenario_, cell);
  if (!own) return colourOf(substances);
  const Colour colour = parseColour(own->colour);
  used_.emplace(own->text, colour);
  return colour;
}

Colour Palette::colourOf(const std::string& substances) {
  std::vector<Colour> colours;
  std::set<std::string> names;
  for (const std::string& substance : wordsOf(substances))
    if (const auto* entry = colourEntryOf(scenario_, substance)) {
      colours.push_back(parseColour(entry->second));
      names.insert(entry->first);
    }
  const Colour mixed = mixColours(colours);
  std::string label;
  for (const std::string& name : names) label += (label.empty() ? "" : " + ") + name;
  if (!label.empty()) used_.emplace(label, mixed);
  return mixed;
}

std::vector<LegendEntry> Palette::legend() const {
  std::vector<LegendEntry> entries;
  for (const auto& [names, colour] : used_) entries.push_back({colour, names});
  return entries;
}

namespace {

constexpr double shellOpacity = 0.15;  // opacity of a shell that is a mesh, which is drawn like a cell

/// Returns the surface with separate vertices for each face, so that edges are drawn; cells are drawn smooth. The copy
/// is the wall around the cells that the shell holds.
Mesh withEdges(const Mesh& mesh) {
  Mesh flat;
  for (const Face& face : mesh.faces) {
    const int first = static_cast<int>(flat.vertices.size());
    for (const int corner : face) flat.vertices.push_back(shellThickness * mesh.vertices[corner]);
    flat.faces.push_back({first, first + 1, first + 2});
  }
  return flat;
}

/// Makes the part that all pictures of the scenario share.
OrganismPicture blankPicture(const Scenario& scenario) {
  const auto& mechanics = *scenario.scene.mechanics;
  OrganismPicture picture;
  picture.faces = mechanics.mesh.faces;
  if (const auto& shell = mechanics.physics.shell; shell && !shell->mesh)
    picture.shell = Vector{shell->semiAxes[0], shell->semiAxes[1], shell->semiAxes[2]};
  if (const auto& shell = mechanics.physics.shell; shell && shell->mesh) picture.shellPlanes = shell->mesh->planes;
  picture.title = scenario.scene.name;
  return picture;
}

}  // namespace

void shareLegend(std::vector<OrganismPicture>& frames) {
  std::map<std::string, Colour> all;
  for (const auto& frame : frames)
    for (const auto& entry : frame.legend) all.emplace(entry.label, entry.colour);
  for (auto& frame : frames) {
    std::set<std::string> own;
    for (const auto& entry : frame.legend) own.insert(entry.label);
    frame.legend.clear();
    for (const auto& [label, colour] : all)
      frame.legend.push_back({colour, label, Marker::square, own.contains(label)});
  }
}

OrganismPicture pictureOf(const World& world, const Scenario& scenario) {
  Palette palette(scenario);
  OrganismPicture picture = blankPicture(scenario);
  for (std::size_t i = 0; i < world.cells.path.size(); ++i) {
    Mesh mesh = cellMesh(world, world.cells.path[i]);
    if (mesh.faces == picture.faces) mesh.faces.clear();
    picture.cells.push_back({world.cells.path[i].text(), std::move(mesh.vertices),
                             palette.colourOf(world.cells.path[i], world.biology->describe(world.cells.state[i])), 1,
                             std::move(mesh.faces)});
  }
  if (const auto& shell = scenario.scene.mechanics->physics.shell; shell && shell->mesh) {
    Mesh flat = withEdges(shell->mesh->mesh);
    picture.cells.push_back({"shell", std::move(flat.vertices), neutralGrey, shellOpacity, std::move(flat.faces)});
    picture.cells.back().isWall = true;
  }
  picture.legend = palette.legend();
  picture.caption =
      fmt::format("time {}, {}", shownTime(scenario.units, world.clock.time), counted(world.cells.path.size(), "cell"));
  return picture;
}

TreePicture lineagePictureOf(const std::vector<LineageEntry>& cells,
                             const std::function<std::string(StateId)>& describe, double end, const Scenario& scenario,
                             const std::vector<ExperimentRecord>& experiments) {
  Palette palette(scenario);
  TreePicture picture;
  const double perTime = shownUnit(scenario.units, "time").factor;
  picture.timeLabel = timeLabel(scenario.units);
  std::size_t alive = 0;
  for (const auto& cell : cells) {
    const auto substances = describe(cell.state);
    const bool lives = cell.fate == Fate::alive;
    alive += lives;
    picture.nodes.push_back({cell.path.text(), perTime * cell.born, perTime * (lives ? end : cell.ended), cell.fate,
                             palette.colourOf(cell.path, substances),
                             scenario.names.of(cell.path).value_or(substances)});
  }
  for (const ExperimentRecord& done : experiments) {
    if (done.to == DoneTo::all) picture.marks.push_back({std::nullopt, perTime * done.time});
    if (done.to == DoneTo::cell || done.to == DoneTo::pair)
      picture.marks.push_back({done.path.text(), perTime * done.time});
    if (done.to == DoneTo::pair) picture.marks.push_back({done.other.text(), perTime * done.time});
  }
  picture.title = scenario.scene.name;
  picture.caption =
      cells.size() == 1
          ? fmt::format("1 cell, {} at time {}", alive ? "alive" : "dead", shownTime(scenario.units, end))
          : fmt::format("{} cells, {} of them alive at time {}", cells.size(), alive, shownTime(scenario.units, end));
  picture.legend = palette.legend();
  return picture;
}

TreePicture lineagePictureOf(const World& world, const Scenario& scenario) {
  return lineagePictureOf(
      world.lineage.entries, [&](StateId state) { return world.biology->describe(state); }, world.clock.time, scenario,
      world.experiments.value_or(std::vector<ExperimentRecord>()));
}

ComparisonImages imagesBesideBullet(const World& world, const std::vector<std::vector<Point>>& shapes,
                                    const Scenario& scenario) {
  OrganismPicture ours = pictureOf(world, scenario);
  ours.width = ours.height = 700;
  OrganismPicture bullets = ours;
  ours.title += ": ours";
  bullets.title += ": Bullet's";
  for (std::size_t i = 0; i < bullets.cells.size(); ++i) bullets.cells[i].vertices = shapes[i];
  return compareOrganisms(ours, bullets, scenario.scene.mechanics->physics.cell.radius);
}

void FrameCollector::see(const World& world) {
  if (!isOn_ || !world.bodies) return;
  const bool due = due_.isDue(world.clock.time);
  if (!reaches(world.cells.path.size()) && !due) return;
  frames_.push_back(pictureOf(world, scenario_));
  if (due) due_.pass(world.clock.time);
}

std::uint64_t FrameCollector::stepsUntilDue(const World& world) const {
  // The number of cells changes only with the last of several steps that are made at once.
  return world.bodies && isOn_ ? stepsUntil(world.clock, *due_.next()) : neverDue;
}

bool FrameCollector::reaches(std::size_t cells) {
  const auto& numbers = scenario_.record.atCells;
  const std::size_t before = reached_;
  while (reached_ < numbers.size() && cells >= numbers[reached_]) ++reached_;
  return reached_ > before;
}

void FrameCollector::resume(const World& world, const Resumed& earlier) {
  if (!isOn_ || !world.bodies) return;
  for (const std::string& bytes : earlier.frames) {
    frames_.push_back(pictureFrom(bytes, blankPicture(scenario_)));
    reaches(frames_.back().cells.size());
  }
  reaches(world.cells.path.size());  // pictures of a run that had ended are not kept
  due_.pass(world.clock.time);
}

namespace {

/// Returns the number of "0007.png"; absent for other names.
std::optional<std::size_t> frameNumber(const fs::path& name) {
  const std::string digits = name.stem().string();
  const bool isFrame = name.extension() == ".png" && digits.size() >= 4 && digits.size() <= 9 &&
                       digits.find_first_not_of("0123456789") == digits.npos;
  return isFrame ? std::optional<std::size_t>(std::stoul(digits)) : std::nullopt;
}

/// Removes pictures of an earlier, longer run of the same name. Other files in the folder stay.
void removeFramesFrom(const fs::path& folder, std::size_t first) {
  for (const fs::path& name : namesIn(folder)) {
    const auto number = frameNumber(name);
    if (number && *number >= first && isOwnPng(readHead(folder / name, 64))) removeFile(folder / name);
  }
}

}  // namespace

void writePicture(const Drawing& drawing, const fs::path& file) {
  writeFile(file, drawing.file(pictureFormat(file).value()), Content::picture);
}

void writePicture(const Image& image, const fs::path& file) { writeFile(file, pngFile(image), Content::picture); }

std::string endingOf(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

std::optional<PictureFormat> pictureFormat(const fs::path& file) {
  const std::string ending = endingOf(file);
  if (ending == ".svg") return PictureFormat::svg;
  if (ending == ".pdf") return PictureFormat::pdf;
  return ending.empty() || ending == ".png" ? std::optional(PictureFormat::png) : std::nullopt;
}

std::vector<std::string> writePictures(const World& world, const Scenario& scenario, FrameCollector& collector,
                                       const fs::path& folder) {
  std::vector<std::string> files;
  const auto write = [&](const auto& picture, const fs::path& name) {
    files.push_back((folder / name).string());
    writePicture(picture, files.back());
  };
  if (world.bodies) {
    const auto picture = pictureOf(world, scenario);
    write(drawOrganism(picture), "organism.png");
    write(drawOrganism(picture, Style::wireframe), "wireframe.png");
  }
  write(drawLineage(lineagePictureOf(world, scenario)), "lineage.png");

  auto& frames = collector.frames();
  if (frames.empty()) return files;
  makeFolder(folder / "sequence");
  shareLegend(frames);
  removeFramesFrom(folder / "sequence", frames.size());
  const auto framing = fitFraming(frames);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].camera.framing = framing;
    frames[i].width = frames[i].height = sequenceSize;
    write(drawOrganism(frames[i]), fs::path("sequence") / fmt::format("{:04}.png", i));
  }
  return files;
}

}  // namespace morula
