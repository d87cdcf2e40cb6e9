#include "biology/logical_dna.h"

#include "catch.h"
#include "organism.h"
#include "thesis_dna.h"

using namespace morula;

using Cells = std::map<std::string, std::string>;
using Census = std::map<std::string, int>;

namespace {

CellContext inState(StateId state) {
  CellContext cell;
  cell.state = state;
  return cell;
}

}  // namespace

TEST_CASE("four unique cells [Nilsson 2008, 5.2.1], cycle by cycle") {
  Organism organism(uniqueFour);
  CHECK(organism.cells() == Cells{{"", "a0"}});
  organism.runCellCycle();
  CHECK(organism.cells() == Cells{{"A", "A a1 divide"}, {"B", "B a1 divide"}});
  organism.runCellCycle();
  CHECK(organism.cells() ==
        Cells{{"AA", "A a2 divide"}, {"AB", "B a2 divide"}, {"BA", "A a3 divide"}, {"BB", "B a3 divide"}});
  for (int cycle = 0; cycle < 5; ++cycle) {
    organism.runCellCycle();
    CHECK(organism.cells() == Cells{{"AA", "a4"}, {"AB", "a5"}, {"BA", "a6"}, {"BB", "a7"}});
  }
}

TEST_CASE("two equal subtrees [Nilsson 2008, 5.2.2], cycle by cycle") {
  Organism organism(equalSubtrees);
  organism.runCellCycle();
  organism.runCellCycle();
  CHECK(organism.cells() ==
        Cells{{"AA", "A a2 divide"}, {"AB", "B a2 divide"}, {"BA", "A a3 divide"}, {"BB", "B a3 divide"}});
  organism.runCellCycle();
  CHECK(organism.cells() ==
        Cells{{"AA", "a4"}, {"AB", "a5"}, {"BAA", "A a2 divide"}, {"BAB", "B a2 divide"}, {"BB", "a6"}});
  for (int cycle = 0; cycle < 5; ++cycle) {
    organism.runCellCycle();
    CHECK(organism.cells() == Cells{{"AA", "a4"}, {"AB", "a5"}, {"BAA", "a4"}, {"BAB", "a5"}, {"BB", "a6"}});
  }
}

TEST_CASE("a state is found by its description, whether or not it was met before") {
  const auto unit = makeLogicalDna(parseDna(uniqueFour, "test.dna"), {});
  CHECK(unit->stateOf("a0") == unit->startState());
  const StateId unmet = unit->stateOf("B a3 divide");
  CHECK(unit->describe(unmet) == "B a3 divide");
  CHECK(unit->stateOf("B a3 divide") == unmet);
  CHECK(unit->describe(unit->stateOf("")) == "");
  CHECK_THROWS_WITH(unit->stateOf("a0 b9"), ContainsSubstring("no substance 'b9'"));
  CHECK_THROWS_WITH(unit->stateOf("a3 a2"), ContainsSubstring("sorted"));
  CHECK_THROWS_WITH(unit->stateOf("a2 a2"), ContainsSubstring("once each"));
}

TEST_CASE("a substance that is not produced again is gone") {
  Organism organism("START: a0, rest\ng1(a1|a0)\ng2(a0|a1)\n");
  CHECK(organism.cells() == Cells{{"", "a0 rest"}});
  organism.runCellCycle();
  CHECK(organism.cells() == Cells{{"", "a1"}});
  organism.runCellCycle();
  CHECK(organism.cells() == Cells{{"", "a0"}});
}

TEST_CASE("genes see the state before the cycle, whatever their order") {
  for (const char* dna : {"START: a\ng1(b|a)\ng2(c|b)\n", "START: a\ng2(c|b)\ng1(b|a)\n"}) {
    Organism organism(dna);
    for (const char* expected : {"b", "c", "", ""}) {
      organism.runCellCycle();
      CHECK(organism.cells() == Cells{{"", expected}});
    }
  }
}

TEST_CASE("a gene needs all of its inputs, and one gene is enough for a product") {
  Organism all("START: a, b\ng1(both|a, b)\ng2(three|a, b, c)\ng3(a|a)\ng4(c|c)\n");
  all.runCellCycle();
  CHECK(all.cells() == Cells{{"", "a both"}});
  Organism either("START: b\ng1(x|a)\ng2(x|b)\ng3(a|a)\n");
  either.runCellCycle();
  CHECK(either.cells() == Cells{{"", "x"}});
}

TEST_CASE("divide is obeyed once for each time that it is produced") {
  Organism once("START: a\ng1(divide|a)\ng2(rest|a)\ng3(rest|rest)\n");
  for (int cycle = 0; cycle < 4; ++cycle) once.runCellCycle();
  CHECK(once.census() == Census{{"rest", 2}});
  Organism always("START: a\ng1(divide|a)\ng2(a|a)\n");
  for (int cycle = 0; cycle < 6; ++cycle) always.runCellCycle();
  CHECK(always.census() == Census{{"A a divide", 32}, {"B a divide", 32}});
}

TEST_CASE("a newborn cell holds its mother's divide and does not want to divide") {
  const auto unit = makeLogicalDna(parseDna("START: a\ng1(divide|a)\n", "f"), {});
  const StateId mother = unit->runCellCycle(inState(unit->startState()));
  CHECK(unit->wantsToDivide(inState(mother)));
  for (bool b : {false, true}) {
    const StateId daughter = unit->daughterState(mother, b);
    CHECK(unit->describe(daughter) == (b ? "B divide" : "A divide"));
    CHECK_FALSE(unit->wantsToDivide(inState(daughter)));
  }
}

TEST_CASE("a gene may read divide: daughters inherit it for one cycle") {
  Organism organism("START: a\ng1(divide|a)\ng2(seen|divide, A)\ng3(missed|divide, B)\n");
  organism.runCellCycle();
  organism.runCellCycle();
  CHECK(organism.cells() == Cells{{"A", "seen"}, {"B", "missed"}});
}

TEST_CASE("cells that die are gone, and a cell that is to die and to divide says both") {
  Organism organism("START: a\ng1(divide|a)\ng2(b|a)\ng3(die|b, A)\ng4(b|b)\n");
  organism.runCellCycle();
  organism.runCellCycle();
  CHECK(organism.cells() == Cells{{"B", "b"}});

  const auto unit = makeLogicalDna(parseDna("START: a\ng1(divide|a)\ng2(die|a)\n", "f"), {});
  const CellContext cell = inState(unit->runCellCycle(inState(unit->startState())));
  CHECK(unit->wantsToDie(cell));
  CHECK(unit->wantsToDivide(cell));
}

TEST_CASE("what a cell wants") {
  const auto unit = makeLogicalDna(parseDna("START: grow, a\n"
                                            "g1(grow|a)\ng2(connect|a)\ng3(b|a)\n"
                                            "g4(shrink|b)\ng5(release|b)\ng6(c|b)\n"
                                            "g7(shrink|c)\ng8(grow|c)\ng9(connect|c)\ng10(release|c)\n",
                                            "f"),
                                   {});
  const double growth[] = {1, 1, -1, 0, 0}, connecting[] = {0, 1, -1, 0, 0};
  StateId state = unit->startState();
  for (int cycle = 0; cycle < 5; ++cycle) {
    INFO(unit->describe(state));
    CHECK(unit->wantsToGrow(inState(state)) == growth[cycle]);
    CHECK(unit->wantsToConnect(inState(state)) == connecting[cycle]);
    CHECK_FALSE(unit->wantsToDivide(inState(state)));
    CHECK_FALSE(unit->wantsToDie(inState(state)));
    state = unit->runCellCycle(inState(state));
  }
}

TEST_CASE("the cycle's length is the shortest that a substance of the state asks for") {
  CycleParameters cycle;
  cycle.length = 2;
  cycle.perSubstance = {{"fast", 0.5}, {"slow", 8}};
  const auto unit = makeLogicalDna(parseDna("START: fast, slow\n"
                                            "g1(slow|fast)\ng2(a|fast)\ng3(b|slow, a)\ng4(b|b)\n",
                                            "f"),
                                   cycle);
  StateId state = unit->startState();
  for (double length : {0.5, 8.0, 2.0, 2.0}) {
    INFO(unit->describe(state));
    CHECK(unit->cycleLength(state) == length);
    CellContext cell = inState(state);
    cell.lastCycle = 4;
    cell.time = 4 + length;
    CHECK(unit->wantsToRunCellCycle(cell));
    cell.time = 4 + 0.875 * length;
    CHECK_FALSE(unit->wantsToRunCellCycle(cell));
    state = unit->runCellCycle(inState(state));
  }

  cycle.perSubstance = {{"fats", 1}};
  CHECK_THROWS_WITH(makeLogicalDna(parseDna("START: fast\n", "f"), cycle),
                    "cycle: the DNA has no substance 'fats'; did you mean 'fast'?");
}

TEST_CASE("equal states have equal ids") {
  const auto unit = makeLogicalDna(parseDna("START: a\ng1(b|a)\ng2(a|b)\n", "f"), {});
  const StateId a = unit->startState(), b = unit->runCellCycle(inState(a));
  CHECK(a != b);
  CHECK(unit->runCellCycle(inState(b)) == a);
  CHECK(unit->daughterState(a, true) != unit->daughterState(a, false));
  CHECK(unit->daughterState(a, true) == unit->daughterState(a, true));
  CHECK(unit->describe(unit->daughterState(a, true)) == "B a");
}

TEST_CASE("a repressor keeps its gene from being active") {
  // b and c alternate: each represses the other for one cycle.
  Organism organism("START: a, b\ng1(a|a)\ng2(b|a, !b)\ng3(c|a, !c, b)\n");
  std::vector<std::string> states;
  for (int cycle = 0; cycle < 4; ++cycle) {
    organism.runCellCycle();
    states.push_back(organism.cells().at(""));
  }
  CHECK(states == std::vector<std::string>{"a c", "a b", "a c", "a b"});
}
