// A scenario's run in another process, and all faults of such a process.
#include "engines/external_run.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "catch.h"
#include "engines/engine_worker.h"
#include "lab.h"
#include "observation/measures.h"
#include "simulation/simulation.h"
#include "temporary_folder.h"

using namespace morula;

namespace {

const std::string two =
    "morula: 1\nname: two\ndna: |\n  START: a0\n  g1(a0|a0)\ncycle: {length: 100}\nstop: {time: 0.25}\n"
    "cells: [{at: [-1.5, 0, 0], velocity: [2, 0, 0]}, {at: [1.5, 0, 0]}]\n"
    "physics: {time_step: 0.0078125, mesh: {icosphere: 1}, contact: {}}\n"
    "check: {volume: [0.5, 2], energy: 1}\n";

Scenario scenarioOf(const std::string& text) { return readScenario(text, "two.yaml", "."); }

/// Returns the worker's answer, without a process.
ExternalRun serve(const Scenario& scenario, Engine engine, const std::vector<double>& frameTimes = {}) {
  std::istringstream in(jsonText(toJson(scenario, ExternalQuestion{.engine = engine, .frameTimes = frameTimes})));
  std::ostringstream out;
  serveEngine(in, out);
  const std::string said = out.str();
  return externalRunFrom(parseJson(said.substr(said.rfind("{\"answer\""))).at("answer"));
}

/// Returns the answer of a faulty program, a shell script.
ExternalRun askScript(const std::string& body, int cpuSeconds = 0) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "worker";
  std::ofstream(file) << "#!/bin/sh\n" << body << '\n';
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return runExternally(scenarioOf(two), {.engine = Engine::b1, .cpuSeconds = cpuSeconds}, file);
}

}  // namespace

TEST_CASE("Ours by another process is ours: steps, results, samples and shapes") {
  const Scenario scenario = scenarioOf(two);
  const ExternalRun run = serve(scenario, Engine::thesis);  // whatever the scenario's law
  CHECK(run.end == ExternalRun::End::done);
  CHECK(run.step == 32);
  World ours = makeWorld(scenario.scene);
  while (!finished(ours)) step(ours);
  REQUIRE(run.shapes.size() == 2);
  CHECK(run.shapes[1] == cellVertices(ours, ours.cells.path[1]));  // to the last bit
  REQUIRE(run.samples.size() == 2);                                // at the start and at the end
  CHECK(run.samples[1].cells[0].at("volume") == measureCells(ours)[0].at("volume"));
  REQUIRE(run.results.size() == 2);
  CHECK(run.results[0].passed);
  CHECK(run.results[1].check == "energy");
  CHECK(!run.results[1].passed);  // the energy is 2 at the start
}

TEST_CASE("Shapes are told at the times that are asked for, and the last are those of the end") {
  const Scenario scenario = scenarioOf(two);
  const auto ask = [&](const std::vector<double>& times) { return serve(scenario, Engine::thesis, times).frames; };
  CHECK(ask({}).empty());
  // Steps take 1/128. A frame is the first step at or after each time; none comes twice, and none after the end.
  const auto frames = ask({0, 0.1, 0.1001, 0.25, 0.5});
  REQUIRE(frames.size() == 3);
  CHECK(frames[0].time == 0);
  CHECK(frames[1].step == 13);
  CHECK(frames[1].time == 13.0 / 128);
  CHECK(frames[2].step == 32);
  CHECK(frames[2].shapes == serve(scenario, Engine::thesis).shapes);
  CHECK(frames[0].shapes != frames[2].shapes);
  if (bulletIsAvailable()) {
    const ExternalRun run = serve(scenario, Engine::b1, {0.125, 0.25});
    REQUIRE(run.frames.size() == 2);
    CHECK(run.frames[1].shapes == run.shapes);
  }
}

TEST_CASE("Bullet moves the same cells, in the time step that is given, stable or not") {
  NEEDS_BULLET
  const ExternalRun run = serve(scenarioOf(two), Engine::b1);
  CHECK(run.end == ExternalRun::End::done);
  CHECK(run.step == 32);
  REQUIRE(run.shapes.size() == 2);
  double x = 0;
  for (const Point& p : run.shapes[0]) x += p.x / static_cast<double>(run.shapes[0].size());
  CHECK(x == Approx(-1).margin(1e-3));  // the cell flew freely
  const auto timeStep = two.find("0.0078125"), stop = two.find("0.25");
  const std::string unstable =
      two.substr(0, stop) + "9" + two.substr(stop + 4, timeStep - stop - 4) + "0.125" + two.substr(timeStep + 9);
  const ExternalRun broken = serve(scenarioOf(unstable), Engine::b2);
  CHECK(broken.end == ExternalRun::End::broken);
  CHECK(broken.step < 72);
  CHECK(serve(scenarioOf(unstable), Engine::thesis).end == ExternalRun::End::refused);
}

TEST_CASE("A worker that is killed, cut, confused or stuck is an answer of its own kind, and never a hang") {
  const auto why = [](const ExternalRun& run) {
    CHECK(run.end == ExternalRun::End::silent);
    return run.why;
  };
  const ExternalRun killed = askScript("echo '{\"step\": 7}'; echo '{\"ste'; kill -9 $$");
  CHECK(why(killed) == "the engine's process was ended by signal 9");
  CHECK(killed.step == 7);
  CHECK(why(askScript("exit 3")) == "the engine's process ended with code 3");
  CHECK(why(askScript("echo '{\"step\": 2}'")) == "the engine's answer is cut short");
  CHECK(why(askScript("echo '{\"answer\": {\"end\": 0, \"why\": \"'")) == "the engine's answer is cut short");
  CHECK(why(askScript("echo '{\"answer\": {\"end\": 0}}'")) == "the engine's answer is cut short");
  CHECK(why(askScript("cat > /dev/null; echo answer; echo '{\"answer\": 3}'")) == "the engine's answer is cut short");
  const std::string whole =
      "echo '{\"answer\": {\"end\": 0, \"why\": \"\", \"step\": 1, \"volumes\": {\"least\": 1, \"most\": 1}, "
      "\"results\": [], \"shapes\": [], \"samples\": [], \"frames\": []}}'; ";
  CHECK(askScript(whole).end == ExternalRun::End::done);
  CHECK(why(askScript(whole + "exit 3")) == "the engine's process ended with code 3");
  const ExternalRun stuck = askScript("echo '{\"step\": 4}'; while :; do :; done", 1);
  CHECK(why(stuck) == "the engine gave no answer within 1 s of CPU time");
  CHECK(stuck.step == 4);
  CHECK(why(runExternally(scenarioOf(two), {}, "/nowhere/morula")) == "the engine's process ended with code 127");
}
