#include "biology/dna.h"

#include <algorithm>

#include "catch.h"
#include "organism.h"
#include "temporary_folder.h"
#include "thesis_dna.h"

using namespace morula;

namespace {

std::string complaintAbout(const std::string& text, const std::string& file = "f", int line = 1, int column = 1,
                           const std::string& path = "", const DnaSurroundings* surroundings = nullptr) {
  try {
    parseDna(text, file, line, column, path, surroundings);
  } catch (const InputError& error) { return error.what(); }
  return "";
}

/// Returns the genes that were read, written as g(product|input input).
std::vector<std::string> written(const Dna& dna) {
  std::vector<std::string> lines;
  for (const Gene& gene : dna.genes) {
    std::string line = gene.name + "(" + dna.substances[gene.product] + "|";
    for (SubstanceId input : gene.inputs) line += (line.back() == '|' ? "" : " ") + dna.substances[input];
    lines.push_back(line + ")");
  }
  return lines;
}

}  // namespace

TEST_CASE("the thesis' DNA is read as printed") {
  const Dna dna = parseDna(uniqueFour, "unique-four.dna");
  CHECK(dna.substances == std::vector<std::string>{"A", "B", "a0", "a1", "a2", "a3", "a4", "a5", "a6", "a7", "divide"});
  CHECK(dna.start == std::vector<SubstanceId>{2});
  CHECK(dna.source == uniqueFour);
  CHECK(written(dna) == std::vector<std::string>{"g1(a1|a0)", "g2(divide|a0)", "g3(a2|A a1)", "g4(a3|B a1)",
                                                 "g5(divide|a1)", "g6(a4|A a2)", "g7(a5|B a2)", "g8(a6|A a3)",
                                                 "g9(a7|B a3)", "g10(a4|a4)", "g11(a5|a5)", "g12(a6|a6)",
                                                 "g13(a7|a7)"});
  CHECK(parseDna(equalSubtrees, "equal-subtrees.dna").genes.size() == 13);
}

TEST_CASE("START may repeat, and one line may hold several substances") {
  const Dna one = parseDna("START: a0, a1, a2\n", "f");
  const Dna three = parseDna("START: a2\nSTART: a0\nSTART: a1\n", "f");
  CHECK(one.start == std::vector<SubstanceId>{2, 3, 4});
  CHECK(three.start == one.start);
  CHECK(three.substances == one.substances);
}

TEST_CASE("white space, comments and line ends do not matter") {
  const auto plain = written(parseDna("START: a0\ng1(a1|a0, A)\n", "f"));
  CHECK(written(parseDna("START:a0\ng1(a1|a0,A)", "f")) == plain);
  CHECK(written(parseDna("\n  START :\ta0  \n\n\t g1 ( a1 | a0 , A ) \n   ", "f")) == plain);
  CHECK(written(parseDna("START: a0\r\n\r\ng1(a1|a0, A)\r\n", "f")) == plain);
  CHECK(written(parseDna("\xEF\xBB\xBFSTART: a0\ng1(a1|a0, A)\n", "f")) == plain);
  CHECK(written(parseDna("# g2(a|\nSTART: a0 # ) why\n  # indented\ng1(a1|a0, A)# at once\n#\n", "f")) == plain);
}

TEST_CASE("a line with a range is one line for each of its numbers") {
  const std::string ranged =
      "START: s{i} for i in 2..3\nSTART: n0\n"
      "on{n+1} (n{ n + 1 }|n{n}, A) for n in 0..2# one daughter goes on\n"
      "off(for|n3, s2, s3)\nfor(for|for)\n"  // `for` may still be a substance
      "d{k}x{k-1}(divide|n{k-1},!x{k}y)for k in 1..3\ny{n}(x{n}y|n3) for n in 1 .. 3\n";
  const std::string plain =
      "START: s2, s3, n0\n"
      "on1(n1|n0, A)\non2(n2|n1, A)\non3(n3|n2, A)\n"
      "off(for|n3, s2, s3)\nfor(for|for)\n"
      "d1x0(divide|n0, !x1y)\nd2x1(divide|n1, !x2y)\nd3x2(divide|n2, !x3y)\n"
      "y1(x1y|n3)\ny2(x2y|n3)\ny3(x3y|n3)\n";
  const Dna one = parseDna(ranged, "f"), other = parseDna(plain, "f");
  CHECK(one.substances == other.substances);
  CHECK(one.start == other.start);
  CHECK(written(one) == written(other));
  for (std::size_t i = 0; i < one.genes.size(); ++i) CHECK(one.genes[i].repressors == other.genes[i].repressors);
}

TEST_CASE("a lineage that a range counts is the one of its genes written out") {
  std::string plain;
  for (int n = 0; n < 40; ++n) {
    const std::string from = std::to_string(n), to = std::to_string(n + 1);
    plain += "on" + from + "(n" + to + "|n" + from + ", A)\nout" + from + "(skin|n" + from + ", B)\n" + "d" + from +
             "(divide|n" + from + ", A)\n";
  }
  const std::string egg = "START: egg\nfirst(n0|egg)\nd(divide|egg)\nkeep(skin|skin)\n";
  Organism counted(egg +
                   "on{n}(n{n+1}|n{n}, A) for n in 0..39\nout{n}(skin|n{n}, B) for n in 0..39\n"
                   "d{n}(divide|n{n}, A) for n in 0..39\n");
  Organism writtenOut(egg + plain);
  for (int cycle = 0; cycle < 45; ++cycle) {
    counted.runCellCycle(), writtenOut.runCellCycle();
    REQUIRE(counted.cells() == writtenOut.cells());
  }
  CHECK(counted.size() == 42);  // the egg's division and forty more, each of one cell
  CHECK(counted.census().at("skin") == 40);
}

TEST_CASE("ranges write so many names, and a thousand mistakes of one are one complaint") {
  const auto genes = [](int last) {
    return "START: a0\ng{n}(a{n+1}|a{n}, !a{n+1}) for n in 1.." + std::to_string(last) + "\nb(a1|a0)\n";
  };
  CHECK(parseDna(genes(5000), "f").genes.size() == 5001);
  CHECK(complaintAbout(genes(5001)) ==
        "f:2:28: ranges write more than 20000 names in all (some 5000 genes); shorten them");
  CHECK(complaintAbout("START: a0\ng{n}(b{n}|c{n}, a0) for n in 1..4000\n") ==
        "f:2:11: nothing produces 'c1', so this gene is never active; add it to START or write a gene that "
        "produces it");
}

TEST_CASE("substances are found by name") {
  const Dna dna = parseDna(uniqueFour, "f");
  for (SubstanceId id = 0; id < dna.substances.size(); ++id) CHECK(findSubstance(dna, dna.substances[id]) == id);
  CHECK_FALSE(findSubstance(dna, "a8"));
  CHECK_FALSE(findSubstance(dna, ""));
  CHECK_FALSE(findSubstance(dna, "zebra"));
}

TEST_CASE("complaints give the place in the file that the DNA is embedded in") {
  CHECK(complaintAbout("START: a0\ng1(a1 a0)\n", "f.yaml", 7, 3, "dna") ==
        "f.yaml:8:9: dna: '|' is missing after the product 'a1'; a gene is written g1(product|input, input)");
  CHECK(complaintAbout("START: a0\ng1(a1|a0, a0)\n", "f.yaml", 7, 3, "dna") ==
        "f.yaml:8:13: dna: 'a0' is an input of this gene already; remove one");
}

TEST_CASE("a binary file is not answered with a complaint for each of its lines") {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "\x01\n";
  const std::string complaint = complaintAbout(text);
  CHECK(std::ranges::count(complaint, '\n') == 50);
  CHECK(complaint.ends_with("\nf: … and 951 more like these"));  // 1000 lines and the missing START, less 50
}

// Each file in tests/bad_dna stands beside its expected messages, word for word.
TEST_CASE("every bad DNA file gets exactly the expected complaints") {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MORULA_SOURCE_DIR "/tests/bad_dna")) {
    if (entry.path().extension() != ".dna") continue;
    ++files;
    const std::string name = entry.path().filename().string();
    INFO(name);
    auto expected = entry.path();
    const DnaSurroundings nothing;
    CHECK(complaintAbout(readText(entry.path()), name, 1, 1, "", &nothing) + "\n" ==
          readText(expected.replace_extension(".expected")));
  }
  CHECK(files >= 20);
}
