// Chirality as a rule spells it; that of all divisions is two parameters as any.
#include "values/value_types.h"

namespace morula::scenario {

std::optional<Chirality> readChirality(const Node& node, const std::string& path, Problems& problems) {
  if (node.kind != Node::Kind::map) {
    refuse(node, path, "{angle: 20, time: 0.5}", problems);
    return {};
  }
  refuseUnknown(node, path, {"angle", "time"}, problems);
  Chirality chirality;
  const auto read = [&](const char* key, const Range& range, const char* unit, double& value) {
    const Member* member = nullptr;
    for (const Member& one : node.members)
      if (one.key == key) member = &one;
    if (!member) return;
    const auto given = readReal(member->value, range, path + "." + key, numberAllowed(range, unit), problems);
    if (given) value = *given;
  };
  read("angle", chiralAngle, "degree", chirality.angle);
  read("time", positive, "time", chirality.time);
  return chirality;
}

Json writeChirality(const Chirality& c) { return {{"angle", c.angle}, {"time", c.time}}; }

Json chiralitySchema() {
  return {{"type", "object"},
          {"properties", {{"angle", numberSchema(chiralAngle)}, {"time", numberSchema(positive)}}},
          {"additionalProperties", false}};
}

}  // namespace morula::scenario
