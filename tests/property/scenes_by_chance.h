#pragma once
// Random scenes: small bases in which keys of the parameter table get values that the schema allows. New keys of the
// table are drawn without changes here.
#include <cstdint>
#include <functional>
#include <set>
#include <string>

#include "scenario/scenario.h"
#include "system/json.h"

namespace morula::chance {

/// splitmix64 [Steele, Lea, Flood 2014], so that a seed gives the same scene on every machine.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed) { state_ = bits(); }  // decorrelates seeds
  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  double between(double low, double high) { return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53; }
  bool chance(double p) { return between(0, 1) < p; }
  template <class List>
  const auto& one(const List& of) {
    return of[bits() % of.size()];
  }

 private:
  std::uint64_t state_;
};

struct Drawn {
  Json scenario;
  std::set<std::string> keys;  // paths of the drawn keys that the scenario kept
};
Drawn drawScene(std::uint64_t seed);

/// The name of the scenario's file in messages, and its text for `morula run`.
inline const std::string sceneFile = "random.yaml";
std::string sceneText(const Json& scenario);
/// Reads a scene. Throws InputError as readScenario does.
Scenario readScene(const std::string& text);

/// Sets a key by its path, or removes it for null; keys of its section that exclude it are removed.
void setKey(Json& scenario, const std::string& path, const Json& value);

/// Returns the smallest scenario found that still `fails`: with fewer keys, then with shorter lists and rounder
/// numbers.
Json shrink(Json scenario, const std::function<bool(const Json&)>& fails);

}  // namespace morula::chance
