// Reports for continuous integration, letter by letter.
#include "golden/ci_reports.h"

#include "catch.h"

using namespace morula;

namespace {

CheckResult passed(const std::string& check) {
  CheckResult r;
  r.check = check;
  return r;
}

CheckResult failed(const std::string& check, FailureClass failureClass, const std::string& message) {
  CheckResult r = passed(check);
  r.passed = false;
  r.failureClass = failureClass;
  r.message = message;
  return r;
}

std::vector<CheckReport> example() {
  return {{"thesis/four", {passed("bits"), passed("lineage")}},
          {"hard/<a & \"b\">",
           {failed("values *.volume", FailureClass::computation,
                   "golden/hard/a.golden:12: 1/volume: expected 1, actual 2\nand 99 more, 50 % of them"),
            failed("golden", FailureClass::setup, "golden/hard/a,b.golden is not there"), passed("shell")}}};
}

}  // namespace

TEST_CASE("JUnit's XML: a suite for a scenario, a case for a check") {
  CHECK(junitXml(example()) ==
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<testsuites name=\"morula check\" tests=\"5\" failures=\"2\">\n"
        "  <testsuite name=\"thesis/four\" tests=\"2\" failures=\"0\" skipped=\"0\">\n"
        "    <testcase classname=\"thesis/four\" name=\"bits\"/>\n"
        "    <testcase classname=\"thesis/four\" name=\"lineage\"/>\n"
        "  </testsuite>\n"
        "  <testsuite name=\"hard/&lt;a &amp; &quot;b&quot;&gt;\" tests=\"3\" failures=\"2\" skipped=\"0\">\n"
        "    <testcase classname=\"hard/&lt;a &amp; &quot;b&quot;&gt;\" name=\"values *.volume\">\n"
        "      <failure type=\"COMPUTATION\" message=\"computed values differ: golden/hard/a.golden:12: 1/volume: "
        "expected 1, actual 2\">golden/hard/a.golden:12: 1/volume: expected 1, actual 2&#10;and 99 more, 50 % of "
        "them</failure>\n"
        "    </testcase>\n"
        "    <testcase classname=\"hard/&lt;a &amp; &quot;b&quot;&gt;\" name=\"golden\">\n"
        "      <failure type=\"SETUP\" message=\"the scenario has no golden: golden/hard/a,b.golden is not "
        "there\">golden/hard/a,b.golden is not there</failure>\n"
        "    </testcase>\n"
        "    <testcase classname=\"hard/&lt;a &amp; &quot;b&quot;&gt;\" name=\"shell\"/>\n"
        "  </testsuite>\n"
        "</testsuites>\n");
  CHECK(junitXml({{"a\x01z", {}}}).find("\"a\\x01z\"") != std::string::npos);
}

TEST_CASE("Annotations name the file and the line, and keep clear of the commands' punctuation") {
  CHECK(annotations(example()) ==
        "::error file=golden/hard/a.golden,line=12,title=COMPUTATION%3A hard/<a & \"b\">::computed values differ: "
        "values *.volume: 1/volume: expected 1, actual 2\n"
        "::error title=SETUP%3A hard/<a & \"b\">::the scenario has no golden: golden/hard/a,b.golden is not there\n");
  CHECK(annotations({{"s", {failed("c", FailureClass::setup, "a,b.golden:7: 50 % off")}}}) ==
        "::error file=a%2Cb.golden,line=7,title=SETUP%3A s::the initial state differs: c: 50 %25 off\n");
  CHECK(annotations({{"s", {failed("c", FailureClass::setup, "a.golden: scenario_hash: 1: other")}}}) ==
        "::error file=a.golden,title=SETUP%3A s::the initial state differs: c: scenario_hash: 1: other\n");
  CHECK(annotations({{"s", {passed("c")}}}).empty());
}

TEST_CASE("Of many annotations nine are shown, and how many more there are") {
  std::vector<CheckReport> reports;
  const auto lines = [&] {
    const std::string text = annotations(reports);
    return std::count(text.begin(), text.end(), '\n');
  };
  for (int i = 0; i < 9; ++i) reports.push_back({"s", {failed("c", FailureClass::cost, "x")}});
  CHECK(lines() == 9);
  for (int i = 0; i < 3; ++i) reports.push_back({"s", {failed("c", FailureClass::cost, "x")}});
  CHECK(lines() == 10);
  CHECK_THAT(annotations(reports), ContainsSubstring("::3 more; see the log\n"));
}

namespace {

/// Returns a report in which one key of a scenario has changed, and therefore bits and values. The end is not sane,
/// either.
CheckReport changedKey() {
  CheckResult bits = failed("bits", FailureClass::inputChanged,
                            "g:7: bits solver: the hash differs from the accepted one"),
              values = failed("values *", FailureClass::inputChanged, "g:9: 1/volume: expected 1, actual 1.5"),
              scenario = failed("scenario", FailureClass::inputChanged, "g: physics.drag: expected '1', actual '2': …"),
              sane = failed("sanity volume", FailureClass::computation, "not sane at the end: cell A is crushed");
  for (CheckResult* r : {&bits, &values, &scenario}) r->kind = CheckKind::golden;
  values.field = "volume", values.expected = "1", values.actual = "1.5", values.firstStep = 4;
  sane.kind = CheckKind::sanity;
  return {"two",
          {bits, passed("lineage"), values, scenario, sane},
          "  changed   physics.drag: 1 → 2\n  lineage   the same\n",
          "scenarios/two.yaml"};
}

}  // namespace

TEST_CASE("What follows from one cause is one failure with it") {
  const auto report = changedKey();
  const auto causes = causesOf(report);
  REQUIRE(causes.size() == 2);
  CHECK(causes[0][0]->check == "scenario");
  CHECK(followingInWords(causes[0]) == "bits; values * from step 4 on: volume 1 → 1.5");
  CHECK(causes[1][0]->check == "sanity volume");
  CHECK(causes[1].size() == 1);

  const std::string junit = junitXml({report});
  CHECK_THAT(junit, ContainsSubstring("tests=\"5\" failures=\"2\" skipped=\"2\""));
  CHECK_THAT(junit,
             ContainsSubstring("name=\"bits\">\n      <skipped message=\"this difference follows from scenario\"/>"));
  CHECK_THAT(junit, ContainsSubstring("message=\"the scenario changed: physics.drag: 1 → 2; same lineage\">"));
  CHECK_THAT(junit, ContainsSubstring("&#10;consequences: bits; values * from step 4 on: volume 1 → 1.5&#10;") &&
                        ContainsSubstring(" explain scenarios/two.yaml` shows where the difference began"));
  CHECK_THAT(junit, ContainsSubstring("message=\"the end of the run is not sane: not sane at the end: cell A is "
                                      "crushed\">not sane"));
  CHECK(annotations({report}) ==
        "::error file=g,title=INPUT_CHANGED%3A two::the scenario changed: physics.drag: 1 → 2; same lineage\n"
        "::error title=COMPUTATION%3A two::the end of the run is not sane: sanity volume: not sane at the end: cell "
        "A is crushed\n");
}

TEST_CASE("A chaotic value and other bits have one cause, a rule that fits nothing another") {
  CheckReport report{"s",
                     {failed("bits", FailureClass::computation, "b"), failed("values", FailureClass::chaos, "v"),
                      failed("tolerances", FailureClass::inputChanged, "t")}};
  for (CheckResult& r : report.results) r.kind = CheckKind::golden;
  report.results[1].firstStep = 9;
  const auto causes = causesOf(report);
  REQUIRE(causes.size() == 2);
  CHECK(causes[0][0]->check == "values");  // values tell more than the end's hash
  CHECK(causes[0].size() == 2);
  CHECK(causes[1][0]->check == "tolerances");
}

TEST_CASE("The summary takes no HTML, links and images from names and messages") {
  CheckReport report{"<img src=x>[a](b) & `c`", {failed("values", FailureClass::computation, "<b>g</b>:1: ![i](j)")}};
  report.results[0].kind = CheckKind::golden;
  report.change = "  changed   name: <i>a</i> → [b](c)\n";
  report.file = "a`b`.yaml";
  const std::string page = summaryPage({report});
  CHECK(page.find("<i") == page.npos);
  CHECK(page.find("<b") == page.npos);
  CHECK_THAT(page, ContainsSubstring("#### &lt;img src=x>\\[a](b) &amp; `c`") &&
                       ContainsSubstring("| &lt;img src=x>") && ContainsSubstring("!\\[i](j)") &&
                       ContainsSubstring("→ \\[b](c)") && ContainsSubstring("`` "));
}

TEST_CASE("The summary is a table, and below it stands what differs, in words") {
  CHECK(summaryPage({{"a", {passed("bits")}}}) ==
        "### morula check\n\n| scenario | checks | |\n|---|---|---|\n| a | 1 | pass |\n");
  CHECK(summaryPage({{"a", {passed("bits"), failed("values", FailureClass::computation, "g:1: a|b\nmore")}}}) ==
        "### morula check\n\n| scenario | checks | |\n|---|---|---|\n| a | 2 | **computed values differ** |\n"
        "\n#### a\n\n| COMPUTATION | computed values differ |\n|---|---|\n| check | values: g:1: a\\|b |\n");
  CHECK_THAT(
      summaryPage({changedKey()}),
      ContainsSubstring("| two | 5 | **the scenario changed; the end of the run is not sane** |\n\n#### two\n") &&
          ContainsSubstring("| changed | physics.drag: 1 → 2 |\n| lineage | the same |\n| follow | bits; values") &&
          ContainsSubstring(" review scenarios/two.yaml` shows"));
}
