// Mutations of a run: each fault must be found, in the right check, with the right class, step, cell and field.
#include <cmath>
#include <functional>
#include <limits>

#include "catch.h"
#include "example_facts.h"

using namespace morula;

namespace {

const CheckResult& find(const CheckReport& report, const std::string& check) {
  for (const CheckResult& r : report.results)
    if (r.check == check) return r;
  FAIL("no check " << check);
  return report.results.front();
}

std::vector<std::string> failedChecks(const CheckReport& report) {
  std::vector<std::string> names;
  for (const CheckResult& r : report.results)
    if (!r.passed) names.push_back(r.check);
  return names;
}

using Checks = std::vector<std::string>;

/// Returns the check, its class, the place and the field of a failure, as "lineage LINEAGE step 768 cell B: state".
std::string failedInOneLine(const CheckResult& r) {
  return r.check + ' ' + nameOf(r.failureClass) + (r.firstStep ? " step " + std::to_string(*r.firstStep) : "") +
         (r.cell ? ' ' + cellName(*r.cell) : "") + ": " + r.field;
}

CheckReport compareWith(const Golden& golden, const std::function<void(GoldenFacts&)>& fault) {
  GoldenFacts facts = exampleFacts();
  fault(facts);
  return compareGolden(golden, makeGoldenData(facts));
}

double nextUp(double x) { return std::nextafter(x, 1e300); }

}  // namespace

TEST_CASE("the same run passes every check") {
  const CheckReport report = compareGolden(reread(exampleGolden()), exampleData());
  CHECK(report.passed());
  CHECK(report.scenario == "thesis/example");
  for (const CheckResult& r : report.results) {
    INFO(r.check);
    CHECK(r.passed);
    CHECK(r.failureClass == FailureClass::none);
    CHECK(r.message.empty());
    CHECK(r.kind == CheckKind::golden);
    CHECK(r.expected == r.actual);
  }
  CHECK(find(report, "bits").actual == Hash{0xabc, 0xdef}.text());
  CHECK_THAT(describe(report), ContainsSubstring("thesis/example: all 10 checks pass\n"));
}

TEST_CASE("each injected fault is found and named") {
  struct Fault {
    const char* what;
    std::function<void(GoldenFacts&)> inject;
    Checks found;  // as failedInOneLine returns them
  };
  static const std::vector<Fault> faults{
      {"another scenario text", [](auto& f) { f.scenarioHash[0] = 'f'; }, {"scenario INPUT_CHANGED: scenario_hash"}},
      {"another seed", [](auto& f) { f.seed = 8; }, {"scenario INPUT_CHANGED: seed"}},
      {"another scenario", [](auto& f) { f.scenario = "thesis/other"; }, {"scenario INPUT_CHANGED: scenario"}},
      {"one bit of the state", [](auto& f) { f.stateHash.low ^= 1; }, {"bits COMPUTATION: hash"}},
      {"one ulp in a cell's pressure",
       [](auto& f) { f.cells[0]["pressure"] = nextUp(f.cells[0].at("pressure")); },
       {"values COMPUTATION step 1024 cell A: pressure"}},
      {"one ulp on the way",
       [](auto& f) { f.samples[0]["volume"] = nextUp(2); },
       {"values COMPUTATION step 128: volume"}},
      {"the sign of a zero", [](auto& f) { f.cells[0]["x"] = 0.0; }, {"values COMPUTATION step 1024 cell A: x"}},
      {"a value that is no number",
       [](auto& f) { f.cells[0]["area"] = std::nan(""); },
       {"values COMPUTATION step 1024 cell A: area"}},
      {"an infinite value",
       [](auto& f) { f.end["kinetic_energy"] = std::numeric_limits<double>::infinity(); },
       {"values COMPUTATION step 1024: kinetic_energy"}},
      {"a neighbour too many",
       [](auto& f) { f.cells[0]["neighbours"] = 2; },
       {"values COMPUTATION step 1024 cell A: neighbours"}},
      {"two ulps, the earlier one first",
       [](auto& f) { f.cells[0]["area"] = nextUp(f.cells[0].at("area")), f.samples[0]["outermost"] = nextUp(0.9); },
       {"values COMPUTATION step 128: outermost"}},
      {"daughters swapped",
       [](auto& f) { std::swap(f.lineage[1].state, f.lineage[2].state); },
       {"lineage LINEAGE step 768 cell B: state"}},
      {"a division one step late",
       [](auto& f) { f.lineage[0].endedStep = 257; },
       {"lineage LINEAGE step 256 the egg: ended_step"}},
      {"a division one ulp late",
       [](auto& f) { f.lineage[0].ended = nextUp(1); },
       {"lineage LINEAGE step 256 the egg: ended"}},
      {"a birth one step early",
       [](auto& f) { f.lineage[1].bornStep = 255; },
       {"lineage LINEAGE step 255 cell A: born_step"}},
      {"a cell that does not die",
       [](auto& f) { f.lineage[2].fate = Fate::alive; },
       {"counts LINEAGE: count", "lineage LINEAGE step 768 cell B: ended"}},
      {"another substance", [](auto& f) { f.lineage[1].state = 0; }, {"lineage LINEAGE cell A: state"}},
      {"a cell lost",
       [](auto& f) { f.lineage.pop_back(); },
       {"counts LINEAGE: count", "lineage LINEAGE step 256 cell B: "}},
      {"a cell too many",
       [](auto& f) { f.lineage.push_back(cell("AB", 3, 800, Fate::alive, 1)); },
       {"counts LINEAGE: count", "lineage LINEAGE step 800 cell AB: "}},
      {"more steps", [](auto& f) { f.steps = 1025; }, {"counts COMPUTATION: count"}},
      {"a change of the time step too late",
       [](auto& f) { f.timeSteps[1].time = nextUp(1); },
       {"time_steps COMPUTATION step 256: time"}},
      {"another time step",
       [](auto& f) { f.timeSteps[1].timeStep *= 2; },
       {"time_steps COMPUTATION step 256: time_step"}},
      {"a change of the time step lost",
       [](auto& f) { f.timeSteps.pop_back(); },
       {"time_steps COMPUTATION step 256: "}},
      {"a time step too many",
       [](auto& f) {
         f.timeSteps.push_back({512, 2, 1});
       },
       {"time_steps COMPUTATION step 512: "}},
      {"the chain parts on the way",
       [](auto& f) { f.chain[1].hash.low = 9, f.chain[2].hash.low = 9; },
       {"step_hashes COMPUTATION step 256: hash"}},
      {"the chain parts before the first step",
       [](auto& f) { f.chain[0].hash.low = 9; },
       {"step_hashes SETUP step 0: hash"}},
      {"another first time step",
       [](auto& f) { f.timeSteps[0].timeStep *= 2; },
       {"time_steps SETUP step 0: time_step"}},
      {"a sample lost", [](auto& f) { f.samples.clear(); }, {"completeness INPUT_CHANGED step 128: "}},
      {"a sample at another step",
       [](auto& f) { f.samples[0].step = 127; },
       {"completeness INPUT_CHANGED step 128: step"}},
      {"a cell measured too many",
       [](auto& f) { f.cells.push_back(measures("B", 1)); },
       {"completeness INPUT_CHANGED step 1024 cell B: "}},
      {"bodies lost", [](auto& f) { f.mechanics = false; }, {"completeness INPUT_CHANGED step 128: "}},
  };
  const Golden golden = reread(exampleGolden());
  for (const Fault& fault : faults) {
    INFO(fault.what);
    const CheckReport report = compareWith(golden, fault.inject);
    Checks found;
    for (const CheckResult& r : report.results) {
      if (r.passed) continue;
      found.push_back(failedInOneLine(r));
      CHECK(r.expected != r.actual);
      CHECK_THAT(r.message, ContainsSubstring("example.golden"));
    }
    CHECK(found == fault.found);
  }
}

TEST_CASE("a changed lineage explains changed bits; a changed scenario explains all") {
  const Golden golden = reread(exampleGolden());
  const auto bothFaults = [](GoldenFacts& f) { f.lineage[1].state = 0, f.stateHash.low = 1; };
  CHECK(find(compareWith(golden, bothFaults), "bits").failureClass == FailureClass::lineage);
  const CheckReport report = compareWith(golden, [&](GoldenFacts& f) { bothFaults(f), f.scenarioHash[0] = 'f'; });
  CHECK(find(report, "bits").failureClass == FailureClass::inputChanged);
  CHECK(find(report, "lineage").failureClass == FailureClass::inputChanged);
}

TEST_CASE("the text names the line, the cell, both numbers, their bits and their distance") {
  const CheckReport report = compareWith(reread(exampleGolden()), [](GoldenFacts& f) {
    f.cells[0]["pressure"] = nextUp(f.cells[0].at("pressure"));
    f.lineage[0].endedStep = 300;
  });
  CHECK(find(report, "values").message ==
        "example.golden:54: final/A/pressure at step 1024: expected 0.40625 (0x3fda000000000000), actual "
        "0.40625000000000006 (0x3fda000000000001), 1 ulp apart, difference 5.551115123125783e-17; tolerance exact");
  CHECK(find(report, "lineage").message == "example.golden:17: the egg: ended_step: expected '256', actual '300'");
  const std::string text = describe(report);
  CHECK_THAT(text, ContainsSubstring("2 of 10 checks differ"));
  CHECK_THAT(text, ContainsSubstring("  FAIL  lineage: LINEAGE, the lineage differs\n        example.golden:17"));
  CHECK_THAT(text, ContainsSubstring("\n        consequences: values from step 1024 on: pressure of cell A 0.40625 "
                                     "→ 0.40625000000000006\n"));
}

TEST_CASE("a measure that joined after a golden was accepted is no part of it; a cell or a time that it lacks is") {
  const auto without = [](const auto& wanted) {
    Golden golden = exampleGolden();
    std::erase_if(golden.data.items, [&](const GoldenItem& i) {
      const std::string key = keyOf(i);
      return kindOf(i) == "value" && wanted(key);
    });
    return reread(golden);
  };
  const auto none = [](GoldenFacts&) {};
  CHECK(compareWith(without([](auto& key) { return key.ends_with("/sphericity"); }), none).passed());
  CHECK(compareWith(without([](auto& key) { return key.ends_with("/shell_fill"); }), none).passed());
  // Parts without which a golden is incomplete: one cell, one time, or a measure in one place only.
  for (const char* part : {"final/A/", "0.5/organism/", "0.5/organism/shell_fill"}) {
    INFO(part);
    const CheckReport report = compareWith(without([&](auto& key) { return key.starts_with(part); }), none);
    CHECK(failedChecks(report) == Checks{"completeness"});
  }
  // Values that the golden does name are compared.
  const CheckReport report = compareWith(without([](auto& key) { return key.ends_with("/sphericity"); }),
                                         [](GoldenFacts& f) { f.cells[0]["area"] = 7; });
  CHECK(failedChecks(report) == Checks{"values"});
}

TEST_CASE("of many differences nine are shown") {
  const CheckReport report =
      compareWith(reread(exampleGolden()), [](GoldenFacts& f) { f.cells.clear(), f.samples.clear(); });
  const std::string& text = find(report, "completeness").message;
  CHECK(std::count(text.begin(), text.end(), '\n') == 9);
  CHECK_THAT(text, ContainsSubstring("and 5 more"));
}

TEST_CASE("tolerances: the share that is used is told, the last matching rule holds") {
  const Golden golden =
      reread(exampleGolden({rule("final/* abs 8 why \"wide\""), rule("final/*/volume abs 0.5 why \"narrow\"")}));
  SECTION("inside") {
    const CheckReport report =
        compareWith(golden, [](GoldenFacts& f) { f.cells[0]["volume"] = 2.25, *f.cells[0]["area"] += 2; });
    CHECK(report.passed());
    CHECK(*find(report, "values final/*").share == Approx(0.25));
    CHECK(find(report, "values final/*").field == "area");
    CHECK(*find(report, "values final/*/volume").share == 0.5);
    CHECK(find(report, "values final/*/volume").cell == "A");
    CHECK(find(report, "values final/*/volume").tolerance == "abs 0.5");
    CHECK_FALSE(find(report, "values").share);
    CHECK_THAT(describe(report),
               ContainsSubstring(
                   "values final/*/volume: abs 0.5 (2 items), 50 % of the tolerance used by volume of cell A\n"));
  }
  SECTION("outside the narrow one, though inside the wide one") {
    const CheckReport report = compareWith(golden, [](GoldenFacts& f) { f.cells[0]["volume"] = 3; });
    CHECK(failedChecks(report) == Checks{"values final/*/volume"});
    CHECK(*find(report, "values final/*/volume").share == 2);
    CHECK_THAT(find(report, "values final/*/volume").message,
               ContainsSubstring("tolerance abs 0.5, used 2 times (example.golden:9)"));
  }
  SECTION("at the edge, and one representable number beyond") {
    CHECK(compareWith(golden, [](GoldenFacts& f) { f.cells[0]["volume"] = 2.5; }).passed());
    CHECK_FALSE(compareWith(golden, [](GoldenFacts& f) { f.cells[0]["volume"] = nextUp(2.5); }).passed());
  }
  SECTION("what no rule matches must be exact") {
    CHECK(failedChecks(compareWith(golden, [](GoldenFacts& f) { f.samples[0]["volume"] = nextUp(2); })) ==
          Checks{"values"});
  }
  SECTION("tolerances are for values only") {
    CHECK(failedChecks(compareWith(golden, [](GoldenFacts& f) { f.stateHash.low = 1; })) == Checks{"bits"});
  }
}

TEST_CASE("the order of the rules decides") {
  const Golden golden = reread(exampleGolden({rule("final/*/volume abs 0.5 why \"narrow\""), rule("final/* exact")}));
  CHECK_FALSE(compareWith(golden, [](GoldenFacts& f) { f.cells[0]["volume"] = nextUp(2); }).passed());
}

TEST_CASE("beyond its last step a rule does not hold") {
  const auto fault = [](GoldenFacts& f) { f.samples[0]["volume"] = 2.1, f.end["volume"] = 2.1; };
  const CheckReport report =
      compareWith(reread(exampleGolden({rule("*/organism/volume abs 0.5 until_step 512 why \"w\"")})), fault);
  CHECK(failedChecks(report) == Checks{"values"});
  CHECK(find(report, "values").firstStep == 1024u);
  CHECK(find(report, "values */organism/volume").passed);
  CHECK(find(report, "values */organism/volume").tolerance == "abs 0.5 until_step 512");
}

TEST_CASE("a rule that matches nothing is a failure, with its line") {
  const Golden golden = reread(exampleGolden({rule("final/*/volumes abs 0.5 why \"w\"")}));
  const CheckReport report = compareGolden(golden, exampleData());
  CHECK(failedChecks(report) == Checks{"tolerances"});
  CHECK(find(report, "tolerances").failureClass == FailureClass::inputChanged);
  CHECK_THAT(find(report, "tolerances").message,
             ContainsSubstring("example.golden:8: the tolerance rule 'final/*/volumes' matches no value"));
}

TEST_CASE("where the chain parts, the cells that differ are named") {
  const Golden golden = reread(exampleGolden());
  const CheckReport report =
      compareWith(golden, [](GoldenFacts& f) { f.chain[2].hash.low = 9, f.chain[2].state.cells[1].hash.low = 9; });
  const CheckResult& r = find(report, "step_hashes");
  CHECK(r.firstStep == 512u);
  CHECK(r.cell == "B");
  CHECK_THAT(r.message, ContainsSubstring("cells that differ at step 512: B"));
}

TEST_CASE("costs and pictures have classes of their own, unless something else explains them") {
  const Golden golden = reread(exampleGolden());
  const auto dearer = [](GoldenFacts& f) { f.costs[0].count = 6; };
  const auto redrawn = [](GoldenFacts& f) { f.images[0].hash.low = 9; };
  CHECK(find(compareWith(golden, dearer), "costs").failureClass == FailureClass::cost);
  CHECK(find(compareWith(golden, redrawn), "images").failureClass == FailureClass::image);
  const CheckReport both = compareWith(golden, [&](GoldenFacts& f) { redrawn(f), f.stateHash.low = 9; });
  CHECK(find(both, "images").failureClass == FailureClass::computation);
}

TEST_CASE("a picture of another renderer says nothing, nor does one that is not drawn") {
  const auto golden = reread(exampleGolden());
  const auto actual = [&](const GoldenImage& image) {
    const CheckReport report = compareWith(golden, [&](GoldenFacts& f) { f.images = {image}; });
    CHECK(report.passed());
    return find(report, "images").actual;
  };
  CHECK(actual({"organism", "painter-2", {9, 9}}) == "not compared: another renderer drew the picture");
  CHECK(actual({"organism", "none", {}}) == "not compared: the run draws no picture");
  CHECK_FALSE(compareWith(golden, [](GoldenFacts& f) { f.images.clear(); }).passed());
}

TEST_CASE("a difference no larger than one unit in the last place grows to is chaos") {
  Golden golden = exampleGolden();
  golden.growth = {{1e-9, 700}, {1e-8, 900}};
  golden = reread(golden);
  const auto classOf = [&](double volume) {
    return find(compareWith(golden, [&](GoldenFacts& f) { f.cells[0]["volume"] = volume; }), "values").failureClass;
  };
  CHECK(classOf(2 + 1e-8) == FailureClass::chaos);        // at step 1024, where chaos reaches 1e-8
  CHECK(classOf(2 + 1e-5) == FailureClass::computation);  // more than chaos reaches
  const auto early = [&](GoldenFacts& f) { f.samples[0]["volume"] = nextUp(2); };  // at step 128, before any growth
  CHECK(find(compareWith(golden, early), "values").failureClass == FailureClass::computation);
}

TEST_CASE("a tolerance beyond the chaos horizon is refused") {
  Golden golden = exampleGolden({rule("final/* rel 1e-9 why \"w\"")});
  golden.growth = {{1e-9, 700}};
  const CheckReport report = compareGolden(reread(golden), exampleData());
  CHECK(failedChecks(report) == Checks{"tolerances"});
  CHECK_THAT(find(report, "tolerances").message,
             ContainsSubstring("from step 700 on, the chaos horizon, an error of one unit in the last place has "
                               "grown as large; add until_step 699"));
  golden.rules = {rule("final/* rel 1e-8 why \"w\"")};  // wider than chaos reaches
  CHECK(compareGolden(reread(golden), exampleData()).passed());
  golden.rules = {rule("* rel 1e-9 until_step 699 why \"w\"")};
  CHECK(compareGolden(reread(golden), exampleData()).passed());
}

TEST_CASE("a lineage-only golden has no values, and rules have nothing to match") {
  GoldenFacts facts = exampleFacts();
  facts.mechanics = false;
  Golden golden = exampleGolden();
  golden.data = makeGoldenData(facts);
  CHECK(compareGolden(reread(golden), makeGoldenData(facts)).passed());
  golden.rules = {rule("* abs 1 why \"w\"")};
  CHECK(failedChecks(compareGolden(reread(golden), makeGoldenData(facts))) == Checks{"tolerances"});
}
