#include "study/plan_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "files/text.h"

namespace morula {
namespace {

using FileTexts = std::vector<std::string>;

FileTexts textsOf(const Json& list) {
  FileTexts texts;
  for (const Json& entry : list) texts.push_back(entry.is_string() ? entry.get<std::string>() : jsonText(entry));
  return texts;
}

/// Returns "division.plane: longest, physics.contact: removed".
std::string changesInWords(const Json& level) {
  FileTexts texts;
  for (const Json& change : level.at("changes"))
    texts.push_back(change.at("key").get<std::string>() + ": " +
                    (change.at("removes").get<bool>() ? "removed" : change.at("value").get<std::string>()));
  return texts.empty() ? "nothing" : join(texts);
}

FileTexts labelsOf(const Json& axis) {
  FileTexts labels;
  for (const Json& level : axis.at("levels")) labels.push_back(level.at("label").get<std::string>());
  return labels;
}

class Comparison {
 public:
  Comparison(const Json& then, const Json& now) : then_(then), now_(now) {}

  PlanDifference run() {
    say("name", "study", "");
    compareAxes();
    for (const char* key : {"measures", "when", "every", "keep", "limits"}) say(key, key, " of the study");
    compareSeeds();
    if (haveSameAxes_) compareConditions();
    if (found_.isNone() && then_.at("id") != now_.at("id"))
      found_.stale.push_back("the results belong to another plan than the study file's");
    return std::move(found_);
  }

 private:
  const Json& then(const char* key) const { return then_.at("study").at(key); }
  const Json& now(const char* key) const { return now_.at("study").at(key); }

  void differ(const std::string& what, const std::string& then, const std::string& now) {
    found_.stale.push_back(fmt::format("{}: {} in the results, {} by the study file", what, then, now));
  }

  void say(const char* key, const std::string& what, const std::string& of) {
    if (then(key) == now(key)) return;
    const auto text = [](const Json& value) { return value.is_array() ? join(textsOf(value)) : jsonText(value); };
    differ(what + of, text(then(key)), text(now(key)));
  }

  void compareAxes() {
    FileTexts before, after;
    for (const Json& axis : then("axes")) before.push_back(axis.at("name").get<std::string>());
    for (const Json& axis : now("axes")) after.push_back(axis.at("name").get<std::string>());
    if (before != after) {
      haveSameAxes_ = false;
      return differ("axes", before.empty() ? "none" : join(before), after.empty() ? "none" : join(after));
    }
    for (std::size_t a = 0; a < after.size(); ++a) {
      const Json &was = then("axes").at(a), &is = now("axes").at(a);
      if (labelsOf(was) != labelsOf(is)) {
        haveSameAxes_ = false;
        differ("levels of the axis " + after[a], join(labelsOf(was)), join(labelsOf(is)));
        continue;
      }
      for (std::size_t l = 0; l < is.at("levels").size(); ++l) {
        const std::string label = labelsOf(is)[l], before = changesInWords(was.at("levels").at(l)),
                          after_ = changesInWords(is.at("levels").at(l));
        if (before == after_) continue;
        changedLevels_.insert({a, label});
        differ(fmt::format("the level {} of the axis {} sets", label, after[a]), before, after_);
      }
    }
  }

  void compareSeeds() {
    const Json &was = then("seeds"), &is = now("seeds");
    const auto without = [](const Json& list, const Json& others) {
      FileTexts some;
      for (const Json& seed : list)
        if (std::ranges::find(others, seed) == others.end()) some.push_back(jsonText(seed));
      return some;
    };
    if (const FileTexts lacking = without(is, was); !lacking.empty()) {
      found_.missing = lacking.size() * now_.at("conditions").size();
      found_.lacking.push_back(fmt::format("the results lack {} {} of the study file: {} of its runs are missing",
                                           lacking.size() == 1 ? "the seed" : "the seeds", join(lacking),
                                           found_.missing));
    }
    if (const FileTexts more = without(was, is); !more.empty())
      found_.stale.push_back(fmt::format("the results have {} {}, which the study file does not ask for",
                                         more.size() == 1 ? "the seed" : "the seeds", join(more)));
  }

  /// Returns the texts of a condition's files by role and path.
  static std::map<std::string, std::string> filesOf(const Json& plan, const Json& condition) {
    std::map<std::string, std::string> files;
    const auto add = [&](const Json& number) {
      const Json& file = plan.at("files").at(number.get<std::size_t>());
      files[file.at("role").get<std::string>() + " '" + file.at("path").get<std::string>() + '\''] =
          file.at("text").get<std::string>();
    };
    add(condition.at("scenario"));
    for (const Json& number : condition.at("files")) add(number);
    return files;
  }

  /// Finds conditions with the labels of old ones but with another meaning, such as by a changed file.
  void compareConditions() {
    std::map<Json, const Json*> before;
    for (const Json& condition : then_.at("conditions")) before[condition.at("labels")] = &condition;
    std::set<std::string> changed;
    bool otherwise = false;
    for (const Json& condition : now_.at("conditions")) {
      const auto was = before.find(condition.at("labels"));
      if (was == before.end() || was->second->at("meaning") == condition.at("meaning")) continue;
      const FileTexts labels = textsOf(condition.at("labels"));
      bool isTold = false;
      for (std::size_t a = 0; a < labels.size(); ++a) isTold = isTold || changedLevels_.contains({a, labels[a]});
      if (isTold) continue;
      const auto then = filesOf(then_, *was->second), now = filesOf(now_, condition);
      const std::size_t known = changed.size();
      bool anyChanged = false;
      for (const auto& [file, text] : now)
        if (const auto at = then.find(file); at == then.end() || at->second != text)
          changed.insert(file), anyChanged = true;
      otherwise = otherwise || (!anyChanged && known == changed.size());
    }
    for (const std::string& file : changed)
      found_.stale.push_back("the " + file + " has changed since the results were computed");
    if (otherwise && changed.empty())
      found_.stale.push_back("this build interprets the conditions differently from the build that computed them");
  }

  const Json &then_, &now_;
  PlanDifference found_;
  bool haveSameAxes_ = true;
  std::set<std::pair<std::size_t, std::string>> changedLevels_;  // pairs of axis and label
};

}  // namespace

PlanDifference differenceFrom(const Json& stored, const Plan& now) {
  return Comparison(stored, parseJson(writePlan(now))).run();
}

}  // namespace morula
