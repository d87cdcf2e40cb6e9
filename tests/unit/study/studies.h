#pragma once
// Studies for tests: files in a folder of their own.
#include <string>

#include "study/plan.h"
#include "temporary_folder.h"

namespace morula {

/// A tree of four cells without bodies: the cheapest scene.
inline const std::string lineageScenario =
    "morula: 1\nname: tree\nseed: 1\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {cycles: 2}\n";

/// Balls that divide and touch; a run takes well under a millisecond.
inline const std::string ballScenario =
    "morula: 1\nname: balls\nseed: 1\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {cycles: 3}\n"
    "physics:\n  cell: {model: sphere, radius: 0.5, mass: 1}\n  drag: 20\n  shell: {sphere: 1}\n  contact: "
    "{stiffness: 30}\n"
    "division: {plane: random}\n";

inline const std::string ballStudy =
    "morula-study: 1\nname: balls\nbase: balls.yaml\n"
    "vary:\n"
    "  division: {random: {division.plane: random}, x: {division.plane: {axis: [1, 0, 0]}}}\n"
    "  connections: {none: {}, both: {connections.make: at-division, connections.on-division: both}}\n"
    "seeds: 1..3\nmeasures: [sister-contact, clone_radius]\n";

/// Returns `ballStudy` with `text` replaced by `by`.
inline std::string ballStudyWith(const std::string& text, const std::string& by) {
  std::string study = ballStudy;
  const auto at = study.find(text);
  if (at == study.npos) throw std::logic_error("no '" + text + "' in the study");
  return study.replace(at, text.size(), by);
}

/// Writes both scenarios and the study into the folder.
inline Study studyIn(const TemporaryFolder& folder, const std::string& study) {
  writeText(folder / "balls.yaml", ballScenario);
  writeText(folder / "tree.yaml", lineageScenario);
  writeText(folder / "s.study.yaml", study);
  return loadStudy(folder / "s.study.yaml");
}

inline Plan planIn(const TemporaryFolder& folder, const std::string& study = ballStudy, bool predict = false) {
  return makePlan(studyIn(folder, study), {.predict = predict});
}

}  // namespace morula
