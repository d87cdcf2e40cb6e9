// Downloads: fields that need quotes, and a tree that other readers understand.
#include "report/tables.h"

#include "catch.h"
#include "report/verdict.h"

namespace morula {
namespace {

RunResults threeCells() {
  RunResults results;
  const CellPath egg, a = egg.daughter(false), b = egg.daughter(true);
  results.lineage = {
      {egg, 0, 1, 0, 1, Fate::divided, 0}, {a, 1, 2.5, 1, 2, Fate::died, 1}, {b, 1, 0, 1, 0, Fate::alive, 0}};
  results.stateTexts = {{0, "a0"}, {1, "a0 a1"}};
  results.names = {{a, "O'Neil, \"A\""}};
  return results;
}

TEST_CASE("A field with commas and quotes is quoted [RFC 4180]") {
  CHECK(cellsCsv(threeCells()) ==
        "path,name,born,ended,fate,state\r\n,,0,1,divided,a0\r\nA,\"O'Neil, \"\"A\"\"\",1,2.5,died,a0 "
        "a1\r\nB,,1,,alive,a0\r\n");
  CHECK(samplesCsv(threeCells()).empty());
}

TEST_CASE("The tree in Newick's format: a branch is as long as its cell has lived") {
  CHECK(newick(threeCells(), 4) == "('O''Neil, \"A\"':1.5,'B':3)'egg':1;\n");
  CHECK(newick({}, 4).empty());
}

TEST_CASE("The worst stands first, each kind with a word for it") {
  const std::string html =
      findingsHtml({{Finding::Kind::good, "g"}, {Finding::Kind::warning, "w"}, {Finding::Kind::bad, "b"}});
  CHECK(html.find("Fault") < html.find("Warning"));
  CHECK(html.find("Warning") < html.find("</span>g"));
}

TEST_CASE("Failed checks show what differs, and their texts stay texts") {
  CheckResult failed{.check = "values <b>",
                     .kind = "golden",
                     .expected = "1",
                     .actual = "2",
                     .tolerance = "rel 1e-9",
                     .passed = false,
                     .failureClass = "COMPUTATION",
                     .firstStep = 7,
                     .cell = "AB",
                     .field = "volume",
                     .share = 12.5,
                     .message = "<script>"};
  const std::string html = checksOf({failed}, {});
  CHECK_THAT(html, ContainsSubstring("values &lt;b&gt;"));
  CHECK_THAT(html, ContainsSubstring("1250 %") || ContainsSubstring("1.25e+03 %"));
  CHECK_THAT(html, ContainsSubstring("step 7 cell AB volume"));
  CHECK_THAT(html, !ContainsSubstring("<script>"));
}

TEST_CASE("A word of a command line is one word") {
  CHECK(shellWord("a/b-1.db") == "a/b-1.db");
  CHECK(shellWord("it's $HOME") == "'it'\\''s $HOME'");
  CHECK(shellWord("") == "''");
}

}  // namespace
}  // namespace morula
