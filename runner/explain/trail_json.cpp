#include "explain/trail_json.h"

#include "base/error.h"
#include "golden/number_text.h"
#include "system/json.h"

namespace morula {

namespace {

Hash hashFrom(const Json& j) {
  const auto hash = readHash(j.get<std::string>());
  if (!hash) throw InputError("the trail: '" + j.get<std::string>() + "' is no hash");
  return *hash;
}

Json toJson(const ChainLink& link) {
  const StateHashes& s = link.state;
  Json cells = Json::array();
  for (const CellHash& c : s.cells) cells.push_back({c.path.text(), c.hash.text()});
  return {{"step", link.step},           {"whole", s.whole.text()},
          {"clock", s.clock.text()},     {"connections", s.connections.text()},
          {"lineage", s.lineage.text()}, {"cells", cells}};
}

/// `before`: the hash of the link before, if there is one.
ChainLink linkFrom(const Json& j, const std::optional<Hash>& before) {
  ChainLink link;
  j.at("step").get_to(link.step);
  link.state = {hashFrom(j.at("whole")),
                hashFrom(j.at("clock")),
                {},
                hashFrom(j.at("connections")),
                hashFrom(j.at("lineage"))};
  for (const Json& cell : j.at("cells"))
    link.state.cells.push_back({CellPath::parse(cell.at(0).get<std::string>()), hashFrom(cell.at(1))});
  link.hash = hashLink(before, link.step, link.state.whole);
  return link;
}

}  // namespace

std::string writeTrail(const Trail& trail) {
  Json links = Json::array();
  for (const ChainLink& link : trail.links) links.push_back(toJson(link));
  return jsonText({{"links", links}, {"last_step", trail.lastStep}, {"failure", trail.failure}}) + '\n';
}

Trail readTrail(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    Trail trail;
    for (const Json& j : json.at("links"))
      trail.links.push_back(
          linkFrom(j, trail.links.empty() ? std::nullopt : std::optional(trail.links.back().hash)));
    json.at("last_step").get_to(trail.lastStep), json.at("failure").get_to(trail.failure);
    return trail;
  } catch (const Json::exception& error) {
    throw InputError(std::string("the trail is cut short, or another version's: ") + error.what());
  }
}

}  // namespace morula
