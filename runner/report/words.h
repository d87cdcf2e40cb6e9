#pragma once
// Small pieces of a page's HTML.
#include <string>
#include <string_view>
#include <vector>

#include "report/run_facts.h"

namespace morula {

/// Text of unknown origin as HTML: characters that a reader would not see are made visible.
std::string shown(std::string_view text);
/// The same in a <pre>; a text longer than `mostBytes` is cut, which is said.
std::string shownBlock(std::string_view text, std::size_t mostBytes = 200'000);

/// One thing that the verdict says.
struct Finding {
  enum class Kind { good, warning, bad };
  Kind kind;
  std::string html;
};
std::string findingsHtml(const std::vector<Finding>& findings);

/// "1 cell", "2 cells".
std::string counted(std::uint64_t count, const std::string& what);

/// "unique-four, seed 5", and the run's id where another run has the same: how a run is called on a page with `all` runs.
std::string titleOf(const RunFacts& run, const std::vector<RunFacts>& all);

/// As one word of a command line.
std::string shellWord(const std::string& word);

/// "morula render FILE --run ID …"
std::string commandFor(const RunFacts& run, const std::string& verb, const std::string& options = {});

}  // namespace morula
