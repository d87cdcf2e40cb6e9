#include "tracks/rows_by_cell.h"

#include <algorithm>
#include <unordered_map>

#include "base/number_text.h"
#include "tracks/wording.h"
#include "values/delimited_text.h"

namespace morula::tracks {
namespace {

class RowCollector {
 public:
  RowCollector(const CellTable& table, scenario::Problems& problems) : table_(table), problems_(problems) {}

  std::vector<Track> collect(std::vector<double>& times) {
    for (const Row& row : table_.rows)
      if (problems_.size() < scenario::maxProblems) add(row);
    if (table_.form == Form::frames) takeFrames(times);
    if (table_.form == Form::manTrack)
      for (const Row& row : table_.rows) times.push_back(row.birth), times.push_back(row.end + 1);
    keepDistinct(times);
    for (std::size_t i = 0; i < tracks_.size() && problems_.size() < scenario::maxProblems; ++i) findMother(i);
    return std::move(tracks_);
  }

 private:
  void complain(int line, std::string what, std::string right) {
    problems_.add({line, 1, ""}, "", std::move(what), std::move(right));
  }

  static void keepDistinct(std::vector<double>& times) {
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
  }

  void add(const Row& row) {
    const auto [entry, isNew] = byId_.try_emplace(row.cell, static_cast<int>(tracks_.size()));
    if (isNew) {
      Track& track = tracks_.emplace_back();
      track.id = row.cell, track.path = row.path, track.line = row.line;
      parent_.push_back(row.parent), name_.push_back(row.name);
    }
    const auto at = static_cast<std::size_t>(entry->second);
    Track& track = tracks_[at];
    if (table_.form == Form::frames) {
      agree(parent_[at], row.parent, row, "parent");
      agree(name_[at], row.name, row, "name");
    } else if (!isNew) {
      return complain(row.line, inQuotes(row.cell) + " stands in line " + std::to_string(track.line) + " already",
                      "keep one of the two, or give each cell an id of its own");
    }
    if (table_.form == Form::manTrack) takeSpan(row, track);
    if (table_.form == Form::cells) track.birth = row.birth, track.end = row.end;
    const Point& p = row.place;
    if (p.x == p.x && p.y == p.y && p.z == p.z)
      track.seen.push_back({table_.form == Form::cells ? 0 : row.time, p, row.line});
    for (const auto& [cells, q] : row.placesAmong)
      if (q.x == q.x && q.y == q.y && q.z == q.z) track.seen.push_back({double(cells), q, row.line});
    track.axis = row.axis;
    track.dies = track.dies || row.dies;
    if (row.volume == row.volume) ++track.volumes, track.volumeSum += row.volume;
  }

  /// Keeps what the rows of a cell say of its parent or name; rows may be silent.
  void agree(std::string_view& known, std::string_view said, const Row& row, const std::string& what) {
    if (known.empty()) known = said;
    if (!said.empty() && said != known)
      complain(row.line,
               "the " + what + " of " + inQuotes(row.cell) + " is " + inQuotes(said) + " here, and " + inQuotes(known) +
                   " before",
               "a track has one " + what + ": correct the parent, or give the rest a track of its own");
  }

  void takeSpan(const Row& row, Track& track) {
    track.birth = row.birth, track.last = row.end;
    if (row.end < row.birth)
      complain(
          row.line,
          inQuotes(row.cell) + " ends at " + numberText(row.end) + ", before it begins at " + numberText(row.birth),
          "the four numbers are the track, its first frame, its last one and its parent");
  }

  void takeFrames(std::vector<double>& times) {
    for (const Row& row : table_.rows) times.push_back(row.time);
    keepDistinct(times);
    for (Track& track : tracks_) {
      std::ranges::stable_sort(track.seen, {}, &Sighting::time);
      if (track.seen.empty() || problems_.size() >= scenario::maxProblems) continue;  // a problem of the row
      track.birth = track.seen.front().time, track.last = track.seen.back().time;
      auto frame = std::ranges::lower_bound(times, track.birth);
      for (std::size_t i = 1; i < track.seen.size(); ++i) {
        const Sighting &now = track.seen[i], &before = track.seen[i - 1];
        if (now.time == before.time)
          complain(now.line,
                   inQuotes(track.id) + " has two places at t " + numberText(now.time) + ", here and in line " +
                       std::to_string(before.line),
                   "a track is one cell: remove a row, or give each cell a track of its own");
        else if (*++frame != now.time) {
          complain(now.line,
                   inQuotes(track.id) + " is not seen at t " + numberText(*frame) + ", between line " +
                       std::to_string(before.line) + " and here",
                   "add the missing rows, or make the rest a track of its own with " + inQuotes(track.id) +
                       " as its parent");
          break;
        }
      }
    }
  }

  void findMother(std::size_t i) {
    Track& track = tracks_[i];
    track.name = name_[i].empty() ? track.id : std::string(name_[i]);
    std::string_view parent = parent_[i];
    if (parent.empty() || parent == "-1" || parent == track.id) return;
    auto found = byId_.find(parent);
    if (found == byId_.end() && parent.ends_with(".0")) found = byId_.find(parent.substr(0, parent.size() - 2));
    if (found == byId_.end() && (parent == "0" || isUnknown(parent))) return;
    if (found != byId_.end()) {
      track.mother = found->second == static_cast<int>(i) ? -1 : found->second;
      return;
    }
    if (byName_.empty())
      for (std::size_t k = 0; k < name_.size(); ++k) byName_.try_emplace(name_[k], static_cast<int>(k));
    if (const auto named = byName_.find(parent); named != byName_.end()) track.mother = named->second;
    else
      complain(track.line, "the parent of " + inQuotes(track.id) + " is " + inQuotes(parent) + ", which has no row",
               "add its rows, or leave the parent of a founder empty");
  }

  const CellTable& table_;
  scenario::Problems& problems_;
  std::vector<Track> tracks_;
  std::vector<std::string_view> parent_, name_;  // of tracks_
  std::unordered_map<std::string_view, int> byId_, byName_;
};

}  // namespace

std::vector<Track> tracksOf(const CellTable& table, std::vector<double>& times, scenario::Problems& problems) {
  return RowCollector(table, problems).collect(times);
}

}  // namespace morula::tracks
