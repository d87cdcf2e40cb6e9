// The times of comparison, the events of runs, and the distance of runs at rest and at worst.
#include "accuracy/comparison_times.h"

#include "accuracy/run_distance.h"
#include "catch.h"
#include "reader.h"
#include "scenes.h"
#include "unit/mesh/zoo.h"

using namespace morula;

namespace {

std::vector<SceneEvent> eventsOf(const std::string& text) {
  World world = makeWorld(reader(text)({}).scene);
  EventFinder finder(world);
  while (!finished(world)) {
    step(world);
    finder.look(world);
  }
  return finder.events();
}

const std::string twoCells =
    "morula: 1\nname: two\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 1}\n"
    "physics:\n  time_step: 0.0078125\n  mesh: {icosphere: 1}\n  cell: {radius: 1, mass: 1}\n"
    "  membrane: {stiffness: 10, damping: 0.02}\n  pressure: {constant: 8, outside: 0}\n  contact: {}\n";

/// Returns a run of one cube, at the origin at time 0 and off by `offs` along x at times 1, 2, …. Pressure and contact
/// area are off by as much.
Trial run(const std::vector<double>& offs) {
  Trial trial;
  for (std::size_t i = 0; i <= offs.size(); ++i) {
    const double off = i > 0 ? offs[i - 1] : 0;
    Shapes shapes{double(i), {comparedCell({}, zoo::moved(scenes::cube(), {off, 0, 0}))}};
    shapes.cells[0].pressure = 2 + off;
    ContactMeasures contact{{}, CellPath::parse("A"), CellPath::parse("B")};
    contact["area"] = 1 + off;
    shapes.contacts = {contact};
    trial.shapes.push_back(shapes);
  }
  return trial;
}

}  // namespace

TEST_CASE("Times are evenly spread, and some follow each event, on multiples of the step") {
  CHECK(evenTimes(1, 0.25, 64) == std::vector<double>{0.25, 0.5, 0.75, 1});
  CHECK(evenTimes(1, 0.125, 2) == std::vector<double>{0.5, 1});
  CHECK(evenTimes(0.1, 0.25, 16).empty());
  const double step = 0.125, own = 0.0625;
  // The scene's own steps are half as long as the multiples: 1 to 10 of them after 0.3125 are 0.375 to 0.9375.
  const std::vector<double> times = withEventTimes({1, 2, 3, 4}, step, std::vector<SceneEvent>{{0.3125, own}});
  CHECK(times == std::vector<double>{0.375, 0.5, 0.625, 0.75, 0.875, 1, 2, 3, 4});
  CHECK(withEventTimes({1}, step, std::vector<SceneEvent>{{0.875, own}}) == std::vector<double>{1});  // none is later
  CHECK(withEventTimes({}, step, std::vector<SceneEvent>{{0, own}}).empty());
}

TEST_CASE("Of many events each has three times, 1, 4 and 10 steps later") {
  std::vector<SceneEvent> events;
  for (int i = 0; i < 33; ++i) events.push_back({double(i), 1.0 / 64});
  const std::vector<double> times = withEventTimes({33}, 1.0 / 64, events);
  REQUIRE(times.size() == 3 * 33 + 1);
  CHECK(times[0] == 1.0 / 64);
  CHECK(times[1] == 4.0 / 64);
  CHECK(times[2] == 10.0 / 64);
  CHECK(times[3] == 1 + 1.0 / 64);
}

TEST_CASE("Of very many events some are taken, over the whole time") {
  std::vector<SceneEvent> events;
  for (int i = 0; i < 1000; ++i) events.push_back({double(i), 1.0 / 64});
  const std::vector<double> times = withEventTimes({1000}, 1.0 / 64, events);
  CHECK(times.size() == 3 * 33 + 1);
  CHECK(times.front() < 1);
  CHECK(times[times.size() - 2] > 900);
}

TEST_CASE("A time is quiet if no event is within 10 steps, before or after") {
  const std::vector<SceneEvent> events{{0, 0.5}, {20, 0.25}};
  CHECK_FALSE(isQuiet(events, 5));
  CHECK(isQuiet(events, 5.25));
  CHECK(isQuiet(events, 17.25));
  CHECK_FALSE(isQuiet(events, 17.5));
  CHECK_FALSE(isQuiet(events, 22.5));
  CHECK(isQuiet(events, 22.75));
  CHECK(isQuiet({}, 0));
}

TEST_CASE("Events are the start, births, deaths and first contacts, and each pair meets once") {
  const std::string apart = "cells:\n  - {at: [0, 0, 0]}\n  - {at: [5, 0, 0]}\n";
  CHECK(eventsOf(twoCells + apart).size() == 1);
  const auto met = eventsOf(twoCells + "cells:\n  - {at: [0, 0, 0]}\n  - {at: [2.3, 0, 0], velocity: [-2, 0, 0]}\n");
  REQUIRE(met.size() == 2);
  CHECK(met[0].time == 0);
  CHECK(met[1].time > 0.0078125);
  CHECK(met[1].timeStep == 0.0078125);
  std::string divides = twoCells;
  divides.replace(divides.find("g1(a0|a0)\n"), 10, "g1(a1|a0)\n  g2(divide|a0)\n  g3(a1|a1)\n");
  divides.replace(divides.find("stop"), 0, "cycle: {length: 0.25}\n");
  const auto born = eventsOf(divides + "  drag: 4\n");
  REQUIRE(born.size() >= 2);
  CHECK(born[1].time == 0.25);
  std::string dies = twoCells;
  dies.replace(dies.find("g1(a0|a0)\n"), 10, "g1(die|a0)\n");
  dies.replace(dies.find("stop"), 0, "cycle: {length: 0.25}\n");
  CHECK(eventsOf(dies).size() == 2);
}

TEST_CASE("Runs differ at rest by the median over the quiet times, and at worst by the largest of all") {
  const Trial own = run({0.5, 0.01, 0.02, 0.03, 0.02}), truth = run({0, 0, 0, 0, 0});
  const std::vector<SceneEvent> start{{0, 0.1}};  // time 1 is within 10 steps of it
  const RunDistance d = compareRuns(own, truth, 1, {.events = start});
  CHECK(d.worst.centroid == Approx(0.5));
  CHECK(d.worst.pressure == Approx(0.25));
  CHECK(d.worst.contactArea == Approx(0.5));
  REQUIRE(d.atRest);
  CHECK(d.atRest->centroid == Approx(0.02));
  CHECK(d.atRest->pressure == Approx(0.01));
  CHECK(d.atEnd.centroid == Approx(0.02));
  CHECK(d.until == 5);
  const std::vector<SceneEvent> always{{0, 0.1}, {3, 0.3}};
  CHECK_FALSE(compareRuns(own, truth, 1, {.events = always}).atRest);
  CHECK(compareRuns(own, truth, 1, {.before = 3}).until == 2);
  const std::vector<double> at{2, 4};
  CHECK(compareRuns(own, truth, 1, {.at = at}).worst.centroid == Approx(0.03));
}

TEST_CASE("Runs that stopped at other times are compared at those that both have") {
  Trial few = run({0.5, 0.01, 0.02, 0.03, 0.02});
  few.shapes.erase(few.shapes.begin() + 1);
  const RunDistance d = compareRuns(few, run({0, 0, 0, 0, 0, 0}), 1);
  CHECK(d.worst.centroid == Approx(0.03));
  CHECK(d.until == 5);
}

TEST_CASE("The share of other neighbours is that of all quiet pairs at rest, and at worst that of one time") {
  Trial own = run({0, 0, 0, 0}), truth = own;
  own.shapes[2].contacts.clear();
  const RunDistance d = compareRuns(own, truth, 1);
  CHECK(d.worst.neighbours == 1);
  CHECK(d.atRest->neighbours == 0.25);
}
