// Bench reports: ratios, text and picture of rows, and one bench from end to end.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "bench/bench.h"
#include "bench/packed_world.h"
#include "bench/subject.h"
#include "bench/work.h"
#include "catch.h"
#include "contacts/contact_search.h"
#include "drawing/palette.h"
#include "temporary_folder.h"

using namespace morula;

namespace {

BenchRow row(MeasuredEngine engine, Stage stage, int cells, double ns, const std::string& isa = "avx2") {
  BenchRow r;
  r.scene = "packed", r.engine = engine, r.stage = stage, r.cells = cells, r.vertices = 162;
  r.isa = isa, r.nsPerVertexStep = ns;
  return r;
}

const BenchRatio* find(const std::vector<BenchRatio>& ratios, const std::string& what) {
  for (const BenchRatio& r : ratios)
    if (r.what.find(what) != r.what.npos) return &r;
  return nullptr;
}

int countPixels(const Drawing& drawing, Colour colour) {
  const Image image = drawing.pixels();
  return static_cast<int>(std::count(image.pixels.begin(), image.pixels.end(), colour));
}

}  // namespace

TEST_CASE("Ratios are formed of the rows that are there, and held against their promises") {
  std::vector<BenchRow> rows{
      row(MeasuredEngine::morula, Stage::step, 64, 40),    row(MeasuredEngine::morula, Stage::step, 128, 44),
      row(MeasuredEngine::morula, Stage::step, 256, 66),   row(MeasuredEngine::bulletB1, Stage::step, 64, 2000, ""),
      row(MeasuredEngine::morula, Stage::internal, 64, 8), row(MeasuredEngine::scalar, Stage::internal, 64, 45, "")};
  rows[4].shareOfPeak = 0.75, rows[4].shareWithRoots = 0.9;
  rows.push_back(row(MeasuredEngine::morula, Stage::step, 512, 60));
  rows.back().wallClock = true;
  rows.push_back(rows.back());
  rows.back().threads = 2, rows.back().nsPerVertexStep = 50;
  BenchRow free = row(MeasuredEngine::morula, Stage::step, 64, 9);
  free.scene = "free";
  rows.push_back(free);
  free.stage = Stage::internal, free.nsPerVertexStep = 8;
  rows.push_back(free);
  for (const auto& [engine, nanoseconds] : {std::pair{MeasuredEngine::morula, 30.0}, {MeasuredEngine::bulletB1, 600.0}}) {
    rows.push_back(row(engine, Stage::step, 64, nanoseconds, engine == MeasuredEngine::morula ? "avx2" : ""));
    rows.back().scene = "packed-single", rows.back().precision = Precision::binary32;
  }

  const auto ratios = findRatios(rows);
  const std::string threads = "two threads over one, 512 cells";
  for (const auto& [what, value, holds, isJudged] :
       {std::tuple<std::string, double, bool, bool>{"Morula's, both in double precision, 64 cells", 50, true, true},
        {"Morula's, both in single precision, 64 cells", 20, false, true},
        {"256 over 128 cells", 1.5, false, true},
        {"multiply–add peak", 0.75, true, true},
        {"root and quotient", 0.9, true, false},
        {"step of 64 cells over", 40.0 / 45, true, true},
        {"without contact", 9.0 / 8, false, true},
        {threads, 1.2, false, true}}) {
    CAPTURE(what);
    REQUIRE(find(ratios, what));
    CHECK(find(ratios, what)->value == value);
    CHECK(find(ratios, what)->holds() == holds);
    CHECK(find(ratios, what)->notJudged.empty() == isJudged);
  }
  CHECK_FALSE(find(ratios, "Morula's, both in double precision, 128 cells"));
  CHECK_FALSE(find(ratios, "2048 over 64"));
  for (BenchRow& r : rows) r.processors = 1.1;
  CHECK_THAT(find(findRatios(rows), threads)->notJudged, ContainsSubstring("only 1.1 processors"));
}

TEST_CASE("Work is counted per vertex: an icosahedron by hand") {
  // The icosahedron has 12 vertices, 30 edges, and rings of five that are walked as six.
  const MeshTemplate mesh = makeTemplate(makeIcosphere(0));
  PhysicsParameters p;
  p.membrane.damping = 0, p.drag = 0;
  const Work still = internalWork(mesh, p);
  // Operations: edges 2.5 · 12, ring 18 + 33 + 42 + 9, pressure 6.
  CHECK(still.operations == Approx(30 + 102 + 6));
  CHECK(still.roots == 2.5);
  p.membrane.damping = 1, p.drag = 1;
  CHECK(internalWork(mesh, p).operations == Approx(still.operations + 2.5 * 11 + 6));
  // Contact, with rings walked as six: 95 of the snapshot, 30 of f and t, 141 to the vertices; 81 or 108 per slot.
  CHECK(contactWork(mesh, 0, false).operations == 266);
  CHECK(contactWork(mesh, 2, false).operations == 266 + 2 * 81);
  CHECK(contactWork(mesh, 2, true).operations == 266 + 2 * 108);
  CHECK(contactWork(mesh, 2, true).roots == 3.5);
}

TEST_CASE("The limit is that of the scarcest part of the machine") {
  MachineLimits limits;
  limits.arithmetic[Isa::scalar] = {10, 2, 100};
  limits.bandwidth = {{100, 50}, {1000, 5}};
  for (const auto& [work, vertices, bound, seconds] :
       {std::tuple{Work{20, 0, 0, 0}, 1, Bound::ports, 2},
        {Work{20, 6, 0, 0}, 1, Bound::divider, 3},
        {Work{20, 6, 50, 10, 0}, 1, Bound::divider, 3},
        {Work{20, 6, 50, 10, 0}, 20, Bound::memory, 10},
        {Work{20, 6, 50, 10, 1200}, 20, Bound::frontEnd, 12}}) {
    const WorkLimit limit = findLimit(work, limits, Isa::scalar, vertices);
    CHECK(limit.bound() == bound);
    CHECK(limit.of(bound) == seconds);
  }
}

TEST_CASE("Instructions of stages are those that tests/cost counts, with the slots of its cells") {
  std::map<std::pair<std::string, std::string>, double> counted;  // by kernel and instruction set
  std::istringstream lines(readText(MORULA_SOURCE_DIR "/tests/cost/expected_instructions.txt"));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kernel, isa;
    double number;
    if (words >> kernel >> isa >> number) counted[{kernel, isa}] = number;
  }
  const World world = makePackedWorld({.cells = 16, .level = 1, .viscosity = 0.3});
  const double slots = double(countSlots(*world.contacts)) / world.bodies->livingVertices;
  for (const Isa isa : {Isa::narrow, Isa::avx2}) {
    const Instructions& i = instructionsOf(isa);
    for (const auto& [kernel, stated] : {std::pair{"internal", i.internal},
                                         {"integrate", i.integration},
                                         {"contact-dry", i.contact + i.perSlot * slots},
                                         {"contact", i.contact + i.perSlidingSlot * slots},
                                         {"sixteen-steps-alone", 16 * i.alone},
                                         {"choice", i.choice},
                                         {"search", i.search + i.choice},
                                         {"step", i.internal + i.integration + i.contact + i.perSlidingSlot * slots}}) {
      CAPTURE(kernel, name(isa));
      CHECK(stated == Approx(counted[{kernel, name(isa)}]).epsilon(0.05));
    }
  }
}

TEST_CASE("A bench of eight cells holds a row for everything that was asked for, and only that") {
  BenchOptions options;
  options.cells = {8};
  options.levels = {1};
  options.isas = availableIsas();
  options.stages = {Stage::step, Stage::internal, Stage::contact, Stage::rebuild, Stage::choice, Stage::integrate};
  options.rounds = 1, options.stepsFactor = 0.1, options.bullet = false;
  const BenchReport report = runBench(options);
  for (const Isa isa : availableIsas())
    for (const Stage stage : options.stages) {
      const BenchRow* r = find(report.rows, "packed", MeasuredEngine::morula, stage, 8, 42, name(isa));
      CAPTURE(name(isa), nameOf(stage));
      REQUIRE(r);
      CHECK(r->nsPerVertexStep >= 0);
      CHECK(r->shareOfLimit.has_value() == (stage != Stage::rebuild && stage != Stage::choice));
      CHECK(r->limit.has_value() == r->shareOfLimit.has_value());
      CHECK(r->nsPerVertexOnce.has_value() == !r->limit.has_value());
      CHECK(r->pairsPerVertexStep.has_value() == (stage != Stage::internal && stage != Stage::integrate));
      if (r->shareOfLimit) CHECK(*r->shareOfLimit > 0);
      if (r->shareOfPeak) CHECK(*r->shareWithRoots >= *r->shareOfPeak);
    }
  CHECK(find(report.rows, "packed", MeasuredEngine::scalar, Stage::internal, 8, 42, ""));
  CHECK(find(report.rows, "free", MeasuredEngine::morula, Stage::step, 8, 42, name(bestIsa())));
  CHECK(find(report.rows, "packed-still", MeasuredEngine::morula, Stage::step, 8, 42, name(availableIsas().front())));
  CHECK(find(report.rows, "packed-viscosity", MeasuredEngine::morula, Stage::step, 8, 42, name(bestIsa())));
  CHECK_FALSE(find(report.rows, "packed", MeasuredEngine::bulletB1, Stage::step, 8, 42, ""));
  std::set<std::string> searches;
  for (const BenchRow& r : report.rows) searches.insert(r.search);
  CHECK(searches.size() == 1 + valuesOf<ContactSearch>().size());
  const std::string text = textOf(describe(report));
  CHECK_THAT(text, ContainsSubstring("packed scene, 8 cells of 42 vertices") &&
                       ContainsSubstring("rebuild, aabb-tree") &&
                       ContainsSubstring(" ns/choice") && ContainsSubstring(" of them chosen; ") && ContainsSubstring("23.68"));

  options.stages = {Stage::internal};
  for (const BenchRow& r : runBench(options).rows) CHECK(r.stage == Stage::internal);
}

TEST_CASE("The picture of a bench holds the thesis' line only beside our own 8 cells") {
  BenchReport report;
  report.rows = {row(MeasuredEngine::morula, Stage::step, 64, 40), row(MeasuredEngine::morula, Stage::step, 128, 44)};
  const Colour green = seriesColour(2);
  CHECK(countPixels(drawBench(report), green) == 0);
  report.rows.push_back(row(MeasuredEngine::morula, Stage::step, 8, 30));
  CHECK(countPixels(drawBench(report), green) > 100);
}
