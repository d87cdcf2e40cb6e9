#pragma once
// Scenes by chance: a few small bases, of which keys of the table that the loader reads with are set to values of what
// its schema allows. A key that joins the table is drawn without being told here.
#include <cstdint>
#include <functional>
#include <set>
#include <string>

#include "scenario/scenario.h"
#include "system/json.h"

namespace morula::chance {

/// splitmix64 [Steele, Lea, Flood 2014], so that a seed names the same scene wherever this runs.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed) { state_ = bits(); }  // or seeds would be one stream, shifted
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
  std::set<std::string> keys;  // their paths, of those that were drawn and make sense in it
};
Drawn drawScene(std::uint64_t seed);

/// As a file: the name by which messages call it, and a scenario that `morula run` takes.
inline const std::string sceneFile = "random.yaml";
std::string sceneText(const Json& scenario);
/// Throws InputError as readScenario does.
Scenario readScene(const std::string& text);

/// Sets a key by its path, or takes it away for null; what stands in the way in its section goes.
void setKey(Json& scenario, const std::string& path, const Json& value);

/// The smallest scenario found that still `fails`: without keys, then with shorter lists and rounder numbers.
Json shrink(Json scenario, const std::function<bool(const Json&)>& fails);

}  // namespace morula::chance
