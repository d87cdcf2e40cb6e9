#include "biology/dna.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "catch.h"
#include "thesis_dna.h"

using namespace morula;

namespace {

std::string complaintAbout(const std::string& text, const std::string& file = "f", int line = 1,
                           int column = 1, const std::string& path = "",
                           const DnaSurroundings* surroundings = nullptr) {
  try {
    parseDna(text, file, line, column, path, surroundings);
  } catch (const InputError& error) { return error.what(); }
  return "";
}

std::string contentOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// g(product|input input): what was read, written again.
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
  CHECK(dna.substances ==
        std::vector<std::string>{"A", "B", "a0", "a1", "a2", "a3", "a4", "a5", "a6", "a7", "divide"});
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
  CHECK(written(parseDna("# g2(a|\nSTART: a0 # ) why\n  # indented\ng1(a1|a0, A)# at once\n#\n", "f")) ==
        plain);
}

TEST_CASE("substances are found by name") {
  const Dna dna = parseDna(uniqueFour, "f");
  for (SubstanceId id = 0; id < dna.substances.size(); ++id)
    CHECK(findSubstance(dna, dna.substances[id]) == id);
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

// tests/bad_dna: each file, and beside it what must be said about it, word for word.
TEST_CASE("every bad DNA file gets exactly the expected complaints") {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MORULA_SOURCE_DIR "/tests/bad_dna")) {
    if (entry.path().extension() != ".dna") continue;
    ++files;
    const std::string name = entry.path().filename().string();
    INFO(name);
    auto expected = entry.path();
    const DnaSurroundings nothing;
    CHECK(complaintAbout(contentOf(entry.path()), name, 1, 1, "", &nothing) + "\n" ==
          contentOf(expected.replace_extension(".expected")));
  }
  CHECK(files >= 20);
}
