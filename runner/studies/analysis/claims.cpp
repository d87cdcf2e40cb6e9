#include "analysis/claims.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/compare_parts.h"
#include "base/error.h"
#include "base/number_text.h"
#include "yaml/problems.h"

namespace morula {
namespace {

/// Returns the axis in which the sides of a pair differ.
std::size_t axisOf(const Claim& claim) {
  return std::size_t(std::ranges::mismatch(claim.a, claim.b).in1 - claim.a.begin());
}

std::string claimInWords(const Claim& claim, const StudyResults& results) {
  if (claim.says == Says::mean)
    return fmt::format("{}: {} ± {}{}", claim.measure, exactText(claim.mean), claim.within,
                       withLevels(results, claim.a));
  const std::size_t axis = axisOf(claim);
  const auto& labels = results.axes[axis].labels;
  const std::string a = labels[*claim.a[axis]], b = labels[*claim.b[axis]];
  auto others = claim.a;
  others[axis].reset();
  const std::string with = withLevels(results, others);
  switch (claim.says) {
    case Says::equivalent:
      return fmt::format("{}: {} equivalent to {} within {}{}", claim.measure, a, b, claim.within, with);
    case Says::noEffect: return fmt::format("{}: no effect of {} as compared with {}{}", claim.measure, a, b, with);
    default: return fmt::format("{}: {} {} than {}{}", claim.measure, a, nameOf(claim.says), b, with);
  }
}

void requireSame(const StudyResults& results, const Study& study) {
  if (canHold(results, study)) return;
  throw InputError(study.file +
                   ": the study file has other axes, labels or measures than its results; run and "
                   "merge the study again");
}

const PairComparison* pairOf(const StudyComparison& c, const Claim& claim) {
  const std::size_t axis = axisOf(claim), a = *claim.a[axis], b = *claim.b[axis];
  auto at = claim.a;
  at[axis].reset();
  for (std::size_t x = 0; x < at.size(); ++x)  // an axis with one level needs no fixing
    if (c.results.axes[x].labels.size() < 2) at[x].reset();
  for (const PairComparison& pair : c.pairs)
    if (c.measureName(pair.measure) == claim.measure && pair.axis == axis && pair.at == at &&
        pair.a == std::min(a, b) && pair.b == std::max(a, b))
      return &pair;
  return nullptr;
}

bool holds(const Claim& claim, const PairComparison& pair) {
  const std::size_t axis = axisOf(claim);
  const double difference = (*claim.a[axis] < *claim.b[axis] ? 1 : -1) * pair.paired.difference;
  switch (claim.says) {
    case Says::lower: return isDifferent(pair) && difference < 0;
    case Says::higher: return isDifferent(pair) && difference > 0;
    case Says::equivalent: return pair.equivalence && pair.equivalence->verdict == Equivalent::yes;
    default: return !isDifferent(pair) && pair.known != Known::oneSeed;
  }
}

void judgeMean(const StudyComparison& c, const Claim& claim, ClaimFinding& finding) {
  for (const ConditionSummary& s : c.conditions) {
    const auto& levels = c.results.conditions[s.condition].levels;
    bool fits = c.measureName(s.measure) == claim.measure && !s.values.empty();
    for (std::size_t x = 0; x < levels.size(); ++x) fits = fits && levels[x] == claim.a[x].value_or(0);
    if (!fits) continue;
    const auto margin = marginOf(parseMargins({claim.within}, {}), claim.measure, claim.mean);
    finding.holds = std::abs(s.mean - claim.mean) <= margin.value_or(0);
    finding.found = fmt::format(
        "{}: {} in the mean of {} runs{}", claim.measure, numberText(s.mean), s.values.size(),
        s.interval ? fmt::format(", 95 % interval {} to {}", numberText(s.interval->low), numberText(s.interval->high))
                   : "");
  }
}

}  // namespace

bool canHold(const StudyResults& results, const Study& study) {
  bool same = std::ranges::equal(results.axes, study.axes, [](const ResultAxis& found, const StudyAxis& said) {
    return found.name == said.name && std::ranges::equal(found.labels, said.levels, {}, {}, &Level::label);
  });
  for (const Claim& claim : study.claims)
    same = same && std::ranges::find(results.measures, claim.measure) != results.measures.end();
  return same;
}

std::vector<ClaimFinding> findClaims(const StudyResults& results, const Study& study) {
  requireSame(results, study);
  std::map<std::pair<std::string, bool>, StudyComparison> comparisons;  // by margin, and whether other axes are fixed
  const auto compared = [&](const std::string& margin, bool within) -> const StudyComparison& {
    const auto [found, isNew] = comparisons.try_emplace({margin, within});
    if (isNew) {
      CompareOptions options;
      if (!margin.empty()) options.margins = {margin};
      options.refuseWide = false;  // a margin is refused at its place in the study file
      options.within = within;
      found->second = compareStudy(results, options);
    }
    return found->second;
  };
  std::vector<ClaimFinding> findings;
  scenario::Problems problems(study.file);
  for (const Claim& claim : study.claims) {
    ClaimFinding& finding = findings.emplace_back();
    finding.claim = claimInWords(claim, results), finding.place = claim.place;
    finding.found = claim.measure + ": no run has a value of this measure";
    if (claim.says == Says::mean) {
      judgeMean(compared("", false), claim, finding);
      continue;
    }
    bool fixes = false;
    for (std::size_t x = 0; x < claim.a.size(); ++x)
      fixes = fixes || (x != axisOf(claim) && claim.a[x] && study.axes[x].levels.size() > 1);
    const bool isMargin = claim.says == Says::equivalent;
    const StudyComparison& c = compared(isMargin ? claim.measure + '=' + claim.within : "", fixes);
    const PairComparison* pair = pairOf(c, claim);
    if (!pair) continue;
    if (pair->equivalence && pair->equivalence->verdict == Equivalent::untested)
      problems.add(claim.marginPlace, fmt::format("check[{}].within", findings.size() - 1),
                   tooWideText(c, pair->measure, pair->equivalence->test.margin), narrowerText(c, pair->measure));
    finding.holds = holds(claim, *pair);
    finding.found = pairInWords(c, *pair);
  }
  problems.throwIfAny();
  return findings;
}

Json claimsJson(const std::vector<ClaimFinding>& findings) {
  Json claims = Json::array();
  for (const ClaimFinding& f : findings)
    claims.push_back({{"claim", f.claim}, {"holds", f.holds}, {"found", f.found}, {"line", f.place.line}});
  return claims;
}

Study plannedStudy(const std::filesystem::path& database) {
  Study study;
  readStoredPlan(database, [&](const Json& plan) {
    const Json& stored = plan.at("study");
    study = readStudy(stored.at("text").get<std::string>(), stored.at("file").get<std::string>(), true);
  });
  return study;
}

}  // namespace morula
