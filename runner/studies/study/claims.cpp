// Claims on the results that must stay true: `check` of a study file.
#include <algorithm>

#include "files/text.h"
#include "observation/asked_measure.h"
#include "study/conditions.h"
#include "study/study_table.h"
#include "values/value_types.h"

namespace morula::study {

using scenario::Node;
using scenario::Problems;

namespace {

using Levels = std::vector<std::optional<std::size_t>>;  // [axis]

const std::string claimAllowed =
    "{measure: NAME, a: {AXIS: LABEL}, b: {AXIS: LABEL}, says: lower} or {measure: NAME, at: {AXIS: LABEL}, mean: 1.2, "
    "within: 0.1}";
const std::string marginAllowed = "a number above 0 as 0.01, or a share of the mean as 5%";

/// Reads one entry of `check`.
class ClaimReader {
 public:
  ClaimReader(const Study& study, const Node& node, std::string path, Problems& problems)
      : study_(study), node_(node), path_(std::move(path)), problems_(problems) {}

  /// Returns the claim; absent after a mistake, which is reported.
  std::optional<Claim> read() {
    const std::size_t before = problems_.size();
    if (node_.kind != Node::Kind::map) return scenario::refuse(node_, path_, claimAllowed, problems_), std::nullopt;
    const bool ofMean = node_.find("at") || node_.find("mean");
    const std::vector<std::string> keys = ofMean ? std::vector<std::string>{"measure", "at", "mean", "within"}
                                                 : std::vector<std::string>{"measure", "a", "b", "says", "within"};
    scenario::refuseUnknown(node_, path_, keys, problems_);
    claim_.place = node_.place;
    readMeasure();
    if (ofMean) readMean();
    else readPair();
    return problems_.size() == before ? std::optional(std::move(claim_)) : std::nullopt;
  }

 private:
  const Node* needed(const char* key, const std::string& allowed) {
    if (const auto* member = node_.find(key)) return &member->value;
    problems_.add(node_.place, path_ + "." + key, "is missing", "needs " + allowed);
    return nullptr;
  }

  void readMeasure() {
    const std::string allowed = "one of the study's measures: " + join(study_.measures);
    const Node* node = needed("measure", allowed);
    const auto text = node ? scenario::readText(*node, path_ + ".measure", allowed, problems_) : std::nullopt;
    if (!text || study_.measures.empty()) return;
    std::string name = *text;
    try {
      if (const auto measure = findMeasure(name)) name = measure->name;
    } catch (const InputError&) {  // an invalid name is no measure of the study either
    }
    if (std::ranges::find(study_.measures, name) == study_.measures.end())
      problems_.add(node->place, path_ + ".measure", "the study does not measure '" + *text + "'",
                    nearOf(name, study_.measures));
    claim_.measure = name;
  }

  /// Returns the levels that a map {AXIS: LABEL} names.
  Levels readLevels(const char* key, const Node& node) {
    const std::string path = path_ + "." + key;
    Levels levels(study_.axes.size());
    if (node.kind != Node::Kind::map)
      return scenario::refuse(node, path, "a map of axes and labels, as {division: longest}", problems_), levels;
    for (const auto& member : node.members)
      if (const auto axis = axisNamed(study_, member, path, problems_))
        levels[*axis] = levelNamed(study_.axes[*axis], member.value, path + "." + member.key, problems_);
    return levels;
  }

  /// Returns the axes with several levels of which `levels` fixes none.
  std::vector<std::string> openAxes(const Levels& levels) const {
    std::vector<std::string> open;
    for (std::size_t a = 0; a < levels.size(); ++a)
      if (!levels[a] && study_.axes[a].levels.size() > 1) open.push_back(study_.axes[a].name);
    return open;
  }

  /// Adds a problem if no condition with these levels is run.
  void requireRun(const Levels& levels, const char* key) {
    const auto fits = [&](const Condition& condition) {
      for (std::size_t a = 0; a < levels.size(); ++a)
        if (levels[a] && *levels[a] != condition.levels[a]) return false;
      return true;
    };
    const std::vector<Condition> conditions = study_.leftOut.empty() ? std::vector<Condition>() : conditionsOf(study_);
    if (!conditions.empty() && std::ranges::none_of(conditions, fits))
      problems_.add(node_.place, path_ + "." + key, "names a combination that leave-out leaves out",
                    "needs one that is run");
  }

  void readMargin() {
    const Node* node = needed("within", marginAllowed);
    if (!node || !node->isPlain())
      return node ? scenario::refuse(*node, path_ + ".within", marginAllowed, problems_) : void();
    std::string number = node->text;
    if (number.ends_with('%')) number.pop_back();
    const auto size = scenario::parseReal(number);
    if (!size.wrong.empty() || !(size.value > 0))
      problems_.add(node->place, path_ + ".within", describe(*node) + " is no margin", "needs " + marginAllowed);
    claim_.within = node->text, claim_.marginPlace = node->place;
  }

  void readMean() {
    claim_.says = Says::mean;
    const auto* at = node_.find("at");
    claim_.a = at ? readLevels("at", at->value) : Levels(study_.axes.size());
    if (const auto open = openAxes(claim_.a); !open.empty())
      problems_.add(node_.place, path_ + ".at", "does not select a single condition",
                    "needs a label of " + join(open, " and ") + ", too");
    else requireRun(claim_.a, "at");
    if (const Node* node = needed("mean", "a number"))
      claim_.mean = scenario::readReal(*node, scenario::Range{}, path_ + ".mean", "a number", problems_).value_or(0);
    readMargin();
  }

  void readPair() {
    const std::string allowed = "a map of axes and labels, as {division: longest}";
    const Node *a = needed("a", allowed), *b = needed("b", allowed);
    if (const Node* node = needed("says", namesOf<Says>()))
      if (const auto text = scenario::readText(*node, path_ + ".says", namesOf<Says>(), problems_))
        readSays(*node, *text);
    if (claim_.says == Says::equivalent) readMargin();
    else if (const auto* within = node_.find("within"))
      problems_.add(within->place, path_ + ".within", "has no effect without says: equivalent", "remove it");
    if (!a || !b) return;
    const std::size_t before = problems_.size();
    claim_.a = readLevels("a", *a), claim_.b = readLevels("b", *b);
    if (problems_.size() > before) return;
    requireRun(claim_.a, "a"), requireRun(claim_.b, "b");
    std::size_t differing = 0, named = 0;
    for (std::size_t x = 0; x < claim_.a.size(); ++x)
      differing += claim_.a[x] != claim_.b[x], named += claim_.a[x].has_value() == claim_.b[x].has_value();
    const auto open = openAxes(claim_.a);
    std::size_t several = 0;
    for (const StudyAxis& axis : study_.axes) several += axis.levels.size() > 1;
    if (differing != 1 || named != claim_.a.size())
      problems_.add(b->place, path_ + ".b",
                    named != claim_.a.size() ? "names other axes than a"
                                             : "differs from a in " + std::to_string(differing) + " axes",
                    "name the same axes in both, with different labels of one of them");
    else if (!open.empty() && open.size() + 1 != several)
      problems_.add(a->place, path_ + ".a", "names some of the other axes, but not all",
                    "needs a label of " + join(open, " and ") +
                        ", too, or only of the axis that differs, for the mean over the others");
  }

  void readSays(const Node& node, const std::string& text) {
    std::vector<std::string> names;
    for (const auto& row : choices<Says>) names.push_back(row.name);
    if (const auto says = valueNamed<Says>(text)) claim_.says = *says;
    else problems_.add(node.place, path_ + ".says", describe(node) + " is not known here", nearOf(text, names));
  }

  const Study& study_;
  const Node& node_;
  std::string path_;
  Problems& problems_;
  Claim claim_;
};

}  // namespace

Key checkKey() {
  const Json text{{"type", "string"}}, labels{{"type", "object"}, {"additionalProperties", text}, {"minProperties", 1}};
  Json says = Json::array();
  for (const auto& row : choices<Says>) says.push_back(row.name);
  const Json within{{"type", Json::array({"number", "string"})}};
  const Json pair = objectSchema(
                 {{"measure", text}, {"a", labels}, {"b", labels}, {"says", {{"enum", says}}}, {"within", within}},
                 {"measure", "a", "b", "says"}),
             mean =
                 objectSchema({{"measure", text}, {"at", labels}, {"mean", {{"type", "number"}}}, {"within", within}},
                              {"measure", "mean", "within"});
  return {
      "check",
      "a list of " + claimAllowed,
      "Claims that `morula study check` compares with the results of `morula study compare`. A claim on a pair: "
      "says tells how a compares with b: lower or higher (a difference is shown), equivalent (within a margin, "
      "which `within` gives) or no-effect (no difference is shown). A margin is a number as 0.01 or a share of the "
      "mean as 5%, of sphericity a share of 1 − the mean; one that is wider than the range of all values is refused. "
      "a and b name labels of the same axes and differ in one; they name labels of all other axes, or of none for "
      "the mean over them. A claim on a condition, which `at` names: mean is its mean, to within `within`",
      "no claims",
      {{"type", "array"}, {"items", {{"oneOf", Json::array({pair, mean})}}}, {"minItems", 1}},
      [](Study&, const Node&, Problems&) {}};  // claims are read by readClaims, once all axes are known
}

void readClaims(const Node& root, Study& study, Problems& problems) {
  const auto* check = root.find("check");
  if (!check || !scenario::expectEntries(check->value, "check", checkKey().allowed, problems)) return;
  for (std::size_t i = 0; i < check->value.items.size(); ++i)
    if (auto claim = ClaimReader(study, check->value.items[i], "check[" + std::to_string(i) + "]", problems).read())
      study.claims.push_back(std::move(*claim));
}

}  // namespace morula::study
