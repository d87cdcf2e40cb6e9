// The words of a page; texts of users stay texts.
#include "catch.h"
#include "golden/change.h"
#include "report/run_blocks.h"
#include "report_data/run_words.h"

namespace morula {
namespace {

TEST_CASE("Failed checks show what differs, and their texts stay texts") {
  CheckResult failed{.check = "values <b>",
                     .kind = CheckKind::golden,
                     .expected = "1",
                     .actual = "2",
                     .tolerance = "rel 1e-9",
                     .passed = false,
                     .failureClass = FailureClass::computation,
                     .firstStep = 7,
                     .cell = "AB",
                     .field = "volume",
                     .share = 12.5,
                     .message = "<script>"};
  const std::string html = htmlOf(checksOf({{.check = "counts", .kind = CheckKind::golden}, failed}, {}));
  CHECK_THAT(html, ContainsSubstring("values &lt;b&gt;"));
  CHECK_THAT(html, ContainsSubstring("12.5 times"));
  CHECK_THAT(html, ContainsSubstring("from step 7 on, cell AB, volume"));
  CHECK_THAT(html, !ContainsSubstring("<script>"));
  CHECK(html.find("values") < html.find("counts"));  // failed checks come first
}

TEST_CASE("A share of a tolerance is read at a glance") {
  CHECK(shareText({}).empty());
  CHECK(shareText(0) == "0 %");
  CHECK(shareText(0.0716) == "7.16 %");
  CHECK(shareText(1e-9) == "below\u00a00.01\u00a0%");
  CHECK(shareText(2.23e9) == "2.23e+09 times");
}

// A change in the form of changeInWords.
const std::string change =
    "  changed   physics.pressure.constant: 155 → 155.5\n"
    "            physics.drag: 1 → <i>2</i>\n"
    "  lineage   the same\n"
    "  moved     cell AB the farthest: 0.02 radii of the egg\n"
    "  pressure  +3 % in the mean, cell AB the most: 4 %\n";

TEST_CASE("What changed is one sentence, and a table") {
  CHECK(changeSentence(change) ==
        "physics.pressure.constant: 155 → 155.5 and 1 more; same lineage; cell AB moved farthest, by 0.02 radii of the "
        "egg; pressure: +3 % in the mean, cell AB the most: 4 %");
  const std::string table = htmlOf(Document().add(changeTable(change, {})));
  CHECK_THAT(table, ContainsSubstring("physics.pressure.constant: 155 → 155.5<br>physics.drag: 1 → &lt;i&gt;2"));
  CHECK_THAT(table, ContainsSubstring(">moved</th><td>cell AB the farthest"));
  CHECK(changeSentence("").empty());
}

TEST_CASE("A failure is told clause by clause") {
  CHECK(failedBecause(Finding::Kind::bad, "Failed: ", "step 5: it burst") ==
        Finding{Finding::Kind::bad, "Failed: step 5: it burst"});
  CHECK(failedBecause(Finding::Kind::bad, "", "one; two; three").why == std::vector<std::string>{"two", "three"});
}

TEST_CASE("A word of a command line is one word") {
  CHECK(shellWord("a/b-1.db") == "a/b-1.db");
  CHECK(shellWord("it's $HOME") == "'it'\\''s $HOME'");
  CHECK(shellWord("") == "''");
}

TEST_CASE("Runs are told apart by seed, by what their scenarios differ in, and by their ids") {
  const auto run = [](double drag, std::uint64_t seed, const std::string& id) {
    RunFacts facts;
    facts.run.id = id;
    facts.run.record.scenario = "small";
    facts.run.record.seed = seed;
    facts.scenario.scene.mechanics.emplace().physics.drag = drag;
    return facts;
  };
  const auto titles = [](auto... one) {
    std::vector<RunFacts> runs;
    (runs.push_back(std::move(one)), ...);
    nameRuns(runs);
    std::vector<std::string> all;
    for (const RunFacts& r : runs) all.push_back(titleOf(r));
    return all;
  };
  using Titles = std::vector<std::string>;
  CHECK(titles(run(1, 1, "p"), run(1, 2, "q")) == Titles{"small, seed 1", "small, seed 2"});
  CHECK(titles(run(1, 1, "p"), run(4, 1, "q")) == Titles{"physics.drag 1", "physics.drag 4"});
  CHECK(titles(run(1, 1, "p"), run(4, 1, "q"), run(4, 2, "r")) ==
        Titles{"small, seed 1, physics.drag 1", "small, seed 1, physics.drag 4", "small, seed 2"});
  CHECK(titles(run(1, 1, "p"), run(1, 1, "q")) == Titles{"small, seed 1 (p)", "small, seed 1 (q)"});
}

}  // namespace
}  // namespace morula
