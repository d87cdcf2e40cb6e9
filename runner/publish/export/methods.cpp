#include "export/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "analysis/claims.h"
#include "analysis/measure_words.h"
#include "document/words.h"
#include "files/text.h"
#include "loop/stored_scenario.h"
#include "scenario/deciding_values.h"
#include "store/store.h"

namespace morula {
namespace {

/// The sources that a text may cite, by key. The first is the program, as CITATION.cff describes it.
constexpr std::array<std::pair<const char*, const char*>, 18> sources{{
    {"morula",
     "@software{morula, title={Morula: a deterministic, scenario-driven simulator of dividing cells}, "
     "author={{The Morula authors}}, license={MIT}, version={VERSION}, note={commit COMMIT}}"},
    {"nilsson2008",
     "@mastersthesis{nilsson2008, title={Physical Simulation and Visualisation of Cells}, "
     "author={Nilsson, Johannes}, school={Link{\\\"o}ping University}, year={2008}, "
     "number={LiTH-ISY-EX--08/4071--SE}}"},
    {"holm1979",
     "@article{holm1979, title={A simple sequentially rejective multiple test procedure}, author={Holm, "
     "Sture}, journal={Scandinavian Journal of Statistics}, volume={6}, pages={65--70}, year={1979}}"},
    {"cohen1988",
     "@book{cohen1988, title={Statistical Power Analysis for the Behavioral Sciences}, edition={2}, "
     "author={Cohen, Jacob}, publisher={Lawrence Erlbaum}, year={1988}}"},
    {"hedges1981",
     "@article{hedges1981, title={Distribution theory for Glass's estimator of effect size and related "
     "estimators}, author={Hedges, Larry V.}, journal={Journal of Educational Statistics}, volume={6}, "
     "pages={107--128}, year={1981}}"},
    {"welch1947",
     "@article{welch1947, title={The generalization of `Student's' problem when several different "
     "population variances are involved}, author={Welch, B. L.}, journal={Biometrika}, volume={34}, "
     "pages={28--35}, year={1947}}"},
    {"johnson1978",
     "@article{johnson1978, title={Modified t tests and confidence intervals for asymmetrical "
     "populations}, author={Johnson, Norman J.}, journal={Journal of the American Statistical "
     "Association}, volume={73}, pages={536--544}, year={1978}}"},
    {"hall1988",
     "@article{hall1988, title={Theoretical comparison of bootstrap confidence intervals}, author={Hall, "
     "Peter}, journal={The Annals of Statistics}, volume={16}, pages={927--953}, year={1988}}"},
    {"clopper1934",
     "@article{clopper1934, title={The use of confidence or fiducial limits illustrated in the case of "
     "the binomial}, author={Clopper, C. J. and Pearson, E. S.}, journal={Biometrika}, volume={26}, "
     "pages={404--413}, year={1934}}"},
    {"zou2008",
     "@article{zou2008, title={Construction of confidence limits about effect measures: a general "
     "approach}, author={Zou, G. Y. and Donner, Allan}, journal={Statistics in Medicine}, volume={27}, "
     "pages={1693--1702}, year={2008}}"},
    {"fisher1935",
     "@book{fisher1935, title={The Design of Experiments}, author={Fisher, Ronald A.}, "
     "publisher={Oliver and Boyd}, year={1935}}"},
    {"montgomery2017",
     "@book{montgomery2017, title={Design and Analysis of Experiments}, edition={9}, "
     "author={Montgomery, Douglas C.}, publisher={Wiley}, year={2017}}"},
    {"box1954",
     "@article{box1954, title={Some theorems on quadratic forms applied in the study of analysis of "
     "variance problems, II}, author={Box, G. E. P.}, journal={The Annals of Mathematical Statistics}, "
     "volume={25}, pages={484--498}, year={1954}}"},
    {"huynh1976",
     "@article{huynh1976, title={Estimation of the Box correction for degrees of freedom from sample data "
     "in randomized block and split-plot designs}, author={Huynh, Huynh and Feldt, Leonard S.}, "
     "journal={Journal of Educational Statistics}, volume={1}, pages={69--82}, year={1976}}"},
    {"lecoutre1991",
     "@article{lecoutre1991, title={A correction for the e-approximate test in repeated measures "
     "designs with two or more independent groups}, author={Lecoutre, Bruno}, journal={Journal of "
     "Educational Statistics}, volume={16}, pages={371--372}, year={1991}}"},
    {"steiger2004",
     "@article{steiger2004, title={Beyond the F test: effect size confidence intervals and tests of "
     "close fit in the analysis of variance and contrast analysis}, author={Steiger, James H.}, "
     "journal={Psychological Methods}, volume={9}, pages={164--182}, year={2004}}"},
    {"schuirmann1987",
     "@article{schuirmann1987, title={A comparison of the two one-sided tests procedure and the "
     "power approach for assessing the equivalence of average bioavailability}, author={Schuirmann, "
     "Donald J.}, journal={Journal of Pharmacokinetics and Biopharmaceutics}, volume={15}, "
     "pages={657--680}, year={1987}}"},
    {"joanes1998",
     "@article{joanes1998, title={Comparing measures of sample skewness and kurtosis}, author={Joanes, "
     "D. N. and Gill, C. A.}, journal={Journal of the Royal Statistical Society: Series D}, volume={47}, "
     "pages={183--189}, year={1998}}"},
}};

/// Returns the values that tell the model, as "physics.integrator: quasi-static", without those that some level changes.
std::string modelOf(const Scenario& scenario, const std::set<std::string>& changed) {
  std::vector<std::string> values;
  for (const auto& [key, value] : decidingValues(scenario)) {
    const bool isModel = std::ranges::any_of(
        std::array{"physics.cell.model", "physics.mesh", "physics.integrator", "physics.time_step", "physics.precision",
                   "physics.contact.law", "division.plane"},
        [&key = key](const std::string& begin) { return key == begin || key.starts_with(begin + '.'); });
    const bool varies = std::ranges::any_of(changed, [&key = key](const std::string& level) {
      return key == level || key.starts_with(level + '.') || level.starts_with(key + '.');
    });
    if (isModel && !varies) values.push_back(key + ": " + value);
  }
  return values.empty() ? "no bodies, divisions of the lineage alone" : join(values);
}

bool anyShape(const StudyComparison& c, SampleShape shape) {
  return std::ranges::any_of(c.conditions, [&](const auto& s) { return s.shape == shape; }) ||
         std::ranges::any_of(c.pairs, [&](const auto& p) { return p.paired.sample.shape == shape; });
}

/// Returns the sentences on intervals, tests and corrections, as far as the comparison has used them.
std::string statisticsOf(const StudyComparison& c, bool equivalence) {
  std::string text =
      "Levels were compared seed by seed, with the same random numbers on both sides. Intervals of means and of "
      "differences are 95 % intervals of Student's t";
  if (anyShape(c, SampleShape::skewed))
    text +=
        "; of samples that are shown to be skewed [@joanes1998] they reach farther on the side of the long tail "
        "[@johnson1978; @hall1988]";
  if (anyShape(c, SampleShape::twoGroups))
    text += "; of samples of two groups they are exact for the share of runs in each [@clopper1934; @zou2008]";
  text +=
      ". The p-values of all pairs of all measures were corrected together [@holm1979], and a difference is reported "
      "as shown below 0.05. Differences that repeat have at least the p-value of the exact test of their signs "
      "[@fisher1935]. Effect sizes are Cohen's d [@cohen1988] and Hedges' g [@hedges1981]; widths of unpaired "
      "intervals are Welch's [@welch1947].";
  if (std::ranges::any_of(c.effects, [](const MeasureEffects& e) { return e.untested.empty(); }))
    text +=
        " Main effects and interactions come from an analysis of variance with seeds as blocks [@fisher1935; "
        "@montgomery2017], its degrees of freedom corrected [@box1954; @huynh1976; @lecoutre1991]; partial η² has "
        "95 % intervals [@steiger2004]. These tests are a Holm family of their own. Where an interaction is shown, "
        "levels were compared at each level of the other axis, in a third family.";
  if (equivalence) text += " Equivalence was tested by two one-sided tests at 5 % [@schuirmann1987].";
  return text;
}

}  // namespace

Methods methodsOf(const StudyComparison& c, const std::filesystem::path& database) {
  const StudyResults& r = c.results;
  std::set<std::string> changed;
  std::vector<std::string> axes, models, seeds, measures;
  std::string when;
  readStoredPlan(database, [&](const Json& plan) {
    for (const Json& axis : plan.at("study").at("axes"))
      for (const Json& level : axis.at("levels"))
        for (const Json& change : level.at("changes")) changed.insert(change.at("key").get<std::string>());
    when = plan.at("study").at("when").get<std::string>();
  });
  for (const ResultAxis& axis : r.axes) axes.push_back(fmt::format("{} ({})", axis.name, join(axis.labels)));
  auto store = Store::openForReading(database);
  BuildInfo build;
  std::set<std::string> scenarios;
  for (const ResultTask& task : r.tasks) {
    if (task.status != TaskStatus::done) continue;
    const StoredRun run = store.find(task.runId);
    build = run.record.build;
    if (scenarios.insert(run.record.scenario).second)
      models.push_back(
          fmt::format("`{}` ({})", run.record.scenario, modelOf(storedScenario(database, task.runId), changed)));
  }
  for (const std::uint64_t seed : r.seeds) seeds.push_back(std::to_string(seed));
  for (const std::string& name : r.measures) {
    const std::string unit = unitOfMeasure(name);
    measures.push_back(fmt::format("{} (`{}`{})", wordsOfMeasure(name).noun, name, unit.empty() ? "" : ", " + unit));
  }
  const auto listedSeeds = seeds.size() > 3 && r.seeds.back() - r.seeds.front() == seeds.size() - 1
                               ? seeds.front() + " to " + seeds.back()
                               : join(seeds);
  const bool equivalence =
      std::ranges::any_of(plannedStudy(database).claims, [](const Claim& k) { return k.says == Says::equivalent; });
  Methods methods;
  methods.text = fmt::format(
      "# Methods\n\nSimulations were computed by Morula {} [@morula] (commit {}, {}; sources {}; {}), a deterministic "
      "simulator of dividing cells after Nilsson [@nilsson2008]: the same scenario, seed and build give the same bits. "
      "The study `{}` {} in {}, with {} each ({}), {} in all: {}. Values that decide the model: {}. Measured at the "
      "end of each run{}: {}. {}\n",
      build.version, build.gitCommit, build.gitState, build.sources, build.compiler, r.name,
      axes.empty() ? "repeats one scenario" : "varies " + join(axes), counted(r.conditions.size(), "condition"),
      counted(r.seeds.size(), "seed"), listedSeeds, counted(r.tasks.size(), "distinct run"), r.counts().text(),
      join(models, "; "), when == "end" ? "" : " and on the way", join(measures), statisticsOf(c, equivalence));
  for (const auto& [key, entry] : sources) {
    if (methods.text.find(std::string("@") + key) == std::string::npos) continue;
    std::string text = entry;
    for (const auto& [word, value] : {std::pair("VERSION", build.version), std::pair("COMMIT", build.gitCommit)})
      if (const auto at = text.find(word); at != text.npos) text.replace(at, std::string_view(word).size(), value);
    methods.references += text + '\n';
  }
  return methods;
}

}  // namespace morula
