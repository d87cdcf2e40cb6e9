#include "explain/hash_trace_json.h"

#include "base/error.h"
#include "base/read_hash.h"
#include "golden/number_text.h"
#include "system/json_record.h"

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
  link.step = wholeFrom<std::uint64_t>(j.at("step"));
  link.state = {
      hashFrom(j.at("whole")), hashFrom(j.at("clock")), {}, hashFrom(j.at("connections")), hashFrom(j.at("lineage"))};
  for (const Json& cell : j.at("cells"))
    link.state.cells.push_back({CellPath::parse(cell.at(0).get<std::string>()), hashFrom(cell.at(1))});
  link.hash = hashLink(before, link.step, link.state.whole);
  return link;
}

}  // namespace

std::string writeHashTrace(const HashTrace& trace) {
  Json links = Json::array();
  for (const ChainLink& link : trace.links) links.push_back(toJson(link));
  return jsonText({{"links", links}, {"last_step", trace.lastStep}, {"failure", trace.failure}}) + '\n';
}

HashTrace readHashTrace(const std::string& text) {
  try {
    const Json json = parseJson(text);
    HashTrace trace;
    for (const Json& j : json.at("links"))
      trace.links.push_back(linkFrom(j, trace.links.empty() ? std::nullopt : std::optional(trace.links.back().hash)));
    trace.lastStep = wholeFrom<std::uint64_t>(json.at("last_step"));
    json.at("failure").get_to(trace.failure);
    return trace;
  } catch (const Json::exception& error) {
    throw InputError(std::string("the trail is cut short, or another version's: ") + error.what());
  }
}

}  // namespace morula
