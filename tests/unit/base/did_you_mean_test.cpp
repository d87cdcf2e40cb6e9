#include "base/did_you_mean.h"

#include <vector>

#include "catch.h"

using namespace morula;

TEST_CASE("editDistance counts insertions, deletions, replacements and swaps") {
  CHECK(editDistance("", "") == 0);
  CHECK(editDistance("", "abc") == 3);
  CHECK(editDistance("divide", "divide") == 0);
  CHECK(editDistance("devide", "divide") == 1);
  CHECK(editDistance("divde", "divide") == 1);
  CHECK(editDistance("diivide", "divide") == 1);
  CHECK(editDistance("dviide", "divide") == 1);
  CHECK(editDistance("Divide", "divide") == 1);
  CHECK(editDistance("kitten", "sitting") == 3);
  CHECK(editDistance("sitting", "kitten") == 3);
}

TEST_CASE("equalButForCase") {
  CHECK(equalButForCase("Divide", "dIVIDE"));
  CHECK(equalButForCase("", ""));
  CHECK_FALSE(equalButForCase("divide", "divides"));
  CHECK_FALSE(equalButForCase("divides", "divide"));
  CHECK_FALSE(equalButForCase("[", "{"));  // [ and { differ in the bit that tells upper from lower case
}

TEST_CASE("closest names what was probably meant, and nothing rather than something far") {
  const std::vector<std::string> words = {"a1", "body", "stiffness", "tail"};
  CHECK(closest("bodi", words) == "body");
  CHECK(closest("BODY", words) == "body");
  CHECK(closest("stifness", words) == "stiffness");
  CHECK(closest("stiffnesses", words) == "stiffness");
  CHECK(closest("A1", words) == "a1");
  CHECK(closest("a0", words).empty());  // another digit is another name, not a typing error
  CHECK(closest("to", words).empty());
  CHECK(closest("pressure", words).empty());
  CHECK(closest("", words).empty());
}
