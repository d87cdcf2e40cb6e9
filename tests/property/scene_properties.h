#pragma once
// Runs of random scenes, and whether they are right.
#include <cstdint>
#include <optional>
#include <string>

#include "scenario/scenario.h"
#include "state/world.h"

namespace morula::chance {

/// How a run ended.
struct Course {
  std::optional<World> world;
  std::string group;  // the reason without numbers and names, if the run did not end well
  std::string text;   // the full reason
  bool refused = false, stopped = false, sane = false;
  std::string half;  // a checkpoint about halfway
  double gain = 0;   // [1] gain of energy
};

struct Verdict {
  std::string find;  // a few words that classify the fault of the program
  std::string more;
  Course course;
  bool tooLong = false;
};

/// Returns the first line of a message without numbers and names, by which messages are counted.
std::string groupOf(std::string text);

/// Runs a scene to its end, or until it has taken too much work. `diagnoses`: a failure is diagnosed for its advice.
Course run(const Scenario& scenario, bool diagnoses = false, std::optional<std::uint64_t> lastStep = {});

/// Runs the scene of a text, and looks at all properties that must hold for it.
Verdict judge(const std::string& text, std::uint64_t seed, bool diagnoses);

}  // namespace morula::chance
