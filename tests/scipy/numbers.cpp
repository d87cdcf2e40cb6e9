// Prints samples, and all results of runner/studies/statistics for them, as one JSON object for compare.py.
#include <cstdio>

#include "base/random.h"
#include "statistics/distributions.h"
#include "statistics/equivalence.h"
#include "statistics/factorial.h"
#include "statistics/means.h"
#include "system/json.h"

using namespace morula;

namespace {

std::vector<double> sample(std::uint64_t key, std::uint32_t n, double centre, double spread, bool skewed) {
  std::vector<double> values;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double z = randomNormal({key, {}}, i);
    values.push_back(centre + spread * (skewed ? z * z : z));
  }
  return values;
}

Json asJson(const std::optional<Interval>& i) { return i ? Json{i->low, i->high} : Json(); }

Json asJson(const MeanDifference& d) {
  return {{"t", d.t}, {"df", d.degreesOfFreedom}, {"p", d.p}, {"interval", asJson(d.interval)}};
}

Json asJson(const Equivalence& e) {
  return {{"margin", e.margin}, {"above", e.pAbove}, {"below", e.pBelow}, {"interval", asJson(e.interval)}};
}

Json twoSamples(const std::vector<double>& a, const std::vector<double>& b) {
  const auto paired = comparePaired(a, b), unpaired = compareUnpaired(a, b);
  const auto sizes = effectSizes(a, b);
  const double margin = 0.3;
  return {{"a", a},
          {"b", b},
          {"paired", asJson(paired)},
          {"unpaired", asJson(unpaired)},
          {"dz", *sizes.dz},
          {"d", *sizes.d},
          {"g", *sizes.g},
          {"tost_paired", asJson(testEquivalence(paired, margin))},
          {"tost_unpaired", asJson(testEquivalence(unpaired, margin))},
          {"mean", asJson(intervalOfMean(a))},
          {"mean90", asJson(intervalOfMean(b, 0.9))}};
}

Json factorial(const std::vector<std::size_t>& levels, std::size_t n) {
  std::size_t count = n;
  for (const std::size_t l : levels) count *= l;
  std::vector<double> values = sample(77 + n, static_cast<std::uint32_t>(count), 3, 1, false);
  for (std::size_t i = 0; i < count; ++i) values[i] += 0.5 * static_cast<double>(i / n % levels.back());
  const auto analysis = analyseFactorial(levels, values);
  Json effects = Json::array();
  for (const FactorEffect& e : analysis.effects)
    effects.push_back({{"factors", e.factors},
                       {"squares", e.squares},
                       {"df", e.degreesOfFreedom},
                       {"share", e.share},
                       {"partial", *e.partial},
                       {"error_df", e.errorDegreesOfFreedom},
                       {"epsilon", e.epsilon},
                       {"f", *e.f},
                       {"p", *e.p}});
  return {{"levels", levels}, {"values", values}, {"effects", effects}};
}

Json distributionValues() {
  Json list = Json::array();
  for (const double df : {1.0, 2.5, 9.0, 19.0, 37.73, 199.0, 1999.0, 20000.0})
    for (const double t : {-4.0, -0.1, 1e-5, 0.7, 2.1, 5.5, 17.0, 60.0})
      list.push_back({{"df", df}, {"t", t}, {"above", studentAbove(t, df)}, {"f", fisherAbove(t * t, 3, df)}});
  return list;
}

}  // namespace

int main() {
  Json samples = Json::array();
  for (const std::uint32_t n : {2, 3, 5, 10, 20, 50})
    for (const bool skewed : {false, true})
      samples.push_back(twoSamples(sample(n, n, 2, 0.2, skewed), sample(90 + n, n, 2.2, 0.35, false)));
  samples.push_back(twoSamples({1, 2, 2, 3, 1, 1, 0, 5}, {0, 0, 1, 0, 2, 1, 1, 0}));  // many ties
  const std::vector<double> skewed{0.1, 0.3, 0.35, 0.6, 0.8, 1.1, 2.9, 0.2}, few{0.4, 0.1, 0.2, 0.3, 3};
  samples.push_back(twoSamples(skewed, sample(3, 8, 0, 0.01, false)));
  samples.push_back(twoSamples(sample(3, 8, 0, 0.01, false), skewed));
  samples.push_back(twoSamples(few, sample(4, 5, 1, 0.01, false)));
  samples.push_back(twoSamples({1, 2.01, 0.99, 1.02, 2, 1.01}, sample(5, 6, 0.99, 0.01, false)));   // groups, one at 0
  samples.push_back(twoSamples({1, 2.01, 0.99, 1.02, 2, 1.01}, sample(6, 6, -0.3, 0.001, false)));  // groups
  samples.push_back(twoSamples({0, 1, 0, 0, 1, 0, 1, 0, 1, 0}, {0, 0, 0, 0, 1, 0, 0, 0, 0, 0}));    // an outcome or not
  Json quantiles = Json::array();
  for (const double share : {0.001, 0.025, 0.05, 0.4, 0.95, 0.975})
    quantiles.push_back({share, studentQuantile(share, 9)});
  std::vector<double> p;
  for (std::uint32_t i = 0; i < 30; ++i) p.push_back(0.1 * randomUnit({5, {}}, i) * randomUnit({6, {}}, i));
  const Json all{
      {"samples", samples},
      {"distributions", distributionValues()},
      {"quantiles", quantiles},
      {"holm", {{"p", p}, {"corrected", correctHolm(p)}}},
      {"factorial", {factorial({3, 5}, 10), factorial({2, 3, 4}, 4), factorial({4}, 7), factorial({2, 2}, 3)}}};
  std::puts(jsonText(all).c_str());
}
