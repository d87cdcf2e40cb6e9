// Values and rules that one golden hands on to the next.
#include "golden/golden_diff.h"

#include "catch.h"
#include "example_facts.h"

using namespace morula;

namespace {

std::string valueOf(const GoldenData& data, const std::string& key) {
  for (const auto* value : all<GoldenValue>(data))
    if (goldenText(value->name) == key) return goldenText(value->value);
  return "";
}

}  // namespace

TEST_CASE("values within tolerance stay byte for byte, others are new") {
  const Golden old = exampleGolden({rule("final/A/* rel 1e-9 why \"w\"")});
  GoldenFacts facts = exampleFacts();
  facts.cells[0]["volume"] = 2 + 1e-12;    // within tolerance
  facts.cells[0]["area"] = 0.4;            // beyond tolerance
  facts.samples[0]["volume"] = 2 + 1e-12;  // no rule applies, so exact
  const GoldenData kept = keepValuesWithinTolerance(dataOf(facts), old);
  CHECK(valueOf(kept, "final/A/volume") == "2");
  CHECK(valueOf(kept, "final/A/area") == "0.4");
  CHECK(valueOf(kept, "0.5/organism/volume") == "2.000000000001");
  CHECK(kept.items.size() == old.data.items.size());
}

TEST_CASE("rules end at the chaos horizon, and those that say nothing any more are dropped") {
  Golden golden = exampleGolden({rule("* rel 1e-9 why \"all\""), rule("final/* rel 1e-9 why \"end\""),
                                 rule("final/* rel 1e-3 why \"wide\""), rule("final/* exact")});
  golden.growth = {{1e-9, 700}};
  std::vector<std::string> notes;
  const auto rules = limitToHorizon(golden, notes);
  REQUIRE(rules.size() == 3);
  CHECK(rules[0].untilStep == 699u);
  CHECK(rules[0].why == "all");
  CHECK(rules[1].why == "wide");
  CHECK_FALSE(rules[1].untilStep);
  CHECK(rules[2].tolerance.kind == Tolerance::Kind::exact);
  REQUIRE(notes.size() == 2);
  CHECK_THAT(notes[0], ContainsSubstring("step 699"));
  CHECK_THAT(notes[1], ContainsSubstring("dropped"));
  golden.rules = rules;
  CHECK(compareGolden(reread(golden), exampleData()).passed());
}

TEST_CASE("what became looser is told with the rule that did it") {
  const Golden before = exampleGolden({rule("final/* rel 1e-9 why \"w\"")});
  const auto looser = [&](std::vector<ToleranceRule> rules) {
    return loosenedTolerances(before, exampleGolden(std::move(rules)));
  };
  CHECK(looser(before.rules).empty());
  CHECK(looser({}).empty());  // exact is stricter
  CHECK(looser({rule("final/* rel 1e-10 why \"w\"")}).empty());
  const auto lines = looser({rule("final/* rel 1e-9 why \"w\""), rule("final/A/volume abs 1 why \"x\"")});
  REQUIRE(lines.size() == 1);
  CHECK(lines[0] ==
        "1 value: `tolerance final/A/volume abs 1 why \"x\"`, before `tolerance final/* rel 1e-09 why \"w\"`");
  CHECK(looser({rule("* ulp 1 why \"w\"")}).size() == 2);  // exact, also on the way, became an ulp
}

TEST_CASE("a reviewer sees what is gone, new and changed") {
  const Golden golden = exampleGolden();
  GoldenFacts facts = exampleFacts();
  CHECK(describeGoldenDiff(golden, dataOf(facts)).empty());
  facts.samples.clear();
  facts.lineage[1].state = 0;
  facts.stateHash.low = 1;
  facts.cells[0]["volume"] = 3;
  facts.timeSteps.push_back({512, 2, 1});
  const std::string text = describeGoldenDiff(golden, dataOf(facts));
  CHECK_THAT(text, ContainsSubstring("6 removed\n  value 0.5/organism/cells"));
  CHECK_THAT(text, ContainsSubstring("1 new\n  time_step 512 2 1\n"));
  CHECK_THAT(text, ContainsSubstring("1 changed in the lineage\n  cell A"));
  CHECK_THAT(text, ContainsSubstring("1 changed bits\n  bits solver"));
  CHECK_THAT(text,
             ContainsSubstring("1 changed values\n  value final/A/volume 1024 2  →  value final/A/volume 1024 3\n"));
}
