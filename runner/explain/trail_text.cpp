#include "explain/trail_text.h"

#include <sstream>

#include "base/error.h"
#include "golden/number_text.h"

namespace morula {

namespace {

std::string nameOf(const CellPath& path) { return path.isEgg() ? "-" : path.text(); }

Hash readHash(const std::string& text) {
  Hash h;
  const char* middle = text.data() + 16;
  const bool whole = text.size() == 32 && std::from_chars(text.data(), middle, h.high, 16).ptr == middle &&
                     std::from_chars(middle, middle + 16, h.low, 16).ptr == middle + 16;
  if (!whole) throw InputError("'" + text + "' is no hash");
  return h;
}

std::uint64_t readStep(const std::string& text) {
  const auto step = readNatural(text);
  if (!step) throw InputError("'" + text + "' is no step");
  return *step;
}

ChainLink readLink(std::istringstream& words) {
  ChainLink link;
  std::string step, whole, clock, connections, lineage, cell;
  words >> step >> whole >> clock >> connections >> lineage;
  link.step = readStep(step);
  link.state = {readHash(whole), readHash(clock), {}, readHash(connections), readHash(lineage)};
  while (words >> cell) {
    const auto colon = cell.find(':');
    if (colon == cell.npos) throw InputError("'" + cell + "' is no cell's hash");
    const auto path = cell.substr(0, colon);
    link.state.cells.push_back(
        {path == "-" ? CellPath{} : CellPath::parse(path), readHash(cell.substr(colon + 1))});
  }
  return link;
}

}  // namespace

std::string writeTrail(const Trail& trail) {
  std::string text;
  for (const ChainLink& link : trail.links) {
    const StateHashes& s = link.state;
    text += "link " + std::to_string(link.step) + ' ' + s.whole.text() + ' ' + s.clock.text() + ' ' +
            s.connections.text() + ' ' + s.lineage.text();
    for (const CellHash& c : s.cells) text += ' ' + nameOf(c.path) + ':' + c.hash.text();
    text += '\n';
  }
  text += "end " + std::to_string(trail.lastStep);
  if (!trail.failure.empty()) text += ' ' + trail.failure;
  return text + '\n';
}

Trail readTrail(const std::string& text) {
  Trail trail;
  std::istringstream lines(text);
  int number = 0;
  bool ended = false;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::istringstream words(line);
    std::string kind, step;
    words >> kind;
    try {
      if (ended) throw InputError("something follows the end");
      if (kind == "link") {
        ChainLink link = readLink(words);
        const auto before = trail.links.empty() ? std::nullopt : std::optional(trail.links.back().hash);
        link.hash = hashLink(before, link.step, link.state.whole);
        trail.links.push_back(std::move(link));
      } else if (kind == "end") {
        words >> step >> std::ws;
        trail.lastStep = readStep(step);
        std::getline(words, trail.failure);
        ended = true;
      } else {
        throw InputError("'" + kind + "' begins no line of a trail");
      }
    } catch (const InputError& e) {
      throw InputError("trail, line " + std::to_string(number) + ": " + e.what());
    }
  }
  if (!ended) throw InputError("the trail is cut short: it has no end");
  return trail;
}

}  // namespace morula
