#pragma once
// Margins: by how much two means may differ and still count as equal.
#include <optional>
#include <string>
#include <vector>

namespace morula {

struct Margin {
  std::string measure;  // "": for all measures without a margin of their own
  double size = 0;      // above 0; [unit of the measure], or with ofMean a share of the mean
  bool ofMean = false;  // a share of the mean
};

/// Parses "0.01", "5%", "sphericity=0.01", "clone-radius=2%", as --equivalent takes them. Throws UsageError for
/// anything else, and for a measure that is not in `measures`.
std::vector<Margin> parseMargins(const std::vector<std::string>& words, const std::vector<std::string>& measures);

/// Returns the margin of this measure, in its unit, between conditions with this mean. A share is of the distance of
/// the mean from the measure's zero (measure_words.h). Absent if no margin was given, or if a share of 0 was.
std::optional<double> marginOf(const std::vector<Margin>& margins, const std::string& measure, double mean);

/// Returns the name in `names` that `word` means; '-' may stand for '_'. Otherwise throws UsageError, which names
/// `option` and calls a name a `kind` ("measure", "axis").
std::string nameAmong(const std::string& option, const std::string& kind, std::string word,
                      const std::vector<std::string>& names);

}  // namespace morula
