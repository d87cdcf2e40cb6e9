// What continuous integration reads, letter by letter.
#include "golden/ci_reports.h"

#include "catch.h"

using namespace morula;

namespace {

CheckResult passed(const std::string& check) {
  CheckResult r;
  r.check = check;
  return r;
}

CheckResult failed(const std::string& check, const std::string& failureClass, const std::string& message) {
  CheckResult r = passed(check);
  r.passed = false;
  r.failureClass = failureClass;
  r.message = message;
  return r;
}

std::vector<CheckReport> example() {
  return {{"thesis/four", {passed("bits"), passed("lineage")}},
          {"hard/<a & \"b\">",
           {failed("values *.volume", "COMPUTATION",
                   "golden/hard/a.golden:12: 1/volume: expected 1, actual 2\nand 99 more, 50 % of them"),
            failed("golden", "SETUP", "golden/hard/a,b.golden is not there"), passed("shell")}}};
}

}  // namespace

TEST_CASE("JUnit's XML: a suite for a scenario, a case for a check") {
  CHECK(junitXml(example()) ==
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<testsuites name=\"morula check\" tests=\"5\" failures=\"2\">\n"
        "  <testsuite name=\"thesis/four\" tests=\"2\" failures=\"0\">\n"
        "    <testcase classname=\"thesis/four\" name=\"bits\"/>\n"
        "    <testcase classname=\"thesis/four\" name=\"lineage\"/>\n"
        "  </testsuite>\n"
        "  <testsuite name=\"hard/&lt;a &amp; &quot;b&quot;&gt;\" tests=\"3\" failures=\"2\">\n"
        "    <testcase classname=\"hard/&lt;a &amp; &quot;b&quot;&gt;\" name=\"values *.volume\">\n"
        "      <failure type=\"COMPUTATION\" message=\"golden/hard/a.golden:12: 1/volume: expected 1, actual "
        "2\">"
        "golden/hard/a.golden:12: 1/volume: expected 1, actual 2&#10;and 99 more, 50 % of them</failure>\n"
        "    </testcase>\n"
        "    <testcase classname=\"hard/&lt;a &amp; &quot;b&quot;&gt;\" name=\"golden\">\n"
        "      <failure type=\"SETUP\" message=\"golden/hard/a,b.golden is not there\">"
        "golden/hard/a,b.golden is not there</failure>\n"
        "    </testcase>\n"
        "    <testcase classname=\"hard/&lt;a &amp; &quot;b&quot;&gt;\" name=\"shell\"/>\n"
        "  </testsuite>\n"
        "</testsuites>\n");
  CHECK(junitXml({{"a\x01z", {}}}).find("\"a\\x01z\"") != std::string::npos);
}

TEST_CASE("Annotations name the file and the line, and keep clear of the commands' punctuation") {
  CHECK(annotations(example()) ==
        "::error file=golden/hard/a.golden,line=12,title=COMPUTATION%3A hard/<a & \"b\">::"
        "values *.volume: 1/volume: expected 1, actual 2\n"
        "::error title=SETUP%3A hard/<a & \"b\">::golden: golden/hard/a,b.golden is not there\n");
  CHECK(annotations({{"s", {failed("c", "SETUP", "a,b.golden:7: 50 % off")}}}) ==
        "::error file=a%2Cb.golden,line=7,title=SETUP%3A s::c: 50 %25 off\n");
  CHECK(annotations({{"s", {failed("c", "SETUP", "a.golden: scenario_hash: 1: other")}}}) ==
        "::error file=a.golden,title=SETUP%3A s::c: scenario_hash: 1: other\n");
  CHECK(annotations({{"s", {passed("c")}}}).empty());
}

TEST_CASE("Of many annotations nine are shown, and how many more there are") {
  CheckReport report{"s", {}};
  for (int i = 0; i < 9; ++i) report.results.push_back(failed("c", "BITS", "x"));
  const auto lines = [&] {
    const std::string text = annotations({report});
    return std::count(text.begin(), text.end(), '\n');
  };
  CHECK(lines() == 9);
  for (int i = 0; i < 3; ++i) report.results.push_back(failed("c", "BITS", "x"));
  CHECK(lines() == 10);
  CHECK_THAT(annotations({report}), ContainsSubstring("::3 more checks differ; see the log\n"));
}

TEST_CASE("The summary is a table, and what differs is in a second one") {
  CHECK(summaryPage({{"a", {passed("bits")}}}) ==
        "### morula check\n\n| scenario | checks | |\n|---|---|---|\n| a | 1 | pass |\n");
  CHECK(summaryPage({{"a", {passed("bits"), failed("values", "COMPUTATION", "g:1: a|b\nmore")}}}) ==
        "### morula check\n\n| scenario | checks | |\n|---|---|---|\n| a | 2 | **1 differ** |\n"
        "\n| scenario | check | class | what differs first |\n|---|---|---|---|\n"
        "| a | values | COMPUTATION | g:1: a\\|b |\n");
}
