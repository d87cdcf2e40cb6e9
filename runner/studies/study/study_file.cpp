#include "study/study_file.h"

#include "files/read_file.h"
#include "files/text.h"
#include "study/conditions.h"
#include "study/study_table.h"
#include "yaml/node.h"

namespace morula {

using scenario::Node;
using scenario::Problems;

namespace {

/// Reports a scenario in place of a study as one mistake, not key by key.
void refuseScenario(const Node& root, Problems& problems) {
  const auto* version = root.find("morula");
  if (!version || root.find("morula-study")) return;
  problems.add(version->place, "morula", "the file is a scenario, not a study",
               "morula run runs it; morula init --study writes a study to begin with");
  problems.throwIfAny();
}

void addBaseAxis(Study& study) {
  if (study.bases.size() < 2) return;
  StudyAxis axis{"base", {}};
  for (const Base& base : study.bases) axis.levels.push_back({base.label, {}});
  study.axes.insert(study.axes.begin(), std::move(axis));
}

void checkSize(const Study& study, const Node& root, Problems& problems) {
  const std::size_t conditions = study::countConditions(study);
  const auto* vary = root.find("vary");
  const scenario::Place place = vary ? vary->place : root.place;
  if (conditions == 0)
    problems.add(root.find("leave-out")->place, "leave-out", "leaves no combination to run", "leave out fewer");
  else if (conditions > study::maxConditions)
    problems.add(place, "vary", "makes more than " + std::to_string(study::maxConditions) + " conditions",
                 "vary fewer axes at a time, or fewer levels");
  else if (conditions * study.seeds.size() > study::maxReplicates)
    problems.add(
        place, "vary",
        "makes " + std::to_string(conditions) + " conditions of " + std::to_string(study.seeds.size()) + " seeds each",
        "at most " + std::to_string(study::maxReplicates) + " runs: give fewer seeds or levels");
}

/// Checks the scenarios as far as possible although the study file has mistakes.
void lookAtScenarios(Study study, const std::set<std::string>& clashing, Problems& problems) {
  constexpr std::size_t enough = 200;  // max conditions
  if (study.bases.empty()) return;
  study.leftOut.clear();  // its axes may be gone
  std::erase_if(study.axes, [&](const StudyAxis& axis) { return axis.levels.empty() || clashing.contains(axis.name); });
  if (study.seeds.empty()) study.seeds = {1};
  std::vector<std::string> warnings;
  study::loadConditions(study, problems, warnings, {}, enough);
}

}  // namespace

Study loadStudy(const std::filesystem::path& file, bool allowOutside) {
  return readStudy(readFile(file), file, allowOutside);
}

Study readStudy(std::string bytes, const std::filesystem::path& file, bool allowOutside) {
  Study study;
  study.file = file.string();
  study.bytes = std::move(bytes);
  study.allowOutside = allowOutside;
  Problems problems(study.file);
  const scenario::SourceText source(study.bytes, problems);
  problems.throwIfAny();
  const Node root = readYaml(source, problems);
  if (root.kind == Node::Kind::broken) problems.throwIfAny();
  refuseScenario(root, problems);
  study::readKeys(root, study, problems);
  addBaseAxis(study);
  study::readLeftOut(root, study, problems);
  study::readClaims(root, study, problems);
  const auto clashing = study::checkAxes(study, problems);
  checkSize(study, root, problems);
  if (!problems.empty()) lookAtScenarios(study, clashing, problems);
  problems.throwIfAny();
  return study;
}

AllowedRuns allowedIn(const std::string& bytes) {
  Problems problems("");
  const scenario::SourceText source(bytes, problems);
  if (!problems.empty()) return {};
  const Node root = readYaml(source, problems);
  Study study;
  for (const study::Key& key : study::keys())
    if (key.path == "limits.failed" || key.path == "limits.insane")
      if (const auto* limits = root.find("limits"))
        if (const auto* value = limits->value.find(key.path.substr(7))) key.read(study, value->value, problems);
  return problems.empty() ? study.allowed : AllowedRuns{};
}

void addLeftOut(Study& study) {
  Problems problems("");
  const scenario::SourceText source(study.bytes, problems);
  const Node root = readYaml(source, problems);
  study::readLeftOut(root, study, problems);
}

bool isStudy(const std::filesystem::path& file) {
  if (file.filename().string().ends_with(".study.yaml")) return true;
  for (std::string_view line : linesOf(readHead(file, 4096))) {
    while (!line.empty() && (line[0] == ' ' || line[0] == '\xEF' || line[0] == '\xBB' || line[0] == '\xBF'))
      line.remove_prefix(1);
    if (line.empty() || line[0] == '#' || line.starts_with("---") || line == "\r") continue;
    return line.starts_with("morula-study");
  }
  return false;
}

}  // namespace morula
