// Division rules: which rule applies to which cell.
#include "division/rules.h"

#include "base/error.h"
#include "base/random.h"
#include "catch.h"
#include "known_cell.h"
#include "unit/physics/lab.h"

using namespace morula;

namespace {

KnownCell cellWith(const char* path, const char* substances) {
  KnownCell cell(path, zoo::scaled(makeIcosphere(1), {1, 1, 3}));
  cell.held = substances;
  return cell;
}

PlaneChoice along(const Vector& axis) { return {DivisionPlane::axis, axis}; }

/// Returns the number of the rule that fits, from 1, or 0 if none fits.
int ruleOf(const DivisionParameters& division, const char* substances) {
  const DivisionRule* rule = ruleFor(division, CellPath(), substances);
  return rule ? static_cast<int>(rule - division.rules.data()) + 1 : 0;
}

}  // namespace

TEST_CASE("The first rule counts all of whose patterns stand for a substance of the cell") {
  const DivisionParameters division{
      .rules = {{.of = {"AB"}}, {.of = {"skin", "P*"}}, {.of = {"P*"}}, {.of = {"AB", "x"}}, {.of = {"*"}}}};
  CHECK(ruleOf(division, "AB") == 1);
  CHECK(ruleOf(division, "AB divide x") == 1);  // the fourth rule is never reached
  CHECK(ruleOf(division, "P1 divide skin") == 2);
  CHECK(ruleOf(division, "P divide skin") == 2);
  CHECK(ruleOf(division, "P1 divide") == 3);
  CHECK(ruleOf(division, "ABa") == 5);  // without *, AB stands for its own name alone
  CHECK(ruleOf(division, "divide skin") == 5);
  CHECK(ruleOf(division, "") == 0);
  CHECK(ruleOf({}, "AB") == 0);
}

TEST_CASE("What a rule does not say is as of other cells") {
  const DivisionParameters division{.otherwise = along({0, 2, 0}),
                                    .rules = {{.of = {"a"}, .plane = along({-3, 0, -4}), .share = 0.3},
                                              {.of = {"b"}, .share = 0.6},
                                              {.of = {"c"}, .plane = PlaneChoice{DivisionPlane::longest}}}};
  const auto policy = makeDivisionPolicy(division, 1);
  const Cut a = policy->findCut(cellWith("A", "a b")), b = policy->findCut(cellWith("A", "b c"));
  const Cut c = policy->findCut(cellWith("A", "c")), none = policy->findCut(cellWith("A", "d"));
  CHECK(norm(a.normal - Vector{-0.6, 0, -0.8}) < 1e-15);  // a given axis is never reversed
  CHECK(a.share == 0.3);
  CHECK(b.normal == Vector{0, 1, 0});
  CHECK(b.share == 0.6);
  CHECK(norm(c.normal - Vector{0, 0, 1}) < 1e-7);
  CHECK_FALSE(c.share);
  CHECK(none.normal == Vector{0, 1, 0});
  CHECK_FALSE(none.share);
  CHECK(planeFor(division, CellPath(), "c").plane == DivisionPlane::longest);
  CHECK(planeFor(division, CellPath(), "b") == division.otherwise);
}

TEST_CASE("A tilt is of its rule, or else of the variation; none is none") {
  const DivisionParameters division{.otherwise = along({1, 0, 0}),
                                    .rules = {{.of = {"a"}, .tilt = 5.0}, {.of = {"b"}, .tilt = 0.0}}};
  const VariationParameters variation{.tilt = 20};
  const auto plain = makeDivisionPolicy(division, 1), varied = makeDivisionPolicy(division, 1, variation);
  const auto angle = [](const DivisionPolicy& policy, const char* substances) {
    return std::acos(std::min(1.0, policy.findCut(cellWith("AB", substances)).normal.x));
  };
  CHECK(angle(*plain, "a") > 0);
  CHECK(angle(*plain, "b") == 0);
  CHECK(angle(*plain, "c") == 0);
  CHECK(angle(*varied, "a") == angle(*plain, "a"));
  CHECK(angle(*varied, "b") == 0);
  CHECK(angle(*varied, "c") > angle(*plain, "a"));  // both tilts come from one draw
  CHECK(angle(*varied, "c") == Approx(4 * angle(*plain, "a")).epsilon(0.02));
}

TEST_CASE("A cell's deviations are keyed by seed and path, whatever its rule and plane") {
  const VariationParameters variation{.share = 0.05};
  const DivisionParameters two{.rules = {{.of = {"a"}, .plane = along({1, 0, 0}), .share = 0.3},
                                         {.of = {"b"}, .plane = PlaneChoice{DivisionPlane::random}}}};
  const auto deviation = [&](std::uint64_t seed, const char* path, const char* substances, double about) {
    return *makeDivisionPolicy(two, seed, variation)->findCut(cellWith(path, substances)).share - about;
  };
  const double first = deviation(1, "AB", "a", 0.3);
  CHECK(first == Approx(0.05 * randomDeviate({1, CellPath::parse("AB"), 0, Purpose::shareVariation})).epsilon(1e-12));
  CHECK(deviation(1, "AB", "b", 0.5) == Approx(first).epsilon(1e-12));
  CHECK(deviation(1, "AB", "none", 0.5) == Approx(first).epsilon(1e-12));
  CHECK(std::abs(deviation(2, "AB", "a", 0.3) - first) > 1e-6);
  CHECK(std::abs(deviation(1, "BA", "a", 0.3) - first) > 1e-6);
}

TEST_CASE("Shares that no cut can give are refused, with their deviations") {
  const auto make = [](double share, double sd) {
    return makeDivisionPolicy({.rules = {{.of = {"a"}, .share = share}}}, 1, {.share = sd});
  };
  CHECK_NOTHROW(make(0.1, 0));
  CHECK_NOTHROW(make(0.9, 0));
  CHECK_THROWS_AS(make(0.0999, 0), InputError);
  CHECK_THROWS_AS(make(0.9001, 0), InputError);
  CHECK_NOTHROW(make(0.25, 0.04));
  CHECK_THROWS_AS(make(0.2, 0.04), InputError);
  CHECK_THROWS_AS(make(0.5, 0.14), InputError);
  CHECK_THROWS_AS(makeDivisionPolicy({.rules = {{.of = {"a"}, .plane = along({0, 0, 0})}}}, 1), InputError);
}

TEST_CASE("A rule may be for one cell, for a clone, or for a generation, whatever they hold") {
  const auto clone = [](const char* path) {
    return CellSelection{.kind = CellSelection::Kind::clone, .path = CellPath::parse(path)};
  };
  const DivisionParameters division{
      .rules = {{.cells = {{.kind = CellSelection::Kind::cell, .path = CellPath::parse("AB")}}},
                {.of = {"skin"}, .cells = {clone("A")}},
                {.cells = {{.kind = CellSelection::Kind::generation, .generation = 1}}}}};
  const auto ruleOfCell = [&](const char* path, const char* substances) {
    const DivisionRule* rule = ruleFor(division, CellPath::parse(path), substances);
    return rule ? static_cast<int>(rule - division.rules.data()) + 1 : 0;
  };
  CHECK(ruleOfCell("AB", "skin") == 1);
  CHECK(ruleOfCell("AA", "skin") == 2);
  CHECK(ruleOfCell("A", "skin") == 2);
  CHECK(ruleOfCell("A", "nerve") == 3);
  CHECK(ruleOfCell("B", "skin") == 3);
  CHECK(ruleOfCell("BA", "skin") == 0);
}
