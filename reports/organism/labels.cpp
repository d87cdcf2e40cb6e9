#include "organism/labels.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "drawing/palette.h"

namespace morula {
namespace {

/// Returns each pixel's distance [pixel] to the next pixel of another owner, or to the edge. Steps along rows and
/// columns count 3, along diagonals 4, for 1 and √2 [Borgefors 1986]: at most 8 % too far.
std::vector<double> distancesInside(const LabelGround& ground) {
  const int w = ground.width, h = ground.height;
  std::vector<int> far(ground.owners.size());
  const auto owner = [&](int x, int y) {
    return x < 0 || y < 0 || x >= w || y >= h ? 0xffffffffu : ground.owners[std::size_t(y) * w + x];
  };
  const auto pass = [&](int from, int step) {
    for (int row = 0; row < h; ++row)
      for (int column = 0; column < w; ++column) {
        const int x = from ? w - 1 - column : column, y = from ? h - 1 - row : row;
        int& here = far[std::size_t(y) * w + x];
        int best = from ? here : 1 << 28;
        const std::uint32_t own = owner(x, y);
        constexpr int steps[4][3] = {{-1, 0, 3}, {-1, -1, 4}, {0, -1, 3}, {1, -1, 4}};
        for (const auto& [dx, dy, cost] : steps) {
          const int nx = x + step * dx, ny = y + step * dy;
          best = std::min(best, owner(nx, ny) != own ? cost : far[std::size_t(ny) * w + nx] + cost);
        }
        here = best;
      }
  };
  pass(0, 1);
  pass(1, -1);
  std::vector<double> distances(far.size());
  std::transform(far.begin(), far.end(), distances.begin(), [](int d) { return d / 3.0; });
  return distances;
}

struct Room {
  Spot at;
  double reach = 0;  // [pixel] to the cell's edge
};

struct Candidate {
  const LabelWish* wish;
  Room room;
};

bool touches(const PlacedLabel& a, const PlacedLabel& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// Returns true if the line from a label to its cell runs through another label.
bool crosses(const Spot& from, const Spot& to, const PlacedLabel& box) {
  const int steps = 1 + int(std::hypot(to.x - from.x, to.y - from.y) / 2);
  for (int i = 0; i <= steps; ++i) {
    const double x = from.x + (to.x - from.x) * i / steps, y = from.y + (to.y - from.y) * i / steps;
    if (x > box.left && x < box.right && y > box.top && y < box.bottom) return true;
  }
  return false;
}

class Places {
 public:
  Places(const LabelGround& ground, double textSize) : ground_(ground), size_(textSize) {}

  /// Places a label; returns false if there is no free place.
  bool take(const Candidate& candidate, const std::vector<Candidate>& others) {
    return take(candidate, others, true) || take(candidate, others, false);
  }

  std::vector<PlacedLabel> placed;

 private:
  /// `polite`: without covering the place of another cell's label.
  bool take(const Candidate& candidate, const std::vector<Candidate>& others, bool polite) {
    const double wide = textWidth(candidate.wish->text, {.size = size_}) + 0.4 * size_, high = 1.3 * size_;
    for (int ring = 0; ring < 12; ++ring) {
      const int turns = ring == 0 ? 1 : 16;
      for (int turn = 0; turn < turns; ++turn) {
        // The rings are wider than high, as words are.
        const double angle = 6.283185307179586 * turn / turns;
        const double reach = ring == 0 ? 0 : candidate.room.reach * 0.5 + ring * 1.1 * size_;
        const Spot c{candidate.room.at.x + (reach + (ring ? 0.4 * wide : 0)) * std::cos(angle),
                     candidate.room.at.y + reach * std::sin(angle)};
        PlacedLabel label{candidate.wish->text, c.x - 0.5 * wide, c.y - 0.5 * high,
                          c.x + 0.5 * wide,     c.y + 0.5 * high, std::nullopt};
        if (ring > 0 && !holds(label, candidate.room.at)) label.leader = candidate.room.at;
        if (!isFree(label)) continue;
        if (polite && std::any_of(others.begin(), others.end(), [&](const Candidate& other) {
              return other.wish != candidate.wish && holds(label, other.room.at);
            }))
          continue;
        placed.push_back(std::move(label));
        return true;
      }
    }
    return false;
  }

  static bool holds(const PlacedLabel& l, const Spot& p) {
    return p.x > l.left && p.x < l.right && p.y > l.top && p.y < l.bottom;
  }

  bool isFree(const PlacedLabel& label) const {
    if (label.left < 1 || label.top < 1 || label.right > ground_.width - 1 || label.bottom > ground_.height - 1)
      return false;
    const Spot middle{0.5 * (label.left + label.right), 0.5 * (label.top + label.bottom)};
    return std::none_of(placed.begin(), placed.end(), [&](const PlacedLabel& other) {
      const Spot otherMiddle{0.5 * (other.left + other.right), 0.5 * (other.top + other.bottom)};
      return touches(label, other) || (label.leader && crosses(middle, *label.leader, other)) ||
             (other.leader && crosses(otherMiddle, *other.leader, label)) ||
             (other.leader && holds(label, *other.leader));
    });
  }

  const LabelGround& ground_;
  double size_;
};

}  // namespace

std::vector<PlacedLabel> placeLabels(const LabelGround& ground, const std::vector<LabelWish>& wishes, double textSize) {
  const std::vector<double> distances = distancesInside(ground);
  std::map<std::uint32_t, Room> rooms;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (ground.owners[i] == 0) continue;
    Room& room = rooms[ground.owners[i]];
    if (distances[i] > room.reach)
      room = {{double(i % ground.width) + 0.5, double(i / ground.width) + 0.5}, distances[i]};
  }
  std::vector<Candidate> candidates;
  for (const LabelWish& wish : wishes) {
    if (wish.text.empty()) continue;
    const auto room = rooms.find(wish.owner);
    if (room != rooms.end()) candidates.push_back({&wish, room->second});
    else if (wish.at && wish.at->x > 0 && wish.at->y > 0 && wish.at->x < ground.width && wish.at->y < ground.height)
      candidates.push_back({&wish, {*wish.at, 0}});
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.room.reach != b.room.reach ? a.room.reach > b.room.reach : a.wish->owner < b.wish->owner;
  });
  Places places(ground, textSize);
  for (const Candidate& candidate : candidates) places.take(candidate, candidates);
  return places.placed;
}

void drawLabels(Drawing& drawing, const std::vector<PlacedLabel>& labels, double left, double top, double textSize) {
  const double halo = std::max(1.2, 0.16 * textSize);
  for (const PlacedLabel& label : labels) {
    if (!label.leader) continue;
    const Spot from{left + 0.5 * (label.left + label.right), top + 0.5 * (label.top + label.bottom)};
    const Spot to{left + label.leader->x, top + label.leader->y};
    drawing.line({from, to}, {.width = 2.4, .colour = paper});
    drawing.line({from, to}, {.width = 1, .colour = ink});
    drawing.disc(to, 2.2, ink);
  }
  for (const PlacedLabel& label : labels)
    drawing.text({left + 0.5 * (label.left + label.right), top + 0.5 * (label.top + label.bottom) + 0.36 * textSize},
                 label.text, {.size = textSize, .colour = ink, .anchor = Anchor::centre, .halo = halo});
}

}  // namespace morula
