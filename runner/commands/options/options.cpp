#include "options/options.h"

#include "base/error.h"
#include "options/exit_codes.h"
#include "options/verb.h"
#include "system/usable_memory.h"
#include "yaml/numbers.h"

namespace morula::cli {

void add(Verb& verb, OutputOptions& options) {
  verb.takes("--json", options.json, "One JSON object on standard output");
  verb.takes("--quiet", options.quiet, "No remarks and no progress");
}

void add(Verb& verb, InputOptions& options) {
  verb.takes("--allow-outside", options.allowOutside,
             "Let the scenario name DNA and meshes outside of its folder; only for scenarios that you trust");
}

void add(Verb& verb, SceneOptions& options) {
  verb.takes(
      "--set", options.set, "PATH=VALUE",
      "Change a parameter: --set physics.time_step=0.001; null takes it away; may repeat");  // or --set a=1
                                                                                             // FILE would
                                                                                             // swallow FILE
  verb.takes("--seed", options.seed, "N", "Another seed than the scenario's");
}

void add(Verb& verb, ExecutionOptions& options) {
  verb.takes("--threads", options.threads, "N", "Compute with so many threads; changes no result");
  verb.takes("--isa", options.isa, "NAME", "Compute with scalar, narrow, avx2 or avx512; changes no result");
  verb.takes("--search", options.search, "NAME",
             "Find contacts by grid, aabb-tree, spatial-hash or brute-force; changes no result");
  addMemoryLimit(verb, options);
}

void addMemoryLimit(Verb& verb, ExecutionOptions& options) {
  verb.takes("--memory-limit", options.memoryLimit, "SIZE",
             "Refuse or end a run that would take more, as 8G; otherwise nine tenths of what is free");
}

std::vector<Override> overrides(const SceneOptions& options) {
  std::vector<Override> list;
  for (const auto& text : options.set) list.push_back(parseOverride(text));
  if (!options.seed.empty()) list.push_back({"seed", options.seed, "--seed"});
  return list;
}

Execution execution(const ExecutionOptions& options) {
  Execution how;
  how.threads = static_cast<int>(naturalOption("--threads", options.threads, 1, 1024));
  how.memoryLimit =
      options.memoryLimit.empty() ? usableMemory() : sizeOption("--memory-limit", options.memoryLimit);
  try {
    if (!options.isa.empty()) how.isa = parseIsa(options.isa);
  } catch (const InputError& error) { throw UsageError(std::string("--isa: ") + error.what()); }
  try {
    if (!options.search.empty()) how.search.method = parseContactSearch(options.search);
  } catch (const InputError& error) { throw UsageError(std::string("--search: ") + error.what()); }
  return how;
}

std::uint64_t naturalOption(const std::string& option, const std::string& text, std::uint64_t low,
                            std::uint64_t high) {
  const auto number = scenario::parseNatural(text);
  const auto needs = "; needs a whole number from " + std::to_string(low) + " to " + std::to_string(high);
  if (!number.wrong.empty()) throw UsageError(option + ": '" + text + "' " + number.wrong + needs);
  if (number.value < low || number.value > high)
    throw UsageError(option + ": " + text + " is out of range" + needs);
  return number.value;
}

namespace {

double realOption(const std::string& option, const std::string& text, bool mayBeZero) {
  const std::string needs = mayBeZero ? "; needs a number ≥ 0" : "; needs a number > 0";
  const auto number = scenario::parseReal(text);
  if (!number.wrong.empty()) throw UsageError(option + ": '" + text + "' " + number.wrong + needs);
  if (number.value < 0 || (number.value == 0 && !mayBeZero))
    throw UsageError(option + ": " + text + " is out of range" + needs);
  return number.value;
}

}  // namespace

double positiveOption(const std::string& option, const std::string& text) {
  return realOption(option, text, false);
}

double nonNegativeOption(const std::string& option, const std::string& text) {
  return realOption(option, text, true);
}

double sizeOption(const std::string& option, const std::string& text) {
  const std::string needs = "; needs a size > 0, as 500M or 8G (10⁶ or 10⁹ bytes)";
  const char last = text.empty() ? ' ' : text.back();
  const double unit = last == 'k' || last == 'K' ? 1e3
                      : last == 'M'              ? 1e6
                      : last == 'G'              ? 1e9
                      : last == 'T'              ? 1e12
                                                 : 1;
  const auto number = scenario::parseReal(unit == 1 ? text : text.substr(0, text.size() - 1));
  if (!number.wrong.empty()) throw UsageError(option + ": '" + text + "' " + number.wrong + needs);
  if (!(number.value > 0)) throw UsageError(option + ": " + text + " is out of range" + needs);
  return number.value * unit;
}

std::vector<std::uint64_t> seedRange(const std::string& text) {
  const auto dots = text.find("..");
  if (dots == text.npos)
    throw UsageError("--seeds: '" + text + "' is not a range; needs FIRST..LAST, as 1..50");
  const auto first = naturalOption("--seeds", text.substr(0, dots), 0, 9223372036854775807u);
  const auto last = naturalOption("--seeds", text.substr(dots + 2), 0, 9223372036854775807u);
  if (last < first) throw UsageError("--seeds: " + text + " runs backward; needs FIRST..LAST, as 1..50");
  if (last - first >= 100'000) throw UsageError("--seeds: " + text + " are too many; at most 100000 at once");
  std::vector<std::uint64_t> seeds;
  for (auto seed = first; seed <= last; ++seed) seeds.push_back(seed);
  return seeds;
}

}  // namespace morula::cli
