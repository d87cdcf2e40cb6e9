#include "study/conditions.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "base/error.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "files/text.h"
#include "loop/simulate.h"
#include "observation/asked_measure.h"
#include "scenario/loading.h"
#include "study/study_table.h"
#include "values/cell_words.h"
#include "values/measure_list.h"

namespace morula::study {

using scenario::Problems;

namespace {

/// Returns true if the line names the place of a value that the level sets.
bool standsIn(const Level& level, const std::string& line) {
  return std::ranges::any_of(level.overrides,
                             [&](const Override& change) { return line.starts_with(change.place + ":"); });
}

/// Returns the conditions that have this line: " (under connections: none)", " (in 3 of 15 conditions, the first
/// division: longest, connections: both)". Returns "" if all have it, or if it names the place of the one level whose
/// conditions have it.
std::string whereText(const Study& study, const std::vector<Condition>& conditions, const std::string& line,
                      const std::set<std::size_t>& has) {
  if (has.size() == conditions.size()) return "";
  for (std::size_t axis = 0; axis < study.axes.size(); ++axis)
    for (std::size_t level = 0; level < study.axes[axis].levels.size(); ++level) {
      const Level& one = study.axes[axis].levels[level];
      const auto isOfLevel = [&](const Condition& c) { return c.levels[axis] == level; };
      if (std::ranges::all_of(conditions, [&](const Condition& c) { return isOfLevel(c) == has.contains(c.number); }))
        return standsIn(one, line) ? "" : " (under " + study.axes[axis].name + ": " + one.label + ")";
    }
  const auto first = std::ranges::find(conditions, *has.begin(), &Condition::number);
  const std::string name = conditionName(study, first->labels);
  if (has.size() == 1) return " (under " + name + ")";
  return " (in " + std::to_string(has.size()) + " of " + std::to_string(conditions.size()) + " conditions, the first " +
         name + ")";
}

class ConditionMistakes {
 public:
  /// Adds the lines of a condition's InputError.
  void add(std::size_t condition, const std::string& lines) {
    for (const std::string& line : linesOf(lines)) {
      if (line.empty()) continue;
      const auto [at, isNew] = numbers_.try_emplace(line, lines_.size());
      if (isNew) lines_.push_back({line, {}});
      lines_[at->second].second.insert(condition);
    }
  }
  /// Reports each line once. If only some of `conditions` have it, the line names them, unless they are those of the
  /// level at whose place in the study file it stands.
  void tell(const Study& study, const std::vector<Condition>& conditions, Problems& problems) const {
    for (const auto& [line, has] : lines_) problems.addForeign({}, line + whereText(study, conditions, line, has));
  }

 private:
  std::vector<std::pair<std::string, std::set<std::size_t>>> lines_;  // in the order of their first occurrence
  std::map<std::string, std::size_t> numbers_;                        // the index of each text in lines_
};

struct BaseFile {
  std::filesystem::path path;
  std::optional<std::string> bytes;  // absent: an unreadable file, which has been reported
};

std::vector<BaseFile> readBases(const Study& study, Problems& problems) {
  const auto folder = folderOf(study.file);
  std::vector<BaseFile> files;
  for (const Base& base : study.bases) {
    auto& file = files.emplace_back(BaseFile{(folder / base.file).lexically_normal(), {}});
    try {
      if (!study.allowOutside && !liesWithin(file.path, sharedFolder(folder)))
        problems.add(base.place, "base", "'" + base.file + "' lies outside of the study's folder",
                     "move it there, or give --allow-outside if you trust this study with your files");
      else file.bytes = readFile(file.path);
    } catch (const FileError& error) {
      if (isPlainFile(file.path)) throw;  // not a mistake of the study
      problems.add(base.place, "base", error.what(), "names count from the study's folder");
    }
  }
  return files;
}

/// Returns true if every axis has a level.
bool hasLevels(const Study& study) {
  return std::ranges::none_of(study.axes, [](const StudyAxis& axis) { return axis.levels.empty(); });
}

bool isLeftOut(const LeftOut& out, const std::vector<std::size_t>& levels) {
  for (std::size_t axis = 0; axis < levels.size(); ++axis) {
    const auto& named = out.levels[axis];
    if (!named.empty() && std::ranges::find(named, levels[axis]) == named.end()) return false;
  }
  return true;
}

/// Replaces the scenario's measures and moments by the study's.
void takeOver(Scenario& scenario, const Study& study) {
  scenario.record = {};
  if (study.when.moments == Moments::every) scenario.record.every = study.when.every;
  bool comparesContacts = false, comparesPositions = false;
  for (const std::string& name : study.measures) {
    const AskedMeasure m = resolved(*findMeasure(name), scenario.names, scenario.scene.dna);
    for (const AskedMeasure& term : m.terms()) {
      comparesContacts |= term.needs == Needs::referenceContacts;
      comparesPositions |= term.needs == Needs::referencePositions;
    }
    if (m.onDemand) scenario.record.measures.push_back(m.name);
  }
  auto reference = std::move(scenario.check.reference);
  scenario.check = {};
  if (reference && !comparesContacts) reference->contacts.clear();
  if (reference && !comparesPositions) reference->positions.clear();
  if (comparesContacts || comparesPositions) scenario.check.reference = std::move(reference);
}

void checkMeasures(const Study& study, const Condition& condition, ConditionMistakes& mistakes) {
  for (std::size_t i = 0; i < study.measures.size(); ++i) {
    const auto place = [&] { return scenario::placeText(study.file, study.measurePlaces[i]) + ": measures: "; };
    const Scenario& scenario = condition.scenario;
    const AskedMeasure asked = *findMeasure(study.measures[i]);
    try {
      resolved(asked, scenario.names, scenario.scene.dna);
    } catch (const InputError& error) { mistakes.add(condition.number, place() + asked.name + ": " + error.what()); }
    for (const AskedMeasure& m : asked.terms()) {
      if (const std::string lacking = lackingFor(m.needs, scenario); !lacking.empty())
        mistakes.add(condition.number, place() + m.name + " would find nothing to measure; needs " + lacking);
      if (m.row == "contact_duration" && study.when.moments != Moments::every)
        mistakes.add(condition.number, place() + m.name + " counts from sample to sample; needs when: {every: T}");
    }
  }
}

}  // namespace

std::string conditionName(const Study& study, const std::vector<std::string>& labels) {
  std::string text;
  for (std::size_t axis = 0; axis < labels.size(); ++axis)
    text += (text.empty() ? "" : ", ") + study.axes[axis].name + ": " + labels[axis];
  return text.empty() ? "the scenario as it is" : text;
}

std::size_t countConditions(const Study& study) {
  std::size_t count = 1;
  const bool leavesOut = !study.leftOut.empty() && hasLevels(study);
  const std::size_t most = leavesOut ? 100 * maxConditions : maxConditions;
  for (const StudyAxis& axis : study.axes)
    count = std::min(count * std::max<std::size_t>(axis.levels.size(), 1), most + 1);
  if (count > most) return maxConditions + 1;
  return leavesOut ? conditionsOf(study, maxConditions + 1).size() : count;
}

std::vector<Condition> conditionsOf(const Study& study, std::size_t most) {
  std::vector<Condition> conditions;
  if (!hasLevels(study)) return conditions;
  std::vector<std::size_t> levels(study.axes.size());
  const auto isRun = [&] {
    return std::ranges::none_of(study.leftOut, [&](const LeftOut& out) { return isLeftOut(out, levels); });
  };
  const auto advance = [&] {
    for (std::size_t axis = levels.size(); axis-- > 0;) {
      if (++levels[axis] < study.axes[axis].levels.size()) return true;
      levels[axis] = 0;
    }
    return false;
  };
  do {
    if (!isRun()) continue;
    Condition& condition = conditions.emplace_back();
    condition.number = conditions.size() - 1;
    condition.levels = levels;
    for (std::size_t axis = 0; axis < levels.size(); ++axis)
      condition.labels.push_back(study.axes[axis].levels[levels[axis]].label);
    if (study.bases.size() > 1) condition.base = levels[0];
  } while (conditions.size() < most && advance());
  return conditions;
}

Scenario readConditionScenario(const Study& study, const Condition& condition, const std::string& bytes,
                               const std::string& file, const std::filesystem::path& folder,
                               const std::vector<NamedFile>& files) {
  std::vector<Override> overrides;
  for (std::size_t axis = 0; axis < study.axes.size(); ++axis)
    for (const Override& change : study.axes[axis].levels[condition.levels[axis]].overrides)
      overrides.push_back(change);
  overrides.push_back({"seed", std::to_string(study.seeds.front()), "seeds"});
  return readScenario(bytes, file, folder, overrides, files, study.allowOutside);
}

void finish(Condition& condition, const Study& study) {
  Scenario& s = condition.scenario;
  takeOver(s, study);
  resolveAgain(s);
  condition.usesSeed = usesSeed(s.scene);
  Hasher hasher;
  const std::uint64_t seed = std::exchange(s.scene.seed, 0);
  hasher.field("scene").add(scenario::hashMeaning(s));
  s.scene.seed = seed;
  scenario::addReference(hasher, s);
  if (study.keep.pictures != PicturesKept::none) {
    hasher.field("colours");
    for (const auto& [substance, colour] : s.colours) hasher.add(substance).add(colour);
    for (const CellColour& one : s.cellColours) hasher.add(one.text).add(one.colour);
  }
  condition.meaning = hasher.digest();
}

std::vector<Condition> loadConditions(const Study& study, Problems& problems, std::vector<std::string>& warnings,
                                      const Execution& execution, std::size_t most) {
  const auto bases = readBases(study, problems);
  std::vector<Condition> conditions = conditionsOf(study, most);
  ConditionMistakes mistakes;
  for (Condition& condition : conditions) {
    const BaseFile& base = bases[condition.base];
    if (!base.bytes) continue;
    try {
      condition.scenario =
          readConditionScenario(study, condition, *base.bytes, base.path.string(), folderOf(base.path), {});
      checkMeasures(study, condition, mistakes);
      makeScenarioWorld(condition.scenario, execution);  // throws for a time step above the stability limit
      for (const std::string& warning : condition.scenario.warnings)
        if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(warning);
    } catch (const InputError& error) { mistakes.add(condition.number, error.what()); }
  }
  mistakes.tell(study, conditions, problems);
  return conditions;
}

}  // namespace morula::study
