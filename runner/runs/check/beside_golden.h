#pragma once
// Golden, now and how far apart they are, as pictures: of a run that differs from its golden.
#include <optional>
#include <string>
#include <vector>

#include "comparison/organism_pair.h"
#include "golden/golden.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"

namespace morula {

struct BesideGolden {
  /// The source of the first picture.
  enum class Source {
    again,    // the golden's scenario was run again and came to the golden's state: the shapes are exact
    centres,  // what the golden holds: spheres with the volumes of its cells, at their places
    none,     // there is nothing to draw of the golden: `images.other` is all
  };
  Source source = Source::none;
  ComparisonImages images;         // golden, now, and the distance
  std::vector<std::string> notes;  // sentences on what is compared, and what cannot be

  /// All of it as one picture.
  Drawing sheet() const;
};

/// `now`: the end of a run of the scenario, with bodies. A golden holds no surfaces, so its organism is made again
/// (golden_scenario.h), on the same conditions as `now`, which takes about as long as the run did. Where its scenario
/// is not known, or this build comes to other bits, the golden's own numbers are drawn.
BesideGolden drawBesideGolden(const Scenario& scenario, const World& now, const Golden& golden, const Execution& how,
                              bool quiet);

/// Draws the scenario beside its golden. Absent without bodies, or if there is no golden file that can be read.
std::optional<BesideGolden> drawBesideGoldenFile(const Scenario& scenario, const World& now, const Execution& how,
                                                 bool quiet);

}  // namespace morula
