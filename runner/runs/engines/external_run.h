#pragma once
// A scenario's run in another engine, in a process of its own: such a process may hang or die, and Bullet's results
// depend on earlier computations.
#include <functional>
#include <string>
#include <vector>

#include "base/choice.h"
#include "golden/check_result.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"
#include "store/records.h"
#include "system/json.h"

namespace morula {

/// Our engine with the thesis' contact law, and Bullet [values/baseline.h].
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

/// [s] CPU time far above that of the hard cases: an engine that needs more counts as silent.
inline constexpr int usualCpuSeconds = 120;

struct ExternalQuestion {
  Engine engine = Engine::b1;
  double margin = 0.01;                                // [radii of the egg] of surfaces in Bullet
  Integrator integrator = Integrator::velocityVerlet;  // for B1, as in BulletScene
  int cpuSeconds = usualCpuSeconds;                    // limit of the process
  std::vector<double> frameTimes = {};                 // [time] rising: when to report shapes, too
};

/// All cells after the first step that reaches a requested time.
struct ExternalFrame {
  double time = 0;  // [time]
  std::uint64_t step = 0;
  std::vector<std::vector<Point>> shapes;  // [length] by path
};

/// Max vertices of all cells in all frames of one question: an answer of some 30 MB.
inline constexpr std::size_t maxFrameVertices = 500'000;

struct ExternalRun {
  enum class End {
    done,
    broken,   // a cell was no cell any more: inside out, or at a place that is no number
    stopped,  // the engine reports that it cannot go on
    refused,  // the engine reports that it cannot begin
    silent,   // no answer: out of time, ended by a signal, or an incomplete answer
  };
  End end = End::silent;
  std::string why;  // "" if done or broken
  std::uint64_t step = 0;
  std::vector<CheckResult> results;        // results of the scenario's check; if broken, the broken conditions
  Bounds volumes;                          // [1] of all cells, over their volumes at rest
  std::vector<std::vector<Point>> shapes;  // [length] of all cells at the end, by path, if done
  std::vector<Sample> samples;             // as in the scenario's `record`, and at the end; without states and contacts
  std::vector<ExternalFrame> frames = {};  // at the requested times; none after maxFrameVertices
};

/// Returns the vertices of all cells [length], by path.
std::vector<std::vector<Point>> shapesOf(const World& world);

using OnStep = std::function<void(std::uint64_t)>;

/// Answers a question in JSON (engine_worker.h) in this process. Calls `onStep` with the number of each step.
ExternalRun runHere(const Json& question, const OnStep& onStep);

}  // namespace morula
