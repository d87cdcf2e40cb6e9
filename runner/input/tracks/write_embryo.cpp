#include "tracks/write_embryo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "files/printable.h"
#include "files/text.h"
#include "mesh/mesh.h"
#include "scenario/scenario.h"
#include "tracks/settings.h"
#include "tracks/wording.h"
#include "yaml/problems.h"

namespace morula::tracks {
namespace {

constexpr std::size_t maxNames = 60;  // more stand in a file of their own

class Writer {
 public:
  Writer(const Embryo& e, const EmbryoOptions& options, const std::string& stem, const std::string& table,
         const std::string& heading)
      : e_(e), options_(options), stem_(stem), table_(table), heading_(heading), cells_(e.lineage.cells) {}

  std::vector<EmbryoFile> write() {
    for (const Stage& stage : e_.stages)
      if (stage.places.size() >= 3 && e_.hasBodies) stages_.push_back(&stage);
    hasNamesFile_ =
        e_.names.given.size() > maxNames || !std::ranges::equal(cells_, e_.substance, {}, &TrackedCell::name);
    files_.push_back({"scenario", stem_ + ".yaml", scenario()});
    files_.push_back({"dna", stem_ + ".dna", dna()});
    if (hasNamesFile_) files_.push_back({"names", stem_ + "-names.txt", names()});
    if (e_.shell && e_.areSpheres) files_.push_back({"shell", stem_ + "-shell.obj", shell()});
    for (const Stage* stage : stages_)
      files_.push_back({"reference", fmt::format("real/{}.txt", stage->cells), reference(*stage)});
    return std::move(files_);
  }

 private:
  std::string time(double a) const { return numberText(a, 8); }

  std::string scenario() const {
    std::string text =
        heading_ +
        comment(fmt::format("{} of {}.{}", e_.start.empty() ? cells_[0].name + " and its descendants" : "The cells",
                            table_, e_.assumed.empty() ? "" : " What was assumed:"));
    const bool hasAxes = std::ranges::any_of(e_.division, [](const Division& d) { return d.axis.has_value(); });
    for (const std::string& sentence : e_.assumed) text += comment("- " + sentence + ".");
    text += fmt::format("morula: 1\nname: {}\nsummary: {}\nseed: 1\n\n", yamlName(),
                        yamlText(fmt::format("{} tracked cells, with their times{}", cells_.size(),
                                             hasAxes ? " and axes of division" : "")));
    text +=
        "dna: {file: " + yamlText(stem_ + ".dna") + "}  # a substance for each cell, which it holds while it lives\n";
    if (!e_.start.empty()) text += start();
    text += "\n" + cycle() + "\n" + units();
    if (e_.hasBodies) text += physics() + division();
    return text + nameTable() + record();
  }

  std::string yamlName() const {
    std::string name = stem_;
    for (char& c : name)
      if (!isMadeOf({&c, 1}, "-_")) c = '-';
    return name.empty() || name[0] == '-' ? "tracks" + name : name;
  }

  std::string start() const {
    std::string text = "cells:\n";
    for (std::size_t i = 0; i < e_.start.size(); ++i)
      text += fmt::format("  - {{at: {}, scale: {}, substances: [{}]}}\n", triple(e_.start[i].first),
                          rounded(e_.start[i].second, 4), word(e_.substance[i]));
    return text;
  }

  std::string cycle() const {
    std::vector<std::string> lives;
    for (std::size_t i = 0; i < cells_.size(); ++i)
      if (cells_[i].hasEnd()) lives.push_back(word(e_.substance[i]) + ": " + time(e_.life[i]));
    std::string text =
        fmt::format("cycle:\n  length: {}  # of cells that have no end in the table: nothing happens to them\n",
                    time(std::ceil(e_.stop) + 1));
    if (lives.empty()) return text + stop();
    return text + "  first: at-birth\n  per-substance: " + flow(lives, '{', '}') + "\n" + stop();
  }

  std::string stop() const { return "stop: {time: " + time(e_.stop) + "}\n"; }

  std::string units() const {
    const Units& u = options_.units;
    return fmt::format("units: {{length: {}, per-length: {}, time: {}, per-time: {}}}\n", word(u.length),
                       numberText(e_.length * u.perLength, 5), word(u.time), numberText(e_.time * u.perTime, 8));
  }

  std::string physics() const {
    std::string text = "\nphysics:\n";
    text += e_.areSpheres ? "  cell: {model: sphere, radius: " + rounded(e_.egg) + ", mass: 1}\n"
                          : "  mesh: {icosphere: 2}\n"
                            "  cell: {radius: 1, mass: 1}\n"
                            "  membrane: {stiffness: 10, damping: 0.02}\n"
                            "  pressure: {constant: 828, outside: 192}\n";
    text += "  drag: 10\n  contact: {stiffness: 30, damping: 0.02}\n";
    if (e_.shell && e_.areSpheres) text += "  shell: {mesh: " + yamlText(stem_ + "-shell.obj") + "}\n";
    else if (e_.shell)
      text += fmt::format(
          "  shell: {{ellipsoid: [{}, {}, {}], fill: {}}}  # a shape, and the share of it that cells fill\n",
          numberText((*e_.shell)[0]), numberText((*e_.shell)[1]), numberText((*e_.shell)[2]), rounded(e_.fill));
    else if (e_.start.empty()) text += fmt::format("  shell: {{sphere: 1, fill: {}}}\n", rounded(e_.fill));
    return text + "\n";
  }

  /// The ellipsoid as a polyhedron, whose faces touch balls where they are.
  std::string shell() const {
    std::string text = comment(fmt::format("The shell of {}.yaml, in its lengths.", stem_));
    const Mesh sphere = makeIcosphere(2);
    for (const Point& p : sphere.vertices)
      text += fmt::format("v {:.4f} {:.4f} {:.4f}\n", p.x * (*e_.shell)[0] / e_.length,
                          p.y * (*e_.shell)[1] / e_.length, p.z * (*e_.shell)[2] / e_.length);
    for (const auto& face : sphere.faces) text += fmt::format("f {} {} {}\n", face[0] + 1, face[1] + 1, face[2] + 1);
    return text;
  }

  std::string division() const {
    std::string rules;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const auto& [axis, share] = e_.division[i];
      if (!axis && !share) continue;
      rules += "    - {of: " + word(e_.substance[i]) + (axis ? ", axis: " + triple(*axis) : "") +
               (share ? ", share: " + rounded(*share) : "") + "}\n";
    }
    const bool divides = std::ranges::any_of(cells_, [](const TrackedCell& c) { return !c.daughters.empty(); });
    const std::string plane = e_.areSpheres ? "random" : "longest";
    if (!divides) return e_.areSpheres ? "division: {plane: random}\n\n" : "";
    if (rules.empty()) return "division: {plane: " + plane + "}\n\n";
    return "division:\n  plane: " + plane + "\n  rules:  # axes point to daughter A, and shares are hers\n" + rules +
           "\n";
  }

  std::string nameTable() const {
    if (hasNamesFile_ && e_.names.daughters.empty()) return "names: {file: " + yamlText(stem_ + "-names.txt") + "}\n";
    std::string text = "names:\n";
    if (hasNamesFile_) text += "  file: " + yamlText(stem_ + "-names.txt") + "\n";
    if (!e_.names.daughters.empty())
      text += "  daughters: [" + word(e_.names.daughters[0]) + ", " + word(e_.names.daughters[1]) + "]\n";
    if (hasNamesFile_) return text;
    std::vector<std::string> given;
    for (const auto& [path, name] : e_.names.given)
      if (path.isEgg()) text += "  egg: " + word(name) + "\n";
      else given.push_back(path.text() + ": " + word(name));
    return given.empty() ? text : text + "  cells: " + flow(given, '{', '}') + "\n";
  }

  std::string names() const {
    std::string text = comment("Names of the cells of " + stem_ + ".yaml by their lineage paths.");
    for (const auto& [path, name] : e_.names.given) text += (path.isEgg() ? "egg" : path.text()) + " " + name + "\n";
    return text;
  }

  std::string record() const {
    std::vector<std::string> counts;
    for (const Stage& stage : e_.stages)
      if (stage.cells > e_.lineage.founders) counts.push_back(std::to_string(stage.cells));
    std::string text;
    if (!stages_.empty()) {
      text += fmt::format("check: {{reference: {{file: real/{}.txt}}}}  # of the last stage", stages_.back()->cells);
      text += stages_.size() > 1 ? "; real has one for each number of cells\n" : "\n";
    }
    const double every = std::exp2(std::ceil(std::log2(e_.stop / 64)));
    text += "record:\n  every: " + time(every) + "\n";
    if (!counts.empty()) text += "  at-cells: " + flow(counts, '[', ']') + "\n";
    const bool hasContacts = !stages_.empty() && !stages_.back()->contacts.empty();
    return stages_.empty() ? text : text + "  measures: [position_rmsd" + (hasContacts ? ", contact_f1]\n" : "]\n");
  }

  std::string dna() const {
    std::string text =
        comment("A substance for each cell of " + table_ +
                ", which it holds from birth to end: of her mother's and of A or B the genes of a newborn make hers.");
    text += "START: " + e_.substance[0] + "\n";
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const std::string& own = e_.substance[i];
      const TrackedCell& cell = cells_[i];
      if (cell.mother >= 0) {
        const auto mother = static_cast<std::size_t>(cell.mother);
        const char daughter = cells_[mother].daughters[0] == static_cast<int>(i) ? 'A' : 'B';
        text += fmt::format("born{}({}|{}, {})\n", i, own, e_.substance[mother], daughter);
      }
      if (!cell.hasEnd()) text += fmt::format("live{}({}|{})\n", i, own, own);
      else
        text +=
            fmt::format("live{0}({1}|{1}, !A, !B)\nend{0}({2}|{1}, !A, !B)\n", i, own, cell.dies ? "die" : "divide");
    }
    return text;
  }

  std::string reference(const Stage& stage) const {
    std::string text = comment(fmt::format(
        "Centres of {} of {} cells of {}, at {} {}, in lengths of {}.yaml: one is {} {}.", stage.places.size(),
        stage.cells, table_, options_.units.time, numberText(0.5 * (stage.begin + stage.end) * options_.units.perTime),
        stem_, numberText(e_.length * options_.units.perLength, 5), options_.units.length));
    for (const auto& [cell, place] : stage.places)
      text += fmt::format("position {} {:.4f} {:.4f} {:.4f}\n", cells_[static_cast<std::size_t>(cell)].name, place.x,
                          place.y, place.z);
    if (!stage.contacts.empty())
      text += comment(
          "Contacts by places and volumes: each point of the shell belongs to the nearest cell, as in a power "
          "diagram, and faces below 0.4 of the mean do not count.");
    for (const auto& [a, b] : stage.contacts)
      text += fmt::format("contact {} {}\n", cells_[static_cast<std::size_t>(a)].name,
                          cells_[static_cast<std::size_t>(b)].name);
    return text;
  }

  const Embryo& e_;
  const EmbryoOptions& options_;
  const std::string &stem_, &table_, &heading_;
  const std::vector<TrackedCell>& cells_;
  std::vector<const Stage*> stages_;  // that have a reference
  bool hasNamesFile_ = false;
  std::vector<EmbryoFile> files_;
};

/// Returns the comments with which a table begins, which may say where its numbers come from.
std::string headingOf(std::string_view text) {
  std::string heading;
  for (const std::string& line : linesOf(text)) {
    if (!line.starts_with('#')) break;
    heading += printableLine(line) + "\n";
  }
  return heading;
}

}  // namespace

std::vector<EmbryoFile> writeEmbryo(const Embryo& embryo, const EmbryoOptions& options, const std::string& stem,
                                    const std::string& table, const std::string& heading) {
  return Writer(embryo, options, stem, table, heading).write();
}

std::vector<EmbryoFile> embryoFromTable(std::string_view text, const std::string& file, const EmbryoOptions& given,
                                        const std::string& stem, std::vector<std::string>& assumed) {
  scenario::Problems problems(file);
  const CellTable table = readCellTable(text, problems, {false, given.columns});
  problems.throwIfAny();
  Lineage lineage = makeLineage(table, given.root, problems);
  problems.throwIfAny();
  if (!table.ignored.empty()) lineage.assumed.push_back("columns that are not read: " + join(table.ignored));
  if (table.isFlat) lineage.assumed.push_back("the table has no column z, so all cells lie in one plane");
  EmbryoOptions options = given;
  if (options.units.length.empty()) options.units.length = "unit";
  if (options.units.time.empty()) options.units.time = table.form == Form::cells ? "unit" : "frame";
  if (given.units.length.empty())
    lineage.assumed.push_back(
        "lengths and times have the table's units, which are not known; name them, as --units µm,min");
  const Embryo embryo = makeEmbryo(std::move(lineage), options);
  assumed = embryo.assumed;
  const auto slash = file.find_last_of('/');
  const std::string name = slash == file.npos ? file : file.substr(slash + 1);
  const std::string heading = headingOf(text) + comment("Made by:") + commandComment(given, stem, name);
  std::vector<EmbryoFile> files = writeEmbryo(embryo, options, stem, name, heading);
  std::vector<NamedFile> named;
  for (auto at = files.rbegin(); at != files.rend(); ++at)
    named.push_back({at->role, at->path, at->text});  // the last reference first
  // Reading checks each rule against all substances: with very many cells that takes minutes.
  const auto check = [&](const std::vector<Override>& settings) {
    if (embryo.substance.size() <= 10'000) readScenario(files[0].text, stem + ".yaml", "", settings, named);
  };
  std::vector<Override> settings;
  for (const std::string& setting : options.settings) settings.push_back(parseOverride(setting));
  check(settings);  // a mistake in a setting has the option as its place
  files[0].text = withSettings(files[0].text, options.settings, problems);
  problems.throwIfAny();
  if (!settings.empty()) check({});
  return files;
}

}  // namespace morula::tracks
