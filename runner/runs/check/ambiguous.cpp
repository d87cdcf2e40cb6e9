#include "check/ambiguous.h"

#include <map>

#include "division/rules.h"

namespace morula {

std::vector<DivisionRecord> ambiguousDivisions(const Scene& scene, const std::vector<LineageEntry>& lineage,
                                               const std::function<std::string(StateId)>& describe,
                                               const std::vector<DivisionRecord>& divisions) {
  std::vector<DivisionRecord> ambiguous;
  if (!scene.mechanics) return ambiguous;
  std::map<CellPath, StateId> states;  // of mothers, as they were when they divided
  for (const LineageEntry& cell : lineage) states.emplace(cell.path, cell.state);
  for (const DivisionRecord& d : divisions) {
    if (!d.extentRatio || !(*d.extentRatio < ambiguousExtentRatio)) continue;
    const auto mother = states.find(d.path);
    const std::string substances = mother == states.end() ? "" : describe(mother->second);
    if (planeFor(scene.mechanics->division, substances).plane == DivisionPlane::longest) ambiguous.push_back(d);
  }
  return ambiguous;
}

}  // namespace morula
