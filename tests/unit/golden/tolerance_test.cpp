// Boundary cases: at the edge of a tolerance, and one representable number inside and outside.
#include "golden/tolerance.h"

#include <cmath>
#include <limits>

#include "catch.h"

using namespace morula;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
const double notANumber = std::nan("");

double up(double x) { return std::nextafter(x, inf); }
double down(double x) { return std::nextafter(x, -inf); }

Tolerance tolerance(const std::string& text) {
  return readRule("tolerance * " + text + " why \"test\"", "t").tolerance;
}

void complains(const std::string& line, const std::string& about) {
  INFO(line);
  CHECK_THROWS_WITH(readRule(line, "x.golden:7"),
                    Catch::Matchers::StartsWith("x.golden:7: ") && ContainsSubstring(about));
}

}  // namespace

TEST_CASE("ulps count representable numbers") {
  CHECK(ulpsBetween(1, 1) == 0);
  CHECK(ulpsBetween(1, up(1)) == 1);
  CHECK(ulpsBetween(down(1), up(1)) == 2);
  CHECK(ulpsBetween(-1, down(-1)) == 1);
  CHECK(ulpsBetween(0.0, -0.0) == 0);
  CHECK(ulpsBetween(down(0.0), up(0.0)) == 2);
  CHECK(ulpsBetween(-1, 1) == 2 * ulpsBetween(0, 1));
  CHECK(ulpsBetween(-inf, inf) == 2 * 0x7ff0000000000000u);
  CHECK(ulpsBetween(std::numeric_limits<double>::max(), inf) == 1);
  CHECK(ulpsBetween(1, notANumber) == std::numeric_limits<std::uint64_t>::max());
  double x = 1;
  for (int i = 0; i < 1000; ++i) x = down(x);
  CHECK(ulpsBetween(1, x) == 1000);
}

TEST_CASE("exact is the same bits") {
  const Tolerance exact;
  CHECK(exact.passes(0.1, 0.1));
  CHECK(exact.share(0.1, 0.1) == 0);
  CHECK_FALSE(exact.passes(0.1, up(0.1)));
  CHECK_FALSE(exact.passes(0.0, -0.0));
  CHECK_FALSE(exact.passes(notANumber, notANumber));
}

TEST_CASE("abs") {
  const Tolerance t = tolerance("abs 0.25");
  CHECK(t.passes(1, 1.25));
  CHECK(t.passes(1, 0.75));
  CHECK(t.share(1, 1.25) == 1);
  CHECK(t.share(1, 1.125) == 0.5);
  CHECK_FALSE(t.passes(1, up(1.25)));
  CHECK_FALSE(t.passes(1, down(0.75)));
  CHECK(t.share(0.0, -0.0) == 0);
}

TEST_CASE("rel, with a scale below which values count as that large") {
  const Tolerance t = tolerance("rel 0.125 scale 2");
  CHECK(t.passes(16, 18));
  CHECK(t.passes(-16, -18));
  CHECK_FALSE(t.passes(16, up(18)));
  CHECK(t.passes(0, 0.25));  // 0.125 · 2
  CHECK_FALSE(t.passes(0, up(0.25)));
  CHECK(t.share(16, 17) == 0.5);
  CHECK_FALSE(tolerance("rel 0.125").passes(0, 1e-300));  // without a scale only 0 is near 0
  CHECK(tolerance("rel 0.125").passes(0.0, -0.0));
}

TEST_CASE("ulp") {
  const Tolerance t = tolerance("ulp 2");
  CHECK(t.passes(1, up(up(1))));
  CHECK(t.share(1, up(1)) == 0.5);
  CHECK_FALSE(t.passes(1, up(up(up(1)))));
  CHECK(t.allowed(1) == up(up(1)) - 1);
  CHECK(t.allowed(-1024) == up(up(1024)) - 1024);
}

TEST_CASE("what is not a finite number is within no tolerance") {
  for (const char* text : {"exact", "abs 1e300", "rel 1e300", "ulp 9e18"}) {
    INFO(text);
    CHECK_FALSE(tolerance(text).passes(1, notANumber));
    CHECK_FALSE(tolerance(text).passes(notANumber, 1));
    CHECK_FALSE(tolerance(text).passes(notANumber, notANumber));
  }
  CHECK_FALSE(tolerance("abs 1e300").passes(1, inf));
  CHECK_FALSE(tolerance("abs 1e300").passes(inf, 1));
  CHECK_FALSE(tolerance("rel 1").passes(inf, 1));
}

TEST_CASE("patterns") {
  CHECK(fitsGlob("*", ""));
  CHECK(fitsGlob("*", "final/egg/x"));
  CHECK(fitsGlob("final/*/volume", "final/AB/volume"));
  CHECK_FALSE(fitsGlob("final/*/volume", "final/AB/volumes"));
  CHECK_FALSE(fitsGlob("final/*/volume", "final/volume"));
  CHECK(fitsGlob("*a*b*", "xxaxxbxx"));
  CHECK(fitsGlob("*ab", "aab"));
  CHECK(fitsGlob("*aab", "aaab"));
  CHECK_FALSE(fitsGlob("*ab", "aba"));
  CHECK(fitsGlob("abc", "abc"));
  CHECK_FALSE(fitsGlob("abc", "abcd"));
  CHECK_FALSE(fitsGlob("abcd", "abc"));
  CHECK_FALSE(fitsGlob("", "a"));
  CHECK(fitsGlob("", ""));
  CHECK(fitsGlob("**", "a"));
  CHECK_FALSE(fitsGlob("a.c", "abc"));  // patterns are no regular expressions
}

TEST_CASE("rules are read and written alike") {
  for (const char* line : {"tolerance final/*/volume exact", "tolerance * abs 1e-09 why \"a b, c\"",
                           "tolerance x rel 1e-12 scale 0.5 why \"w\"", "tolerance x rel 1e-12 why \"w\"",
                           "tolerance x ulp 4 until_step 512 why \"w\"", "tolerance x exact until_step 0"}) {
    INFO(line);
    CHECK(readRule(line, "t").text() == line);
  }
}

TEST_CASE("a rule holds up to its step") {
  const ToleranceRule r = readRule("tolerance final/* abs 1 until_step 512 why \"chaos from here\"", "t");
  CHECK(r.matches("final/egg/x", 0));
  CHECK(r.matches("final/egg/x", 512));
  CHECK_FALSE(r.matches("final/egg/x", 513));
  CHECK_FALSE(r.matches("0.5/egg/x", 0));
}

TEST_CASE("rules that cannot be understood") {
  complains("tolerance", "the pattern is missing");
  complains("tolerance x", "the kind of tolerance is missing");
  complains("tolerance x near 1 why \"w\"", "'near' is no kind of tolerance");
  complains("tolerance x abs why \"w\"", "'why' is not a number above 0");
  complains("tolerance x abs -1 why \"w\"", "'-1' is not a number above 0");
  complains("tolerance x abs 0 why \"w\"", "above 0");
  complains("tolerance x abs nan why \"w\"", "'nan' is not a number above 0");
  complains("tolerance x abs inf why \"w\"", "'inf' is not a number above 0");
  complains("tolerance x abs 1e-9", "needs its reason");
  complains("tolerance x abs 1e-9 why", "the reason is missing");
  complains("tolerance x abs 1e-9 why \"  \"", "needs its reason");
  complains("tolerance x abs 1e-9 why \"open", "not closed");
  complains("tolerance x abs 1e-9 scale 1 why \"w\"", "'scale' is not understood here");
  complains("tolerance x rel 1e-9 until_step soon why \"w\"", "until_step 'soon'");
  complains("tolerance x ulp 1.5 why \"w\"", "whole numbers");
  complains("tolerance x exact 3", "'3' is not understood here");
}
