#pragma once
// Margins: by how much two means may differ and still count as the same.
#include <optional>
#include <string>
#include <vector>

namespace morula {

struct Margin {
  std::string measure;  // "": of all that have none of their own
  double size = 0;      // above 0; [unit of the measure], or with ofMean a share of the mean
  bool ofMean = false;
};

/// "0.01", "5%", "sphericity=0.01", "clone-radius=2%", as --equivalent takes them. Throws UsageError for anything else,
/// and for a measure that is not among `measures`.
std::vector<Margin> parseMargins(const std::vector<std::string>& words, const std::vector<std::string>& measures);

/// The margin of this measure, in its unit, between conditions with this mean. None if none was given, or it is a share
/// of 0.
std::optional<double> marginOf(const std::vector<Margin>& margins, const std::string& measure, double mean);

/// The one of `names` that is meant, where '-' may stand for '_'. Throws UsageError that names `option` and calls one
/// of them a `kind` ("measure", "axis").
std::string nameAmong(const std::string& option, const std::string& kind, std::string word,
                      const std::vector<std::string>& names);

}  // namespace morula
