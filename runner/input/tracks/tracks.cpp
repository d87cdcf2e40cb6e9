#include "tracks/tracks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/cell_path.h"
#include "base/number_text.h"
#include "tracks/rows_by_cell.h"
#include "tracks/wording.h"
#include "values/cell_names.h"

namespace morula::tracks {
namespace {

bool isSaid(double a) { return a == a; }

/// Returns true if these are lineage paths of the daughters A and B of one cell.
bool areSisterPaths(const std::string& a, const std::string& b) {
  const auto mother = [](std::string_view path) { return path.substr(0, path.size() - 1); };
  return a.ends_with('A') && b.ends_with('B') && mother(a) == mother(b);
}

/// Turns tracks, whose daughters are in no order, into a lineage.
class LineageMaker {
 public:
  LineageMaker(std::vector<Track> tracks, std::vector<double> times, const CellTable& table,
               scenario::Problems& problems)
      : tracks_(std::move(tracks)), times_(std::move(times)), problems_(problems) {
    lineage_.form = table.form;
  }

  Lineage make(const std::string& root) {
    std::vector<int> founders = findDaughters();
    if (!root.empty()) founders = {findRoot(root)};
    if (!problems_.empty()) return {};
    joinTracks(founders);
    sort(founders);
    takeTimes(founders);
    for (const int founder : founders) add(founder, -1);
    lineage_.founders = static_cast<int>(founders.size());
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const std::vector<int>& daughters = tracks_[order_[i]].daughters;
      if (daughters.empty()) end(order_[i]);
      else if (daughters.size() == 2 && divide(order_[i]))
        for (const int daughter : daughters) add(daughter, static_cast<int>(i));
    }
    finish();
    return std::move(lineage_);
  }

 private:
  void complain(const Track& track, std::string what, std::string right) {
    problems_.add({track.line, 1, ""}, "", std::move(what), std::move(right));
  }

  /// Returns the founders; fills in the daughters of all others' mothers.
  std::vector<int> findDaughters() {
    std::vector<int> founders;
    std::vector<char> state(tracks_.size(), 0);  // 1: on the way up, 2: it has a founder
    for (int i = 0; i < static_cast<int>(tracks_.size()); ++i) {
      if (tracks_[i].mother < 0) founders.push_back(i);
      else tracks_[tracks_[i].mother].daughters.push_back(i);
      std::vector<int> way;
      int at = i;
      for (; at >= 0 && state[at] == 0; at = tracks_[at].mother) state[at] = 1, way.push_back(at);
      if (at >= 0 && state[at] == 1)
        complain(tracks_[at], inQuotes(tracks_[at].name) + " descends from itself",
                 "correct its parent, or that of a cell between");
      for (const int one : way) state[one] = 2;
    }
    for (const Track& mother : tracks_)
      if (const std::size_t count = mother.daughters.size(); count > 2)
        complain(tracks_[mother.daughters[2]],
                 inQuotes(mother.name) + " has " + std::to_string(count) +
                     " daughters: " + inQuotes(tracks_[mother.daughters[0]].name) + " and " +
                     inQuotes(tracks_[mother.daughters[1]].name) + " stand before",
                 "a cell has two; correct a parent, or put a short track between");
    return founders;
  }

  int findRoot(const std::string& root) {
    for (const auto member : {&Track::name, &Track::id})
      for (std::size_t i = 0; i < tracks_.size(); ++i)
        if (tracks_[i].*member == root) return static_cast<int>(i);
    problems_.add({1, 1, "--root"}, "", "the table has no cell " + inQuotes(root),
                  "needs the name or id of one of its cells");
    return 0;
  }

  /// Joins each track with one daughter to that daughter.
  void joinTracks(const std::vector<int>& founders) {
    std::vector<std::string> joined;
    for (std::vector<int> waiting = founders; !waiting.empty();) {
      Track& track = tracks_[waiting.back()];
      waiting.pop_back();
      while (track.daughters.size() == 1) {
        Track& rest = tracks_[track.daughters[0]];
        joined.push_back(rest.name);
        if (!follows(rest, track)) break;
        track.seen.insert(track.seen.end(), rest.seen.begin(), rest.seen.end());
        track.volumes += rest.volumes, track.volumeSum += rest.volumeSum;
        track.last = rest.last, track.end = rest.end, track.dies = rest.dies, track.axis = rest.axis;
        track.daughters = std::vector(rest.daughters);
      }
      waiting.insert(waiting.end(), track.daughters.begin(), track.daughters.end());
    }
    assume(lineage_.assumed,
           "each of these tracks is the only daughter of another track, and is taken as its continuation", joined);
  }

  /// Returns false, and says so, if the track begins before its mother's ends.
  bool follows(const Track& track, const Track& mother) {
    const bool isRight = lineage_.form == Form::cells ? !isSaid(track.birth) || !isSaid(mother.end) ||
                                                            std::abs(track.birth - mother.end) <=
                                                                1e-6 * (std::abs(track.birth) + std::abs(mother.end))
                                                      : track.birth > mother.last;
    if (!isRight && lineage_.form == Form::cells)
      complain(track,
               inQuotes(track.name) + " is born at " + numberText(track.birth) + ", and its mother " +
                   inQuotes(mother.name) + " divides at " + numberText(mother.end),
               "let both be one time, or leave one empty");
    else if (!isRight)
      complain(track,
               inQuotes(track.name) + " begins at " + numberText(track.birth) + ", and its parent " +
                   inQuotes(mother.name) + " is still seen at " + numberText(mother.last),
               "let the parent end before, or correct the parent");
    return isRight;
  }

  void sort(std::vector<int>& cells) const {
    std::ranges::sort(cells, [&](int a, int b) {
      const Track &one = tracks_[a], &other = tracks_[b];
      return one.name != other.name ? precedes(one.name, other.name) : precedes(one.id, other.id);
    });
  }

  void takeTimes(const std::vector<int>& founders) {
    for (std::size_t i = 1; i < times_.size(); ++i)
      lineage_.frame = i == 1 ? times_[1] - times_[0] : std::min(lineage_.frame, times_[i] - times_[i - 1]);
    lineage_.begin = INFINITY, lineage_.end = -INFINITY;
    for (const Track& track : tracks_)
      for (const double time : {track.birth, track.end, track.last})
        if (isSaid(time)) lineage_.end = std::max(lineage_.end, time);
    for (const int i : founders) {
      Track& founder = tracks_[i];
      if (!isSaid(founder.birth) && !(founder.end <= 0)) founder.birth = 0;
      if (isSaid(founder.birth)) lineage_.begin = std::min(lineage_.begin, founder.birth);
      else complain(founder, "the table does not say when " + inQuotes(founder.name) + " was born", "give its birth");
    }
    std::vector<std::string> late;
    for (const int i : founders)
      if (tracks_[i].birth > lineage_.begin) late.push_back(tracks_[i].name), tracks_[i].birth = lineage_.begin;
    assume(lineage_.assumed,
           "each of these cells without a mother is first seen later, and is taken to live from the start", late);
  }

  void add(int index, int mother) {
    const Track& track = tracks_[index];
    TrackedCell& cell = lineage_.cells.emplace_back();
    if (mother >= 0)
      lineage_.cells[static_cast<std::size_t>(mother)].daughters.push_back(static_cast<int>(order_.size()));
    cell.mother = mother;
    order_.push_back(index);
    depth_.push_back(mother < 0 ? 0 : depth_[static_cast<std::size_t>(mother)] + 1);
    if (depth_.back() == CellPath::maxDepth + 1)
      complain(track, inQuotes(track.name) + " has more than " + std::to_string(CellPath::maxDepth) + " ancestors",
               "give a later --root");
  }

  /// Gives a mother her end, which is her daughters' birth. Returns false, and says so, if it cannot be.
  bool divide(int index) {
    Track& mother = tracks_[index];
    if (lineage_.form != Form::cells) {  // a row per cell: A has the first row
      sort(mother.daughters);
      if (areSisterPaths(tracks_[mother.daughters[1]].path, tracks_[mother.daughters[0]].path))
        std::swap(mother.daughters[0], mother.daughters[1]);
    }
    Track &a = tracks_[mother.daughters[0]], &b = tracks_[mother.daughters[1]];
    if (!follows(a, mother) || !follows(b, mother)) return false;
    const double first = std::fmin(a.birth, b.birth);
    if (lineage_.form != Form::cells || !isSaid(mother.end)) mother.end = first;
    if (!isSaid(mother.birth)) return false;  // a problem of the founder
    if (!isSaid(mother.end) || !(mother.end > mother.birth)) {
      complain(mother,
               isSaid(mother.end) ? inQuotes(mother.name) + " divides at " + numberText(mother.end) +
                                        ", and is born at " + numberText(mother.birth)
                                  : "the table does not say when " + inQuotes(mother.name) + " divides",
               "give its division, or its daughters' birth");
      return false;
    }
    if (lineage_.form != Form::cells)
      for (const Track* one : {&a, &b})
        if (one->birth > first) late_.push_back(one->name);
    a.birth = b.birth = mother.end;
    return true;
  }

  /// Ends a cell without daughters.
  void end(int index) {
    Track& cell = tracks_[index];
    if (lineage_.form == Form::cells) {
      if (cell.dies && !isSaid(cell.end))
        complain(cell, inQuotes(cell.name) + " dies, and the table does not say when", "give its end");
      if (!cell.dies && cell.end < cell.birth)
        complain(
            cell,
            inQuotes(cell.name) + " ends at " + numberText(cell.end) + ", and is born at " + numberText(cell.birth),
            "give a later end, or leave it empty where it is not known");
      if (!cell.dies && cell.end < lineage_.end) lost_.push_back(cell.name);
    } else {
      const auto next = std::ranges::upper_bound(times_, cell.last);
      cell.end = lineage_.form == Form::frames && next != times_.end() ? *next : cell.last + lineage_.frame;
      if (!cell.dies && cell.last < lineage_.end) lost_.push_back(cell.name);
    }
    if (!cell.dies) cell.end = unsaid;
    else if (cell.end <= cell.birth)
      complain(cell, inQuotes(cell.name) + " dies as soon as it is born", "give a later end");
  }

  void finish() {
    assume(lineage_.assumed, "each of these cells is first seen after her sister, and is taken to be born with her",
           late_);
    assume(
        lineage_.assumed,
        "each of these cells ends before the table does, without daughters, and lives on ('dies' in a column fate lets a cell die)",
        lost_);
    for (std::size_t i = 0; i < order_.size(); ++i) {
      Track& track = tracks_[order_[i]];
      TrackedCell& cell = lineage_.cells[i];
      cell.id = track.id, cell.name = track.name, cell.line = track.line;
      cell.birth = track.birth, cell.end = track.end, cell.dies = track.dies && track.daughters.empty();
      cell.seen = std::move(track.seen), cell.axis = track.axis;
      if (track.volumes > 0) cell.volume = track.volumeSum / track.volumes;
      if (!isCellName(cell.name))
        complain(track, inQuotes(cell.name) + " is no name of a cell", std::string("needs ") + nameAllowed);
    }
    std::vector<std::size_t> byName(lineage_.cells.size());
    for (std::size_t i = 0; i < byName.size(); ++i) byName[i] = i;
    std::ranges::stable_sort(byName, {}, [&](std::size_t i) -> const std::string& { return lineage_.cells[i].name; });
    for (std::size_t i = 1; i < byName.size(); ++i) {
      const auto [one, other] = std::minmax({&lineage_.cells[byName[i - 1]], &lineage_.cells[byName[i]]},
                                            [](auto* a, auto* b) { return a->line < b->line; });
      if (one->name == other->name)
        problems_.add({other->line, 1, ""}, "",
                      inQuotes(other->name) + " is also the name of the cell in line " + std::to_string(one->line),
                      "give each cell a name of its own");
    }
  }

  std::vector<Track> tracks_;
  std::vector<double> times_;  // of all frames, rising
  scenario::Problems& problems_;
  Lineage lineage_;
  std::vector<int> order_;  // the tracks of lineage_.cells
  std::vector<int> depth_;  // of lineage_.cells
  std::vector<std::string> late_, lost_;
};

}  // namespace

Lineage makeLineage(const CellTable& table, const std::string& root, scenario::Problems& problems) {
  std::vector<double> times;
  std::vector<Track> tracks = tracksOf(table, times, problems);
  if (!problems.empty()) return {};
  return LineageMaker(std::move(tracks), std::move(times), table, problems).make(root);
}

}  // namespace morula::tracks
