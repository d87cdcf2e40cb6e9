// One document and one table in every form: the words and numbers are equal, and no text becomes markup.
#include "document/document.h"

#include "catch.h"

using namespace morula;

namespace {

struct Body {
  std::string name;
  double volume;
  std::optional<double> pressure;
};

Table bodies(std::vector<Body> rows) {
  const std::vector<FieldOf<Body>> fields{
      {{"name", "cell", "Cell"}, [](const Body& b) { return b.name; }},
      {{"volume", "volume", "Volume"}, [](const Body& b) { return number(b.volume, 3); }},
      {{"", "", "Pressure"}, [](const Body& b) { return number(b.pressure); }},
      {{"pressure", "", ""}, [](const Body& b) { return number(b.pressure); }},
  };
  return tableOf("Bodies", fields, rows);
}

const std::string evil = "</td><script>alert(1)</script>";

std::string html(Document document) { return htmlOf(document); }

}  // namespace

TEST_CASE("A column that is declared once stands in every form, under its name there") {
  const Table table = bodies({{"AB", 4.18879020478639, {}}, {"P1", 12.5, 0.25}});
  CHECK(textOf(table) ==
        "  Cell  Volume  Pressure\n"
        "  AB      4.19         -\n"
        "  P1      12.5      0.25\n");
  CHECK(csvOf(table) == "cell,volume\r\nAB,4.18879020478639\r\nP1,12.5\r\n");
  CHECK(jsonOf(table) == Json::array({Json{{"name", "AB"}, {"volume", 4.18879020478639}, {"pressure", nullptr}},
                                      Json{{"name", "P1"}, {"volume", 12.5}, {"pressure", 0.25}}}));
  CHECK(markdownOf(table) == "| Cell | Volume | Pressure |\n|---|---|---|\n| AB | 4.19 | |\n| P1 | 12.5 | 0.25 |\n");
  CHECK_THAT(html(Document().add(table)),
             ContainsSubstring("<th scope=\"col\">Volume</th>") &&
                 ContainsSubstring("<tr><th scope=\"row\">AB</th><td class=\"number\">4.19</td><td></td></tr>"));
}

TEST_CASE("Letters count, not bytes, and a column of words stands at the left") {
  CHECK(textOf(Table{"", {"η²", "n"}, {{"µm", 7}, {"a longer word", 12}}}) ==
        "  η²              n\n  µm              7\n  a longer word  12\n");
}

TEST_CASE("CSV is quoted where a text asks for it [RFC 4180]") {
  const Table table = bodies({{"a,b", 1, {}}, {"say \"x\"", 2, {}}, {"two\nlines", 3, {}}, {"", 4, {}}});
  CHECK(csvOf(table, "\n") == "cell,volume\n\"a,b\",1\n\"say \"\"x\"\"\",2\n\"two\nlines\",3\n,4\n");
}

TEST_CASE("Tables of several kinds become one, by the names of their columns") {
  Table other{"", {Column("", "volume", ""), Column("", "share", "")}, {{number(1.5), number(0.5)}}};
  CHECK(csvOf(stacked({{"body", bodies({{"AB", 2, {}}})}, {"other", other}}, {"kind", "volume"}), "\n") ==
        "kind,volume,cell,share\nbody,2,AB,\nother,1.5,,0.5\n");
}

TEST_CASE("No text becomes markup, wherever it stands") {
  Document all;
  all.say(evil).note(bold(evil)).heading(code(evil)).say(Words(evil, Emphasis::bad, "\" onclick=\"alert(2)"));
  all.say(Words(evil, Emphasis::link, "\" onclick=\"alert(3)"));
  all.add(FindingList{{{Finding::Kind::bad, evil, {evil}}}})
      .add(PlainList{{evil}})
      .add(Verbatim{evil})
      .add(bodies({{evil, 1, {}}}));
  all.add(Table{evil, {evil}, {{evil}}}).add(Picture{"image/png", "", evil, evil}).add(Swipe{"a", "b", evil});
  all.add(LineKey{{{{}, true, evil}}}).add(Downloads{{{evil, "text/csv", ""}}}).add(folded(evil, Document().say(evil)));
  const std::string page = htmlOf(all);
  CHECK_THAT(page, !ContainsSubstring("<script") && !ContainsSubstring("\" onclick"));
  CHECK_THAT(page, ContainsSubstring("&lt;/td&gt;&lt;script&gt;"));
  CHECK_THAT(html(Document().say("a\x1b[2J")), ContainsSubstring("a\\x1b[2J"));
  CHECK(markdownOf(Table{"", {"a"}, {{"x|y\nz"}}}) == "| a |\n|---|\n| x\\|y\\nz |\n");
}

TEST_CASE("A link leads to a place of its own page, and is words elsewhere") {
  const Document link = Document().say(Words("seed 1", Emphasis::link, "left=3"));
  CHECK_THAT(htmlOf(link), ContainsSubstring("<a href=\"#left=3\">seed 1</a>"));
  CHECK(textOf(link) == "seed 1\n");
}

TEST_CASE("The worst finding stands first, each kind with a word for it, and what is below it with it") {
  const std::string page = html(Document().add(FindingList{
      {{Finding::Kind::good, "g"}, {Finding::Kind::warning, "w"}, {Finding::Kind::bad, "b", {"one", "two"}}}}));
  CHECK(page.find("Fault") < page.find("Warning"));
  CHECK(page.find("Warning") < page.find("</span>g"));
  CHECK_THAT(page, ContainsSubstring("</span>b<ul class=\"why\"><li>one</li><li>two</li></ul></li>"));
}

TEST_CASE("What is folded on a page stands in a text, and pictures do not") {
  Document all;
  all.say("first")
      .heading("then")
      .add(folded("more", Document().say("last")))
      .add(Picture{"image/png", "x", "what", "caption"});
  CHECK(textOf(all) == "first\n\nthen\nlast\n");
}

TEST_CASE("Emphasis is no part of a text; lists and sizes are as people write them") {
  CHECK(("a " + bold("b") + code("c") + Words("z", Emphasis::subscript)).text() == "a bc_z");
  CHECK(listed(std::vector<std::string>{}).empty());
  CHECK(listed(std::vector<std::string>{"a", "b", "c"}) == "a, b and c");
  CHECK(listed(std::vector<Words>{bold("a"), bold("b"), bold("c")}, 2) == bold("a") + ", " + bold("b") + " and 1 more");
  CHECK(inBytes(1) == "1 byte");
  CHECK(inBytes(2750) == "2.75 kB");
  CHECK(inBytes(1'200'000) == "1.2 MB");
}
