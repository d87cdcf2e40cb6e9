// The rules of division and of chirality: which one holds for a cell.
#include "division/rules.h"

#include <algorithm>

#include "base/error.h"
#include "base/number_text.h"
#include "base/random.h"
#include "biology/substance_pattern.h"
#include "division/policy.h"
#include "division/tilt.h"

namespace morula {
namespace {

bool fitsCell(const DivisionRule& rule, const CellPath& cell, std::string_view substances) {
  return std::ranges::all_of(rule.of, [&](const std::string& pattern) { return fitsAny(pattern, substances); }) &&
         std::ranges::all_of(rule.cells, [&](const CellSelection& some) { return some.has(cell, substances); });
}

/// Cuts each cell by its rule, with its deviations.
class RuledDivision final : public DivisionPolicy {
 public:
  RuledDivision(const DivisionParameters& division, std::uint64_t seed, const VariationParameters& variation)
      : division_(division), seed_(seed), variation_(variation) {
    otherwise_ = makePlanePolicy(division.otherwise, seed);
    requireShare({});
    for (const DivisionRule& rule : division_.rules) {
      requireShare(rule.share);
      planes_.push_back(rule.plane ? makePlanePolicy(*rule.plane, seed) : nullptr);
    }
  }

  Cut findCut(const CellContext& cell) const override {
    const DivisionRule* rule = division_.rules.empty() ? nullptr : ruleFor(division_, cell.path, cell.substances());
    const DivisionPolicy* plane = rule ? planes_[rule - division_.rules.data()].get() : nullptr;
    Cut cut = (plane ? *plane : *otherwise_).findCut(cell);
    const double tilt = rule && rule->tilt ? *rule->tilt : variation_.tilt;
    if (tilt > 0) cut.normal = tiltAxis(cut.normal, tilt, {seed_, cell.path, 0, Purpose::tilt});
    if (rule && rule->share) cut.share = rule->share;
    if (variation_.share > 0)
      cut.share =
          cut.share.value_or(0.5) + variation_.share * randomDeviate({seed_, cell.path, 0, Purpose::shareVariation});
    return cut;
  }

 private:
  void requireShare(const std::optional<double>& given) const {
    const double share = given.value_or(0.5), most = largestDeviate * variation_.share;
    if (share - most >= minShare && share + most <= largestShare) return;
    throw InputError::at("division.rules", ": a share of " + numberText(share) +
                                               (most > 0 ? " ± " + numberText(most) : "") + " leaves " +
                                               numberText(minShare) + " to " + numberText(largestShare) +
                                               "; give one that is nearer to 0.5");
  }

  const DivisionParameters division_;
  const std::uint64_t seed_;
  const VariationParameters variation_;
  std::unique_ptr<DivisionPolicy> otherwise_;
  std::vector<std::unique_ptr<DivisionPolicy>> planes_;  // [rule] null: as otherwise
};

}  // namespace

const DivisionRule* ruleFor(const DivisionParameters& division, const CellPath& cell, std::string_view substances) {
  for (const DivisionRule& rule : division.rules)
    if (fitsCell(rule, cell, substances)) return &rule;
  return nullptr;
}

const PlaneChoice& planeFor(const DivisionParameters& division, const CellPath& cell, std::string_view substances) {
  const DivisionRule* rule = ruleFor(division, cell, substances);
  return rule && rule->plane ? *rule->plane : division.otherwise;
}

std::unique_ptr<DivisionPolicy> makeDivisionPolicy(const DivisionParameters& division, std::uint64_t seed,
                                                   const VariationParameters& variation) {
  if (division.rules.empty() && variation.share == 0 && variation.tilt == 0)
    return makePlanePolicy(division.otherwise, seed);
  return std::make_unique<RuledDivision>(division, seed, variation);
}

std::optional<Chirality> chiralityOf(const DivisionParameters& p, const CellPath& cell, const std::string& substances) {
  const DivisionRule* rule = ruleFor(p, cell, substances);
  return rule && rule->chirality ? rule->chirality : p.chirality;
}

double longestChirality(const DivisionParameters& p) {
  double longest = p.chirality ? p.chirality->time : 0;
  for (const DivisionRule& rule : p.rules)
    if (rule.chirality) longest = std::max(longest, rule.chirality->time);
  return longest;
}

}  // namespace morula
