#include "check/against.h"

#include <algorithm>
#include <cmath>

#include "division/superposition.h"
#include "simulation/settle.h"
#include "simulation/simulation.h"

namespace morula {

Against::Against(const std::vector<tracks::MeasuredStage>& measured) : measured_(measured) {
  for (const auto& stage : measured)
    if (stage.cells > 0) byCells_[stage.cells] = &stage;
    else byTime_.push_back(&stage);
}

Against::Moment Against::momentOf(const World& world, const tracks::MeasuredStage& stage) const {
  Observation now(world);
  now.reference = &stage.measured;
  Moment moment{world.clock.time, {}, {}};
  for (std::size_t i = 0; i < world.cells.path.size(); ++i)
    moment.places.emplace_back(world.cells.path[i], now.centreOf(static_cast<int>(i)));
  if (!stage.measured.contacts.empty() && world.contacts) {
    const ContactsCompared contacts = compareContacts(now);
    if (const double all = contacts.here + contacts.there; all > 0) moment.f1 = 2 * contacts.both / all;
  }
  return moment;
}

std::uint64_t Against::stepsUntilDue(const World& world) const {
  if (!byCells_.empty()) return 1;
  if (next_ == byTime_.size()) return neverDue;
  return settles(world) ? 1 : stepsUntil(world.clock, byTime_[next_]->time);
}

void Against::seeTimes(const World& world) {
  if (next_ == byTime_.size()) return;
  const double now = world.clock.time;
  if (settles(world)) {
    while (next_ < byTime_.size() && now > byTime_[next_]->time) ++next_;
    for (std::size_t i = next_; i < byTime_.size(); ++i) found_[byTime_[i]] = momentOf(world, *byTime_[i]);
  } else {
    for (; next_ < byTime_.size() && now >= byTime_[next_]->time; ++next_)
      found_[byTime_[next_]] = momentOf(world, *byTime_[next_]);
  }
}

void Against::see(const World& world) {
  seeTimes(world);
  const int cells = static_cast<int>(world.cells.path.size());
  if (cells != cells_) {
    closeStage(world.clock.time);
    cells_ = cells, begin_ = world.clock.time, seen_ = 0, stride_ = 1;
  }
  const auto wanted = byCells_.find(cells);
  if (wanted == byCells_.end() || seen_++ % stride_ != 0) return;
  constexpr std::size_t most = 128;
  kept_.push_back(momentOf(world, *wanted->second));
  if (kept_.size() < most) return;
  for (std::size_t i = 0; 2 * i < most; ++i) kept_[i] = std::move(kept_[2 * i]);
  kept_.resize(most / 2);
  stride_ *= 2;
}

void Against::closeStage(double end) {
  Longest& longest = longest_[cells_];
  if (!kept_.empty() && end - begin_ > longest.duration) {
    const double middle = 0.5 * (begin_ + end);
    longest = {end - begin_,
               *std::ranges::min_element(kept_, {}, [&](const Moment& m) { return std::abs(m.time - middle); })};
  }
  kept_.clear();
}

AgainstStage Against::compare(const tracks::MeasuredStage& stage, const Moment& moment, std::uint64_t number) {
  AgainstStage found;
  found.time = moment.time, found.cells = moment.places.size(), found.contactF1 = moment.f1;
  std::vector<Point> here, there, mirrored;
  auto measured = stage.measured.positions;
  for (const auto& [path, place] : moment.places) {
    const auto known = measured.extract(path);
    found.byCell.push_back({number, path, known.empty() ? FoundIn::run : FoundIn::both, {}});
    if (known.empty()) continue;
    here.push_back(place), mirrored.push_back({-place.x, place.y, place.z}), there.push_back(known.mapped());
  }
  found.compared = here.size();
  if (const auto laid = superpose(here, there)) {
    found.rmsd = laid->distance, found.shapeRmsd = laid->shape, found.scale = laid->scale;
    if (const auto image = superpose(mirrored, there)) found.mirroredShapeRmsd = image->shape;
    auto distance = laid->distances.begin();
    for (AgainstCell& cell : found.byCell)
      if (cell.in == FoundIn::both) cell.distance = *distance++;
  } else {
    found.why = here.size() < 3 ? "fewer than three cells are in both" : "all places are one";
  }
  for (const auto& [path, place] : measured) found.byCell.push_back({number, path, FoundIn::table, {}});
  sortByDistance(found.byCell);
  return found;
}

std::vector<AgainstStage> Against::take(const World& world) {
  closeStage(world.clock.time);
  for (std::size_t i = next_; i < byTime_.size(); ++i)
    if (byTime_[i]->time > world.clock.time) found_.erase(byTime_[i]);
  for (const auto& [cells, stage] : byCells_)
    if (const Longest& longest = longest_[cells]; longest.duration >= 0) found_[stage] = longest.middle;
  std::vector<AgainstStage> all;
  for (const auto& stage : measured_) {
    const auto at = found_.find(&stage);
    all.push_back(at != found_.end() ? compare(stage, at->second, all.size()) : AgainstStage{});
    if (at == found_.end())
      all.back().why = stage.cells > 0 ? "the run never has so many cells" : "the run ends before";
    if (stage.cells > 0) all.back().ofCells = static_cast<std::uint64_t>(stage.cells);
    else all.back().ofTime = stage.time;
  }
  return all;
}

}  // namespace morula
