#pragma once
// Small pieces of a page's HTML, and the words that it has for what results call by names.
#include <string>
#include <string_view>
#include <vector>

#include "files/quote.h"
#include "report_data/run_facts.h"

namespace morula {

/// Text of unknown origin as HTML: characters that a reader would not see are made visible.
std::string shown(std::string_view text);
/// The same in a table: a hash may be broken anywhere, words may not.
std::string shownValue(const std::string& text);
/// The same in a <pre>; a text longer than `mostBytes` is cut, which is said.
std::string shownBlock(std::string_view text, std::size_t mostBytes = 200'000);

/// One thing that the verdict says.
struct Finding {
  enum class Kind { good, note, warning, bad };
  Kind kind;
  std::string html;
};
std::string findingsHtml(const std::vector<Finding>& findings);

/// "1 cell", "2 cells".
std::string counted(std::uint64_t count, const std::string& what);

/// "a", "a and b", "a, b and c"; of more than `most` the first ones, and how many more.
std::string listed(const std::vector<std::string>& texts, std::size_t most = 6);

/// "31 bytes", "2.75 kB", "1.2 MB".
std::string inBytes(std::size_t bytes);

/// Why a run failed, HTML: what happened, and below it what was found out about it.
std::string failureHtml(const std::string& failure);

/// What a failed check means, in words: "the lineage differs". Classes that are not known stand as they are.
std::string failedInWords(const CheckResult& failed);

/// How the run is called on its page (nameRuns).
const std::string& titleOf(const RunFacts& run);

/// Gives each run its title: "unique-four, seed 5"; runs of the same scenario and seed also say what their scenarios
/// differ in, "physics.pressure.constant 180" (that alone where all runs of the page are such), and where that is no
/// answer their id.
void nameRuns(std::vector<RunFacts>& runs);

/// The scenario file that the run was read from, as it was given.
std::string sourceOf(const RunFacts& run);

/// "./morula render FILE --run ID …"
std::string commandFor(const RunFacts& run, const std::string& verb, const std::string& options = {});

}  // namespace morula
