// Names of cells: by hand for the worm's first cells, and properties of all names.
#include "helpers.h"

using namespace morula;
using namespace morula::test;

namespace {

const std::string worm = small +
                         "names: {egg: P0, daughters: [a, p], cells: {A: AB, B: P1, BA: EMS, BB: P2, BAA: MS, "
                         "BAB: E}}\n";

std::optional<std::string> nameIn(const Scenario& s, const char* path) { return s.names.of(CellPath::parse(path)); }

}  // namespace

TEST_CASE("a cell goes by her own name, or by her mother's and an ending") {
  const auto s = read(worm);
  const std::vector<std::pair<const char*, std::string>> expected = {
      {"", "P0"},      {"A", "AB"},    {"B", "P1"},    {"AA", "ABa"},  {"AB", "ABp"},
      {"ABA", "ABpa"}, {"BA", "EMS"},  {"BB", "P2"},   {"BAA", "MS"},  {"BAB", "E"},
      {"BAAA", "MSa"}, {"BABB", "Ep"}, {"BBB", "P2p"}, {"BBA", "P2a"}, {"AABBA", "ABappa"}};
  for (const auto& [path, name] : expected) {
    INFO(path);
    CHECK(nameIn(s, path) == name);
    CHECK(s.names.find(name) == std::vector{CellPath::parse(path)});
  }
  CHECK(s.names.find("ABx").empty());
  CHECK(s.names.find("").empty());
  CHECK(s.names.find("P0a").empty());  // P0's daughter is called AB
}

TEST_CASE("without a rule for it a cell has no name") {
  const auto s = read(small + "names: {cells: {A: AB}}\n");
  CHECK(nameIn(s, "A") == "AB");
  CHECK_FALSE(nameIn(s, ""));
  CHECK_FALSE(nameIn(s, "B"));
  CHECK_FALSE(nameIn(s, "AA"));
  CHECK_FALSE(nameIn(read(small + "names: {cells: {A: AB}, daughters: [l, r]}\n"), "BA"));
  CHECK(read(small).names.empty());
  CHECK_FALSE(read(small).names.function());
}

TEST_CASE("every path has a name of its own that leads back to it, however endings look") {
  for (const std::string endings : {"[a, p]", "[l, ra]", "[ab, aa]", "['0', '1']"}) {
    const auto s = read(small + "names: {egg: Z, cells: {BA: Q}, daughters: " + endings + "}\n");
    std::vector<CellPath> level{CellPath()};
    for (int depth = 0; depth < 8; ++depth) {
      std::vector<CellPath> next;
      for (const CellPath& path : level) {
        CHECK(s.names.find(s.names.of(path).value()) == std::vector{path});
        next.push_back(path.daughter(false)), next.push_back(path.daughter(true));
      }
      level = next;
    }
  }
}

TEST_CASE("a cell is meant by her name, then by her path") {
  const auto names = read(worm).names;
  const auto meant = [&](const char* text) { return cellCalled(names, text, "--cell").text(); };
  CHECK(meant("AB") == "A");    // her name
  CHECK(meant("/AB") == "AB");  // always the path
  CHECK(meant("path AB") == "AB");
  CHECK(meant("cell AB") == "A");
  CHECK(meant("path egg").empty());
  CHECK_THROWS_AS(meant("cell BBA"), InputError);  // a path, and no name
  CHECK(meant("BBA") == "BBA");
  CHECK(meant("ABpa") == "ABA");
  CHECK(meant("P0").empty());
  CHECK(meant("egg").empty());
  CHECK(cellCalled({}, "AB", "--cell").text() == "AB");
  CHECK_THROWS_WITH(meant("EMs"), "--cell: 'EMs' is no cell's name or path; did you mean EMS?");
  CHECK_THROWS_WITH(cellCalled({}, "x", "--cell"),
                    "--cell: 'x' is no cell's path; needs egg, or a path of the letters A and B, as AAB");
  CHECK_THROWS_AS(meant(""), InputError);
  CHECK_THROWS_AS(meant(std::string(121, 'A').c_str()), InputError);
}

TEST_CASE("messages tell the names of the cells that they are about") {
  const auto nameOf = read(worm).names.function();
  CHECK(withNames("step 3, cell AAB: volume of cell B, cellar, cell, cell ABC", nameOf) ==
        "step 3, ABap (path AAB): volume of P1 (path B), cellar, cell, cell ABC");
  CHECK(withNames("cell A", nameOf) == "AB (path A)");
  CHECK(withNames("cell A", {}) == "cell A");
  CHECK(cellWords(nameOf, {}) == "P0 (the egg)");
  CHECK(cellWords({}, {}) == "the egg");
}

TEST_CASE("what names may be made of") {
  for (const char* good : {"P0", "ABalaaa", "köpf", "a.b-c_d", "MS#2"}) CHECK(isCellName(good));
  for (const std::string bad :
       {"", " ", "a b", "a\tb", "/a", "a\x7f", "a\xe2\x80\xae", "\xff", "a\xc2\xa0z", "=A1", "+1", "-1", "@x"})
    CHECK_FALSE(isCellName(bad));
  CHECK(isCellName(std::string(40, 'a')));
  CHECK_FALSE(isCellName(std::string(41, 'a')));
}

TEST_CASE("names may stand in a file, and the resolved form then holds them") {
  const TemporaryFolder folder;
  const auto load = [&](const std::string& file, const std::string& names) {
    writeText(folder / "names.txt", file);
    writeText(folder / "s.yaml", small + "names: " + names + "\n");
    return loadScenario(folder / "s.yaml");
  };
  const std::string lines = "# the worm\r\n\n  egg\tP0 # unfertilised\nA AB\r\nB P1\nBA EMS";
  const auto s = load(lines, "{file: names.txt, daughters: [a, p], cells: {BB: P2}}");
  CHECK(nameIn(s, "") == "P0");
  CHECK(nameIn(s, "BAA") == "EMSa");
  CHECK(nameIn(s, "BB") == "P2");
  CHECK(s.files.size() == 1);
  const auto again = read(s.resolved);
  CHECK(again.resolved == s.resolved);
  CHECK(again.names.given == s.names.given);

  const auto complaint = [&](const std::string& file, const std::string& names) {
    const std::string all = refusalOf([&] { load(file, names); });
    return all.substr(all.rfind('/', all.find(':')) + 1);
  };
  CHECK(complaint("C x\n", "{file: names.txt}") ==
        "names.txt:1:1: 'C' is not a cell's path; needs a line 'PATH NAME', as 'AB ABp', or 'egg P0'");
  CHECK(complaint("A x\n B\n", "{file: names.txt}") ==
        "names.txt:2:2: has a path and no name; needs a line 'PATH NAME', as 'AB ABp', or 'egg P0'");
  CHECK(complaint("A x y\n", "{file: names.txt}") ==
        "names.txt:1:1: has text after the name; needs a line 'PATH NAME', as 'AB ABp', or 'egg P0'");
  CHECK_THAT(complaint("A x\n", "{file: names.txt, cells: {A: y}}"),
             ContainsSubstring("cell A is named here and in names.cells.A; keep one of the two"));
  CHECK_THAT(complaint("# nobody\n", "{file: names.txt}"), ContainsSubstring("names no cell"));
  CHECK_THAT(complaint("A x\nB x\n", "{file: names.txt}"),
             ContainsSubstring("names.txt:1:1: 'x' is also the name of path B; give each cell a name of her own"));
}
