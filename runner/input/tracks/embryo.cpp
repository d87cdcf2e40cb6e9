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
#include "tracks/embryo_sizes.h"
#include "tracks/touching.h"
#include "tracks/wording.h"

namespace morula::tracks {
namespace {

constexpr std::size_t framesOfAxis = 3, maxStages = 100;
constexpr std::size_t mostTouching = 128;  // time grows by the third power
constexpr double usualLife = 4;            // [time] the median; cells then come to rest between divisions

Vector directionOf(const Vector& v) { return norm(v) > 0 ? v / norm(v) : v; }
double powerOfTwoNear(double a) { return std::exp2(std::round(std::log2(a))); }

class EmbryoMaker {
 public:
  EmbryoMaker(Lineage lineage, const EmbryoOptions& options) : options_(options) {
    e_.lineage = std::move(lineage);
    e_.assumed = e_.lineage.assumed;
    const auto isPlaced = [](const TrackedCell& c) { return !c.seen.empty() || c.axis.x == c.axis.x; };
    e_.areSpheres = options.areSpheres;
    e_.hasBodies =
        options.shell || options.areSpheres || e_.lineage.founders > 1 || std::ranges::any_of(cells(), isPlaced);
  }

  Embryo make() {
    findTimes();
    findPaths();
    findSubstances();
    findDivisions();
    findStages();
    findSizes(e_, options_);
    for (auto& stage : e_.stages) findContacts(stage);
    for (auto& stage : e_.stages)
      for (auto& [cell, place] : stage.places) place = (place - e_.centre) / e_.length;
    return std::move(e_);
  }

 private:
  const std::vector<TrackedCell>& cells() const { return e_.lineage.cells; }
  void say(std::string sentence) { e_.assumed.push_back(std::move(sentence)); }

  void findTimes() {
    const Lineage& lineage = e_.lineage;
    std::vector<double> lives;
    for (const TrackedCell& cell : cells())
      if (cell.hasEnd()) lives.push_back(cell.end - cell.birth);
    std::ranges::sort(lives);
    const double frame = lineage.frame > 0 ? lineage.frame : 1;
    // A power of two of frames, so that each birth falls on the end of a time step.
    if (!lives.empty()) e_.time = frame * powerOfTwoNear(lives[lives.size() / 2] / frame / usualLife);
    e_.time = options_.perTime.value_or(e_.time);
    for (const TrackedCell& cell : cells()) e_.life.push_back((cell.end - cell.birth) / e_.time);
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
    assume(e_.assumed,
           "substances have names of letters, digits and _, so names of cells are changed in the DNA and in rules",
           changed);
  }

  /// The mean direction from B to A over three frames, weighted 3 : 2 : 1: daughters turn as soon as they are born.
  std::optional<Vector> axisOf(const TrackedCell& mother) const {
    Vector axis = mother.axis;
    if (axis.x != axis.x || axis.y != axis.y || axis.z != axis.z) {
      axis = {};
      const auto& a = cells()[static_cast<std::size_t>(mother.daughters[0])].seen;
      const auto& b = cells()[static_cast<std::size_t>(mother.daughters[1])].seen;
      const std::size_t most = e_.lineage.form == Form::frames ? framesOfAxis : 1;
      std::size_t frames = 0;
      for (std::size_t i = 0, k = 0; i < a.size() && k < b.size() && frames < most;)
        if (a[i].time < b[k].time) ++i;
        else if (b[k].time < a[i].time) ++k;
        else axis += directionOf(a[i++].place - b[k++].place) * static_cast<double>(framesOfAxis - frames++);
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
    assume(e_.assumed, "the table gives no axis for these divisions; division.plane gives their axes", withoutAxis);
    assume(e_.assumed, "the table does not give the volumes of both daughters of these cells; each gets a half",
           withoutShare);
    assume(e_.assumed,
           "a daughter of these cells has less than a tenth of the volume, which no cut can give; she "
           "gets a tenth",
           extreme);
  }

  /// Finds for each number of cells the longest time in which so many live.
  void findStages() {
    std::map<double, int> change;  // of the number of cells
    for (const TrackedCell& cell : cells()) {
      ++change[cell.birth];
      if (cell.hasEnd()) --change[cell.end];
    }
    const double last = e_.lineage.form == Form::frames ? e_.lineage.end + e_.lineage.frame
                                                        : e_.lineage.begin + e_.stop * e_.time;
    std::map<int, Stage> longest;
    int living = 0;
    for (auto at = change.begin(); at != change.end(); ++at) {
      living += at->second;
      const double end = std::next(at) == change.end() ? last : std::next(at)->first;
      Stage& stage = longest[living];
      if (end - at->first > stage.end - stage.begin) stage = {living, at->first, end};
    }
    for (const auto& [n, stage] : longest)
      if (n > 0 && stage.end > stage.begin) e_.stages.push_back(stage);
    if (e_.stages.size() > maxStages) {
      std::ranges::sort(e_.stages, std::ranges::greater(), [](const Stage& s) { return s.end - s.begin; });
      e_.stages.resize(maxStages);
      std::ranges::sort(e_.stages, {}, &Stage::cells);
      say("of all numbers of cells, the " + std::to_string(maxStages) + " that last longest have a reference");
    }
    for (Stage& stage : e_.stages) findPlaces(stage);
    std::set<int> unplaced;  // numbers of cells
    for (const TrackedCell& cell : cells())
      for (const Sighting& s : cell.seen)
        if (const int n = static_cast<int>(s.time); e_.lineage.form == Form::cells && n > 0)
          if (std::ranges::none_of(e_.stages, [&](const Stage& t) { return t.cells == n && livesIn(cell, t); }))
            unplaced.insert(n);
    std::vector<std::string> numbers;
    for (const int n : unplaced) numbers.push_back(std::to_string(n));
    assume(e_.assumed, "some places are of cells that do not live while there are so many; these are left out",
           numbers);
  }

  void findPlaces(Stage& stage) {
    const double middle = 0.5 * (stage.begin + stage.end);
    double moment = unsaid;  // the frame nearest to the middle
    for (const TrackedCell& cell : cells()) {
      if (!livesIn(cell, stage) || cell.seen.empty() || e_.lineage.form != Form::frames) continue;
      const auto after = std::ranges::lower_bound(cell.seen, middle, {}, &Sighting::time);
      for (auto at = after == cell.seen.begin() ? after : after - 1; at != cell.seen.end() && at <= after; ++at)
        if (at->time >= stage.begin && at->time < stage.end &&
            !(std::abs(at->time - middle) >= std::abs(moment - middle)))
          moment = at->time;
    }
    for (std::size_t i = 0; i < cells().size(); ++i) {
      if (!livesIn(cells()[i], stage)) continue;
      const auto& seen = cells()[i].seen;
      const bool isFrames = e_.lineage.form == Form::frames;
      const auto at = std::ranges::find_if(
          seen, [&](const Sighting& s) { return isFrames ? s.time == moment : s.time == 0 || s.time == stage.cells; });
      if (at != seen.end()) stage.places.emplace_back(static_cast<int>(i), at->place);
    }
  }

  /// Finds which cells touch, if all of them have a place and a volume.
  void findContacts(Stage& stage) const {
    std::vector<Ball> balls;
    for (const auto& [cell, place] : stage.places)
      balls.push_back({place, std::cbrt(cells()[static_cast<std::size_t>(cell)].volume / (4 * std::numbers::pi / 3))});
    const auto isKnown = [](const Ball& ball) { return ball.radius == ball.radius; };
    if (!e_.shell || static_cast<int>(balls.size()) != stage.cells || balls.size() > mostTouching ||
        !std::ranges::all_of(balls, isKnown))
      return;
    for (const auto& [a, b] : touching(balls, e_.centre, *e_.shell))
      stage.contacts.emplace_back(stage.places[static_cast<std::size_t>(a)].first,
                                  stage.places[static_cast<std::size_t>(b)].first);
  }

  const EmbryoOptions& options_;
  Embryo e_;
};

}  // namespace

Embryo makeEmbryo(Lineage lineage, const EmbryoOptions& options) {
  return EmbryoMaker(std::move(lineage), options).make();
}

}  // namespace morula::tracks
