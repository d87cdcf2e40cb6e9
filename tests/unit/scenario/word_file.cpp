// Files of names and of references, with the line ends and marks that editors on other systems write.
#include "values/word_file.h"

#include "helpers.h"

using namespace morula;
using namespace morula::test;
using scenario::Place;
using scenario::Problems;

namespace {

struct WordsRead {
  std::vector<scenario::WordLine> lines;
  std::string problems;
};

WordsRead readLines(const std::string& text) {
  Problems problems("s.yaml");
  WordsRead read{scenario::readWordFile(text, "names.txt", Place{3, 5, ""}, problems), ""};
  try {
    problems.throwIfAny();
  } catch (const InputError& error) { read.problems = error.what(); }
  return read;
}

}  // namespace

TEST_CASE("lines of words are the same behind a byte order mark and with the line ends of any system") {
  for (const char* end : {"\n", "\r\n", "\r"})
    for (const char* mark : {"", "\xEF\xBB\xBF"})
      for (const char* last : {"", end}) {
        const auto [lines, problems] =
            readLines(mark + std::string("A AB") + end + "# a comment" + end + end + "  B P1 # E" + last);
        CHECK(problems == "");
        REQUIRE(lines.size() == 2);
        CHECK(lines[0].words == std::vector<std::string>{"A", "AB"});
        CHECK(lines[0].line == 1);
        CHECK(lines[1].words == std::vector<std::string>{"B", "P1"});
        CHECK(lines[1].line == 4);
        CHECK(lines[1].column == 3);
      }
}

TEST_CASE("characters that show as blanks are named with their place in the file") {
  const auto [lines, problems] = readLines("A AB\nB\xC2\xA0P1\nBA\xE2\x80\x8B EMS\nBB P2 # \xC2\xA0\n");
  CHECK(lines.size() == 2);
  CHECK(problems ==
        "names.txt:2:2: U+00A0 no-break space stands in the line; remove it, or replace it by a space\n"
        "names.txt:3:3: U+200B zero-width space stands in the line; remove it, or replace it by a space");
  CHECK(readLines(std::string("\xFF\xFE"
                              "A\0",
                              4))
            .problems == "names.txt:1:1: the file is UTF-16; save it as UTF-8");
  CHECK(readLines("A AB\nB M\xFCller\n").problems == "names.txt:2:4: a byte is not UTF-8; save the file as UTF-8");
}
