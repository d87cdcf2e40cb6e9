// Texts made safe to show, and file names made from texts.
#include "files/text.h"

#include "base/utf8.h"
#include "catch.h"
#include "files/printable.h"

using namespace morula;

TEST_CASE("what a terminal would obey becomes visible") {
  CHECK(printable("plain, ä, 日本, 🙂\n\tx") == "plain, ä, 日本, 🙂\n\tx");
  CHECK(printable("\x1b[31m") == "\\x1b[31m");
  CHECK(printable("a\rb\x7f") == "a\\x0db\\u007f");
  CHECK(printable(std::string_view("x\0y", 3)) == "x\\x00y");
  CHECK(printable("\xc2\x9b"
                  "1m") == "\\u009b1m");
  CHECK(printable("\xe2\x80\xae"
                  "abc\xe2\x81\xa9") == "\\u202eabc\\u2069");
  CHECK(printable("\xff\xc0\xaf") == "\\xff\\xc0\\xaf");
  CHECK(printable("\xe2\x80") == "\\xe2\\x80");  // cut within a character
  CHECK(printableLine("a\nb\tc\r") == "a\\nb\\tc\\r");
}

TEST_CASE("the values of characters") {
  for (const auto& [text, value] : {std::pair{"a", U'a'}, {"ä", U'ä'}, {"日", U'日'}, {"🙂", U'🙂'}})
    CHECK(utf8Value(text, utf8Length(text)) == value);
}

TEST_CASE("a name made from data is a name, and no path") {
  CHECK(safeName("two words.dna", "x") == "two words.dna");
  CHECK(safeName("/etc/zelle-ä.dna", "x") == "zelle-ä.dna");
  CHECK(safeName("a:b\\c|d.obj", "x") == "a_b_c_d.obj");
  CHECK(safeName("\x1b[31m\xff\n", "x") == "__31m__");
  for (const char* nothing : {"", ".", "..", "../..", "a/", "/", "..."}) CHECK(safeName(nothing, "x") == "x");
  const auto cut = safeName(std::string(300, 'n') + ".yaml", "x");
  CHECK(cut.size() == 100);
  CHECK(cut.ends_with("n.yaml"));
  std::string umlauts;
  for (int i = 0; i < 90; ++i) umlauts += "ä";
  const auto whole = safeName("1" + umlauts, "x");
  CHECK(whole.size() == 99);
  CHECK(printable(whole) == whole);
}

TEST_CASE("Words are joined, lines are parted, and a bar does not end a table's cell") {
  CHECK(join({}) == "");
  CHECK(join({"a"}, " or ") == "a");
  CHECK(join({"a", "b", "c"}) == "a, b, c");
  CHECK(join({"a", "b", "c"}, " or ") == "a, b or c");
  CHECK(linesOf("a\n\nb") == std::vector<std::string>{"a", "", "b"});
  CHECK(linesOf("").empty());
  CHECK(firstLine("a\nb") == "a");
  CHECK(markdownCell("|a||b") == "\\|a\\|\\|b");
}
