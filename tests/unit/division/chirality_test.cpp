// The chirality of a division: from its rule, or else the common one.
#include "catch.h"
#include "division/parameters.h"

using namespace morula;

TEST_CASE("chirality: none, that of all, and that of the first rule that fits") {
  DivisionParameters p;
  CHECK_FALSE(chiralityOf(p, CellPath(), "a0 divide"));
  CHECK(longestChirality(p) == 0);
  p.rules = {DivisionRule{.of = {"a1", "divide"}, .chirality = Chirality{20, 0.5}}, DivisionRule{.of = {"a1"}},
             DivisionRule{.of = {"a0"}, .chirality = Chirality{-10, 0.75}}};
  CHECK(chiralityOf(p, CellPath(), "a1 divide") == Chirality{20, 0.5});
  CHECK_FALSE(chiralityOf(p, CellPath(), "a1"));  // the first rule that fits has no chirality, and later rules do not count
  CHECK(chiralityOf(p, CellPath(), "a0") == Chirality{-10, 0.75});
  CHECK_FALSE(chiralityOf(p, CellPath(), "a2"));
  CHECK(longestChirality(p) == 0.75);
  p.chirality = Chirality{5, 1};
  CHECK(chiralityOf(p, CellPath(), "a1") == Chirality{5, 1});
  CHECK(chiralityOf(p, CellPath(), "a2") == Chirality{5, 1});
  CHECK(chiralityOf(p, CellPath(), "a0") == Chirality{-10, 0.75});
  CHECK(longestChirality(p) == 1);
}

TEST_CASE("polarities are kept where some plane has them") {
  DivisionParameters p;
  CHECK_FALSE(keepsPolarity(p));
  p.rules = {DivisionRule{.of = {"a1"}},
             DivisionRule{.of = {"a0"}, .plane = PlaneChoice{.plane = DivisionPlane::polarity}}};
  CHECK(keepsPolarity(p));
  p.rules.clear();
  p.otherwise.plane = DivisionPlane::polarity;
  CHECK(keepsPolarity(p));
}
