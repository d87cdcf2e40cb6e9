#include "tracks/embryo.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "base/number_text.h"
#include "biology/substances.h"
#include "division/rules.h"
#include "files/text.h"
#include "tracks/delimited_text.h"

namespace morula::tracks {
namespace {

constexpr std::size_t framesOfAxis = 3, maxStages = 100;
constexpr double usualFill = 0.9, largestFill = 0.95;  // more than a mesh of 162 vertices can
constexpr double usualLife = 4;                        // [time] the median; cells then come to rest between divisions

double ballRadius(double volume) { return std::cbrt(volume / (4 * std::numbers::pi / 3)); }
double boxVolume(const std::array<double, 3>& axes) { return axes[0] * axes[1] * axes[2]; }
double powerOfTwoNear(double a) { return std::exp2(std::round(std::log2(a))); }

class EmbryoMaker {
 public:
  EmbryoMaker(Lineage lineage, const EmbryoOptions& options) : options_(options) {
    e_.lineage = std::move(lineage);
    e_.assumed = e_.lineage.assumed;
    const auto isPlaced = [](const TrackedCell& c) { return !c.seen.empty() || c.axis.x == c.axis.x; };
    e_.hasBodies = options.shell || options.areSpheres || std::ranges::any_of(cells(), isPlaced);
  }

  Embryo make() {
    findTimes();
    findPaths();
    findSubstances();
    findDivisions();
    findStages();
    if (e_.hasBodies) findSizes();
    for (auto& stage : e_.stages)
      for (auto& [cell, place] : stage.places) place = (place - centre_) / e_.length;
    return std::move(e_);
  }

 private:
  const std::vector<TrackedCell>& cells() const { return e_.lineage.cells; }
  void assume(std::string sentence) { e_.assumed.push_back(std::move(sentence)); }

  void findTimes() {
    const Lineage& lineage = e_.lineage;
    std::vector<double> lives;
    for (const TrackedCell& cell : cells())
      if (cell.hasEnd()) lives.push_back(cell.end - cell.birth);
    std::ranges::sort(lives);
    const double frame = lineage.frame > 0 ? lineage.frame : 1;
    // A power of two of frames, so that each birth falls on the end of a time step.
    if (!lives.empty()) e_.time = frame * powerOfTwoNear(lives[lives.size() / 2] / frame / usualLife);
    for (const TrackedCell& cell : cells()) e_.life.push_back((cell.end - cell.birth) / e_.time);
    e_.firstCycle = lives.empty() ? 0.0625 : std::min(0.0625, powerOfTwoNear(lives[0] / e_.time) / 8);
    const double whole = lineage.end - lineage.begin;
    e_.stop = (whole > 0 ? whole + 0.5 * lineage.frame : frame) / e_.time;
    const double last = lives.empty() ? 0 : std::ranges::max(cells(), {}, [](const TrackedCell& c) {
                                              return c.hasEnd() ? c.end : -INFINITY;
                                            }).end;
    if (!lives.empty() && lineage.frame == 0 && last >= lineage.end) e_.stop += 0.25;  // its daughters live a little
  }

  /// Gives n founders, from number `first` on, the paths that a scenario's `cells` have below `path`.
  void spread(int first, int n, const CellPath& path) {
    if (n == 1) e_.path[static_cast<std::size_t>(first)] = path;
    else spread(first, (n + 1) / 2, path.daughter(false)), spread(first + (n + 1) / 2, n / 2, path.daughter(true));
  }

  void findPaths() {
    e_.path.resize(cells().size());
    spread(0, e_.lineage.founders, {});
    for (std::size_t i = 0; i < cells().size(); ++i)
      for (std::size_t b = 0; b < cells()[i].daughters.size(); ++b)
        e_.path[static_cast<std::size_t>(cells()[i].daughters[b])] = e_.path[i].daughter(b == 1);
    giveNames();
  }

  /// Names cells by their mothers' names and the commonest endings, and lists the others.
  void giveNames() {
    std::map<std::pair<std::string, std::string>, int> endings;
    const auto ending = [&](const TrackedCell& mother, int daughter) {
      const std::string& name = cells()[static_cast<std::size_t>(daughter)].name;
      return name.starts_with(mother.name) ? name.substr(mother.name.size()) : std::string();
    };
    for (const TrackedCell& cell : cells())
      if (!cell.daughters.empty()) ++endings[{ending(cell, cell.daughters[0]), ending(cell, cell.daughters[1])}];
    const auto best = std::ranges::max_element(endings, {}, [](const auto& entry) { return entry.second; });
    if (best != endings.end() && best->second > 1) {
      const auto& [a, b] = best->first;
      if (isCellName(a) && isCellName(b) && !a.starts_with(b) && !b.starts_with(a)) e_.names.daughters = {a, b};
    }
    const auto list = [&] {
      e_.names.given.clear();
      for (std::size_t i = 0; i < cells().size(); ++i)
        if (e_.names.of(e_.path[i]) != cells()[i].name) e_.names.given[e_.path[i]] = cells()[i].name;
    };
    list();
    const auto isShared = [&](const auto& entry) { return e_.names.find(entry.second).size() > 1; };
    if (e_.names.daughters.empty()) return;
    if (2 * e_.names.given.size() < cells().size() && std::ranges::none_of(e_.names.given, isShared)) return;
    e_.names.daughters.clear();
    list();
  }

  void findSubstances() {
    std::set<std::string> taken{"START"};
    std::vector<std::string> changed;
    for (const TrackedCell& cell : cells()) {
      std::string base;
      for (const char c : cell.name) base += isMadeOf({&c, 1}, "_") ? c : '_';
      if (isMadeOf(base.substr(0, 1), "_") && !(base[0] >= 'A' && base[0] != '_')) base = "c" + base;
      std::string word = base.substr(0, 90);
      for (int n = 2; substance::isReserved(word) || !taken.insert(word).second; ++n)
        word = base.substr(0, 90) + "_" + std::to_string(n);
      if (word != cell.name) changed.push_back(cell.name + " is " + word);
      e_.substance.push_back(word);
    }
    if (!changed.empty())
      assume(countOf(changed, "name is", "names are") +
             " no name of a substance: the DNA and the rules say it with letters, digits and _");
  }

  std::optional<Vector> axisOf(const TrackedCell& mother) const {
    Vector axis = mother.axis;
    if (axis.x != axis.x || axis.y != axis.y || axis.z != axis.z) {
      axis = {};
      const auto& a = cells()[static_cast<std::size_t>(mother.daughters[0])].seen;
      const auto& b = cells()[static_cast<std::size_t>(mother.daughters[1])].seen;
      const bool isTimed = e_.lineage.form == Form::frames;
      std::size_t frames = 0;
      for (std::size_t i = 0, k = 0; i < a.size() && k < b.size() && frames < framesOfAxis;)
        if (isTimed && a[i].time < b[k].time) ++i;
        else if (isTimed && b[k].time < a[i].time) ++k;
        else axis += a[i++].place - b[k++].place, ++frames;
    }
    const double length = norm(axis);
    return length > 0 ? std::optional(axis / length) : std::nullopt;
  }

  void findDivisions() {
    std::vector<std::string> withoutAxis, withoutShare, extreme;
    for (const TrackedCell& cell : cells()) {
      Division& division = e_.division.emplace_back();
      if (cell.daughters.empty()) continue;
      division.axis = axisOf(cell);
      const double a = cells()[static_cast<std::size_t>(cell.daughters[0])].volume,
                   b = cells()[static_cast<std::size_t>(cell.daughters[1])].volume;
      if (a == a && b == b) division.share = std::clamp(a / (a + b), minShare, largestShare);
      if (!division.axis) withoutAxis.push_back(cell.name);
      if (!division.share) withoutShare.push_back(cell.name);
      else if (*division.share != a / (a + b)) extreme.push_back(cell.name);
    }
    if (!e_.hasBodies) return;
    if (!withoutAxis.empty())
      assume(countOf(withoutAxis, "division has", "divisions have") + " no axis in the table: division.plane decides");
    if (!withoutShare.empty())
      assume(countOf(withoutShare, "division has", "divisions have") +
             " no volumes of both daughters: they get a half each");
    if (!extreme.empty())
      assume(countOf(extreme, "division gives", "divisions give") +
             " a daughter less than a tenth, which no cut can: she gets a tenth");
  }

  /// Finds for each number of cells the longest time in which so many live.
  void findStages() {
    std::map<double, int> change;  // of the number of cells
    for (const TrackedCell& cell : cells()) {
      ++change[cell.birth];
      if (cell.hasEnd()) --change[cell.end];
    }
    std::map<int, Stage> longest;
    int living = 0;
    for (auto at = change.begin(); at != change.end(); ++at) {
      living += at->second;
      const double end = std::next(at) == change.end() ? e_.lineage.end + e_.lineage.frame : std::next(at)->first;
      Stage& stage = longest[living];
      if (end - at->first > stage.end - stage.begin) stage = {living, at->first, end, {}};
    }
    for (const auto& [n, stage] : longest)
      if (n > 0 && stage.end > stage.begin) e_.stages.push_back(stage);
    if (e_.stages.size() > maxStages) {
      std::ranges::sort(e_.stages, std::ranges::greater(), [](const Stage& s) { return s.end - s.begin; });
      e_.stages.resize(maxStages);
      std::ranges::sort(e_.stages, {}, &Stage::cells);
      assume("of all numbers of cells, the " + std::to_string(maxStages) + " that last longest have a reference");
    }
    for (Stage& stage : e_.stages) findPlaces(stage);
  }

  void findPlaces(Stage& stage) {
    const double middle = 0.5 * (stage.begin + stage.end);
    const auto lives = [&](const TrackedCell& c) { return c.birth <= stage.begin && !(c.end <= stage.begin); };
    double moment = unsaid;  // the frame nearest to the middle
    for (const TrackedCell& cell : cells()) {
      if (!lives(cell) || cell.seen.empty() || e_.lineage.form != Form::frames) continue;
      const auto after = std::ranges::lower_bound(cell.seen, middle, {}, &Sighting::time);
      for (auto at = after == cell.seen.begin() ? after : after - 1; at != cell.seen.end() && at <= after; ++at)
        if (at->time >= stage.begin && at->time < stage.end &&
            !(std::abs(at->time - middle) >= std::abs(moment - middle)))
          moment = at->time;
    }
    for (std::size_t i = 0; i < cells().size(); ++i) {
      if (!lives(cells()[i])) continue;
      const auto& seen = cells()[i].seen;
      const auto at =
          e_.lineage.form == Form::frames ? std::ranges::lower_bound(seen, moment, {}, &Sighting::time) : seen.begin();
      if (at != seen.end() && (e_.lineage.form != Form::frames || at->time == moment))
        stage.places.emplace_back(static_cast<int>(i), at->place);
    }
  }

  /// The volume of all cells, in the mean over stages of which all volumes are known; 0 if there is none.
  double meanVolume() const {
    double sum = 0, time = 0;
    for (const Stage& stage : e_.stages) {
      double volume = 0;
      for (const TrackedCell& c : cells())
        if (c.birth <= stage.begin && !(c.end <= stage.begin)) volume += c.volume;
      if (volume == volume) sum += volume * (stage.end - stage.begin), time += stage.end - stage.begin;
    }
    return time > 0 ? sum / time : 0;
  }

  void findSizes() {
    std::vector<Point> centres;
    Point low{INFINITY, INFINITY, INFINITY}, high = -low;
    for (const TrackedCell& cell : cells())
      for (const Sighting& s : cell.seen) {
        centres.push_back(s.place);
        low = {std::min(low.x, s.place.x), std::min(low.y, s.place.y), std::min(low.z, s.place.z)};
        high = {std::max(high.x, s.place.x), std::max(high.y, s.place.y), std::max(high.z, s.place.z)};
      }
    if (!centres.empty()) centre_ = (low + high) / 2;
    const int most = e_.stages.empty() ? 1 : e_.stages.back().cells;
    e_.shell = options_.shell;
    if (!e_.shell && most > 1 && norm(high - low) > 0) {
      e_.shell = fitShell(centres, centre_, most);
      const auto& a = *e_.shell;
      assume("the shell is fitted to the cells' centres: semi-axes of " + numberText(a[0], 3) + ", " +
             numberText(a[1], 3) + " and " + numberText(a[2], 3) + "; --shell gives measured ones");
    }
    const double volume = meanVolume(), shell = e_.shell ? 4 * std::numbers::pi / 3 * boxVolume(*e_.shell) : 0;
    e_.fill = volume > 0 && shell > 0 ? volume / shell : usualFill;
    if (e_.fill > largestFill) {
      assume("the cells have " + numberText(e_.fill, 3) + " of the shell's volume: they are taken to fill " +
             numberText(largestFill) + " of it");
      e_.fill = largestFill;
    } else if (!(volume > 0)) {
      assume("the cells are taken to fill " + numberText(usualFill) +
             " of the shell, since the table has no volumes of all cells");
    }
    e_.length = shell > 0 ? ballRadius(e_.fill * shell) : volume > 0 ? ballRadius(volume) : 1;
    findStart(volume);
  }

  void findStart(double volume) {
    const auto founders = static_cast<std::size_t>(e_.lineage.founders);
    if (founders == 1) return;
    double sum = 0;
    for (std::size_t i = 0; i < founders; ++i) sum += cells()[i].volume;
    const bool areKnown = volume > 0 && sum == sum;
    for (std::size_t i = 0; i < founders; ++i) {
      const auto& seen = cells()[i].seen;
      const double share = areKnown ? cells()[i].volume / sum : 1.0 / static_cast<double>(founders);
      const Point place =
          seen.empty() ? Point{static_cast<double>(i), 0, 0} : (seen.front().place - centre_) / e_.length;
      e_.start.emplace_back(place, std::cbrt(share));
    }
    assume(std::to_string(founders) +
           " cells have no mother: the scenario begins with all of them; --root takes one and its descendants");
  }

  const EmbryoOptions& options_;
  Embryo e_;
  Point centre_;
};

}  // namespace

Embryo makeEmbryo(Lineage lineage, const EmbryoOptions& options) {
  return EmbryoMaker(std::move(lineage), options).make();
}

std::array<double, 3> fitShell(const std::vector<Point>& centres, const Point& centre, int n) {
  std::array<double, 3> far{};
  for (const Point& p : centres) {
    const Vector d = p - centre;
    far = {std::max(far[0], std::abs(d.x)), std::max(far[1], std::abs(d.y)), std::max(far[2], std::abs(d.z))};
  }
  std::array<double, 3> axes;
  axes.fill(norm({far[0], far[1], far[2]}));
  for (int round = 0; round < 200; ++round) {  // the error falls by n^⅓ in each
    const double radius = std::cbrt(boxVolume(axes) / n);
    for (std::size_t i = 0; i < 3; ++i) axes[i] = far[i] + radius;
  }
  double out = 1;
  for (const Point& p : centres) {
    const Vector d = p - centre;
    out = std::max(out, norm({d.x / axes[0], d.y / axes[1], d.z / axes[2]}));
  }
  for (double& axis : axes) axis *= out;
  return axes;
}

}  // namespace morula::tracks
