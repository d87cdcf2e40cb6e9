#pragma once
// A scenario's run as another engine computes it, in a process of its own: that may hang or die, and what
// Bullet computes depends on what it did before.
#include <functional>
#include <string>
#include <vector>

#include "base/choice.h"
#include "golden/check_result.h"
#include "scenario/scenario.h"
#include "simulation/world.h"
#include "store/records.h"
#include "system/json.h"

namespace morula {

/// Ours with the thesis' contact law, and Bullet [values/baseline.h].
enum class Engine { thesis, b1, b2, b3 };
template <>
inline constexpr auto choices<Engine> = std::to_array<Choice<Engine>>({{Engine::thesis, "thesis",
                                                                        "thesis' contact law"},
                                                                       {Engine::b1, "b1", "Bullet, B1"},
                                                                       {Engine::b2, "b2", "Bullet, B2"},
                                                                       {Engine::b3, "b3", "Bullet, B3"}});
Engine engineOf(Baseline baseline);
/// Returns the baseline of an engine that is Bullet.
Baseline baselineOf(Engine engine);

/// [s] Far more than any of the hard cases takes: an engine that has not answered by then is taken to have none.
inline constexpr int usualCpuSeconds = 120;

struct ExternalQuestion {
  Engine engine = Engine::b1;
  double margin = 0.01;                                // [radii of the egg] Bullet's
  Integrator integrator = Integrator::velocityVerlet;  // B1's, as in BulletScene
  int cpuSeconds = usualCpuSeconds;                    // of the process; then it is ended
  std::vector<double> frameTimes = {};                 // [time] rising: when shapes are told, too
};

/// All cells after the first step that reaches a time that was asked for.
struct ExternalFrame {
  double time = 0;  // [time]
  std::uint64_t step = 0;
  std::vector<std::vector<Point>> shapes;  // [length] by path
};

/// Vertices of all cells in all frames that one question may ask for: an answer of some 30 MB.
inline constexpr std::size_t maxFrameVertices = 500'000;

struct ExternalRun {
  enum class End {
    done,
    broken,   // a cell was no cell any more: inside out, or at a place that is no number
    stopped,  // the engine says itself that it cannot go on
    refused,  // nor begin
    silent,   // no answer: out of time, ended by a signal, an answer that was cut
  };
  End end = End::silent;
  std::string why;  // unless done or broken
  std::uint64_t step = 0;
  std::vector<CheckResult> results;        // of what the scenario's check demands; or what is broken
  Bounds volumes;                          // [1] of all cells, over those at rest
  std::vector<std::vector<Point>> shapes;  // [length] of all cells at the end, by path, if done
  std::vector<Sample> samples;             // as the scenario records, and the end; without states and contacts
  std::vector<ExternalFrame> frames = {};  // as they were asked for; none after maxFrameVertices
};

/// [length] The vertices of all cells, by path.
std::vector<std::vector<Point>> shapesOf(const World& world);

using OnStep = std::function<void(std::uint64_t)>;

/// In this process: what was asked in JSON (engine_worker.h). `onStep` is called with the number of each step.
ExternalRun runHere(const Json& question, const OnStep& onStep);

}  // namespace morula
