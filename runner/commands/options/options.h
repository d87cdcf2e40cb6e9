#pragma once
// Options that several verbs share. Numbers are taken as text and read strictly: CLI11 makes 2^64 − 1 of -1.
#include <cstdint>
#include <string>
#include <vector>

#include "scenario/scenario.h"
#include "simulation/world.h"

namespace morula::cli {

class Verb;

struct OutputOptions {
  bool json = false, quiet = false;
};

/// What a scenario may reach.
struct InputOptions {
  bool allowOutside = false;
};

/// Changes of the scene.
struct SceneOptions {
  std::vector<std::string> set;
  std::string seed;
  bool empty() const { return set.empty() && seed.empty(); }
};

/// How to compute; changes no result.
struct ExecutionOptions {
  std::string threads = "1", isa = {}, search = {}, memoryLimit = {};
};

void add(Verb& verb, OutputOptions& options);
void add(Verb& verb, InputOptions& options);
void add(Verb& verb, SceneOptions& options);
void add(Verb& verb, ExecutionOptions& options);
/// `--memory-limit` alone: for verbs that make a world and do not run it.
void addMemoryLimit(Verb& verb, ExecutionOptions& options);

std::vector<Override> overrides(const SceneOptions& options);
/// Throws UsageError.
Execution execution(const ExecutionOptions& options);

/// A whole number in [low, high]. Throws UsageError that names the option.
std::uint64_t naturalOption(const std::string& option, const std::string& text, std::uint64_t low,
                            std::uint64_t high);
/// A number > 0. Throws UsageError.
double positiveOption(const std::string& option, const std::string& text);
/// A number ≥ 0. Throws UsageError.
double nonNegativeOption(const std::string& option, const std::string& text);
/// [byte] "500M", "8G", "1.5G", "200000000". Throws UsageError.
double sizeOption(const std::string& option, const std::string& text);
/// "1..50": the numbers from 1 to 50. Throws UsageError.
std::vector<std::uint64_t> seedRange(const std::string& text);

}  // namespace morula::cli
