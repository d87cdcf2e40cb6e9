// Perceptions of cells, worked out by hand, and their effect on genes.
#include "biology/sense.h"

#include <cmath>
#include <limits>

#include "biology/logical_dna.h"
#include "biology/physical_unit.h"
#include "catch.h"

using namespace morula;

namespace {

/// A cell that knows only what a test gives.
struct KnownCell final : CellContext, PhysicalUnit {
  const PhysicalUnit* physical() const override { return hasBody ? this : nullptr; }
  std::span<const Neighbour> neighbours() const override { return touching; }
  std::span<const CellContext* const> connected() const override { return connectedTo; }
  std::span<const OtherCell> otherCells() const override { return others; }
  const CellContext* sister() const override { return itsSister; }
  double shellShare() const override { return onShell; }
  double elongation() const override { return length; }
  double size() const override { return ownSize; }
  double sizeAtBirth() const override { return bornWith; }

  double getMass() const override { return 1; }
  double getVolume() const override { return volume; }
  double getPressure() const override { return pressure; }
  double getRestVolume() const override { return 4; }
  double getMeshVolume() const override { return 5; }
  const BodyShape& getShape() const override { return shape; }

  std::vector<Neighbour> touching;
  std::vector<const CellContext*> connectedTo;
  std::vector<OtherCell> others;
  const CellContext* itsSister = nullptr;
  double onShell = 0, length = 1, volume = 4, pressure = 0, ownSize = 1, bornWith = 1;
  BodyShape shape{};
  bool hasBody = true;
};

/// Returns true for cells of state 1.
bool counts(const CellContext& cell) { return cell.state == 1; }

double measured(SenseKind kind, const CellContext& cell, SenseParameters sense = {}) {
  sense.kind = kind;
  return kindOf(kind).measure(cell, sense, counts);
}

bool senses(SenseKind kind, const CellContext& cell, SenseParameters sense = {}) {
  sense.kind = kind;
  return isSensed(sense, cell, counts, false);
}

SenseParameters about(const char* of, std::optional<double> number = {}) {
  SenseParameters sense;
  sense.of = of;
  sense.number = number;
  return sense;
}

Dna dnaThatSenses(const std::string& text, std::set<std::string> sensed) {
  DnaSurroundings around;
  around.sensed = std::move(sensed);
  return parseDna(text, "test.dna", 1, 1, "", &around);
}

SenseParameters sensing(const char* substance, SenseKind kind, Threshold is, const char* of = "") {
  SenseParameters sense{substance, kind};
  sense.is = is;
  sense.of = of;
  return sense;
}

}  // namespace

TEST_CASE("Each kind of sense has one row, one name and one measure") {
  std::vector<std::string> names;
  for (const SenseKindRow* row : senseKinds()) {
    CHECK(&kindOf(row->kind) == row);
    CHECK(row->measure);
    CHECK(std::count(names.begin(), names.end(), row->name) == 0);
    names.push_back(row->name);
  }
  CHECK(names.size() == std::size_t(SenseKind::sister) + 1);
}

TEST_CASE("A cell perceives its body: volume over rest, pressure, age, elongation, shell, position") {
  KnownCell cell;
  cell.volume = 3, cell.pressure = 2.5, cell.length = 1.75, cell.onShell = 0.25;
  cell.time = 7, cell.born = 5;
  cell.shape.centre = {1, 2, 2};
  CHECK(measured(SenseKind::volume, cell) == 0.75);
  CHECK(measured(SenseKind::pressure, cell) == 2.5);
  CHECK(measured(SenseKind::age, cell) == 2);
  CHECK(measured(SenseKind::elongation, cell) == 1.75);
  CHECK(measured(SenseKind::shell, cell) == 0.25);
  SenseParameters along;
  along.axis = {0, 3, 4};  // of length 5: (6 + 8)/5
  CHECK(measured(SenseKind::position, cell, along) == Approx(2.8));
  along.axis = {0, -0.3, -0.4};
  CHECK(measured(SenseKind::position, cell, along) == Approx(-2.8));
}

TEST_CASE("A cell perceives its neighbours: how many, over which area, and who has most of it") {
  KnownCell one, two, other, cell;
  one.state = two.state = 1, other.state = 0;
  CHECK(measured(SenseKind::contact, cell) == -1);
  CHECK(measured(SenseKind::majority, cell) == 0);
  cell.touching = {{&one, 0.2}, {&other, 0.5}, {&two, 0.3}};
  CHECK(measured(SenseKind::neighbours, cell) == 2);
  CHECK(measured(SenseKind::contact, cell) == 0.3);
  CHECK(measured(SenseKind::majority, cell) == 0.5);
  CHECK(senses(SenseKind::contact, cell, about("x")));
  CHECK(senses(SenseKind::contact, cell, about("x", 0.3)));
  CHECK_FALSE(senses(SenseKind::contact, cell, about("x", 0.31)));
  CHECK_FALSE(senses(SenseKind::majority, cell, about("x")));  // half is no majority
  cell.touching[2].area = 0.31;
  CHECK(senses(SenseKind::majority, cell, about("x")));
  cell.touching = {{&other, 0.5}};
  CHECK_FALSE(senses(SenseKind::contact, cell, about("x")));
}

TEST_CASE("A cell perceives its sister and those that it is connected to") {
  KnownCell one, other, cell;
  one.state = 1, other.state = 0;
  SenseParameters lives, gone;
  gone.lives = false;
  cell.path = CellPath::parse("A");
  CHECK_FALSE(senses(SenseKind::sister, cell, lives));
  CHECK(senses(SenseKind::sister, cell, gone));
  CHECK_FALSE(senses(SenseKind::sister, cell, about("x")));
  cell.itsSister = &other;
  CHECK(senses(SenseKind::sister, cell, lives));
  CHECK_FALSE(senses(SenseKind::sister, cell, gone));
  CHECK_FALSE(senses(SenseKind::sister, cell, about("x")));
  cell.itsSister = &one;
  CHECK(senses(SenseKind::sister, cell, about("x")));
  // An egg has no sister to lose.
  CHECK_FALSE(senses(SenseKind::sister, KnownCell{}, gone));
  // Senses of a sister's life work without bodies; senses of bodies are off.
  KnownCell without = cell;
  without.hasBody = false;
  CHECK(senses(SenseKind::sister, without, about("x")));
  without.connectedTo = {&one};
  CHECK(senses(SenseKind::neighbours, without) == false);
  CHECK_FALSE(senses(SenseKind::connected, cell));
  cell.connectedTo = {&other};
  CHECK_FALSE(senses(SenseKind::connected, cell));
  cell.connectedTo = {&other, &one};
  CHECK(senses(SenseKind::connected, cell));
}

TEST_CASE("A cell perceives others from afar: the nearest, and what they release") {
  KnownCell one, two, other, cell;
  one.state = two.state = 1, other.state = 0;
  CHECK(measured(SenseKind::near, cell) == std::numeric_limits<double>::infinity());
  CHECK(measured(SenseKind::diffusion, cell, about("x", 2)) == 0);
  for (const SenseKind kind : {SenseKind::near, SenseKind::diffusion}) {  // both kinds need a pattern and a number
    CHECK(kindOf(kind).of.required);
    CHECK(kindOf(kind).number.required);
  }
  CHECK(kindOf(SenseKind::diffusion).least <= 0.);  // 0, the least value, may be a threshold
  cell.others = {{&one, 3}, {&other, 0.5}, {&two, 1.5}};
  CHECK(measured(SenseKind::near, cell) == 1.5);
  CHECK(senses(SenseKind::near, cell, about("x", 1.5)));
  CHECK_FALSE(senses(SenseKind::near, cell, about("x", 1.49)));
  const double expected = std::exp(-3 / 2.0) / 3 + std::exp(-1.5 / 2) / 1.5;
  CHECK(measured(SenseKind::diffusion, cell, about("x", 2)) == Approx(expected).epsilon(1e-14));
  cell.others = {{&one, 0}};
  CHECK(measured(SenseKind::diffusion, cell, about("x", 2)) == std::numeric_limits<double>::infinity());
}

TEST_CASE("What is released solves the equation of diffusion and decay around a point") {
  // Differences of second order test c'' + 2 c'/r = c/range².
  KnownCell one, cell;
  one.state = 1;
  const auto c = [&](double r) {
    cell.others = {{&one, r}};
    return measured(SenseKind::diffusion, cell, about("x", 1.5));
  };
  const double h = 1e-3;
  for (double r : {0.5, 1.0, 2.0, 5.0}) {
    const double first = (c(r + h) - c(r - h)) / (2 * h), second = (c(r + h) - 2 * c(r) + c(r - h)) / (h * h);
    CHECK(second + 2 * first / r == Approx(c(r) / (1.5 * 1.5)).epsilon(1e-4));
  }
}

TEST_CASE("A threshold holds on its side, at itself where it says so, and until the other one is passed") {
  CHECK(holds({.below = 1}, 0.9, false));
  CHECK_FALSE(holds({.below = 1}, 1, false));
  CHECK(holds({.atMost = 1}, 1, false));
  CHECK_FALSE(holds({.atMost = 1}, 1.1, false));
  CHECK(holds({.above = 1}, 1.1, false));
  CHECK_FALSE(holds({.above = 1}, 1, false));
  CHECK(holds({.atLeast = 1}, 1, false));
  CHECK_FALSE(holds({.atLeast = 1}, 0.9, false));
  const Threshold band{.below = 2, .above = 1};
  CHECK(holds(band, 1.5, false));
  CHECK_FALSE(holds(band, 2, true));
  CHECK_FALSE(holds(band, 1, true));
  const Threshold lower{.below = 0.9, .until = 0.95}, upper{.atLeast = 5, .until = 4};
  CHECK_FALSE(holds(lower, 0.92, false));
  CHECK(holds(lower, 0.92, true));
  CHECK(holds(lower, 0.95, true));
  CHECK_FALSE(holds(lower, 0.951, true));
  CHECK_FALSE(holds(upper, 4, false));
  CHECK(holds(upper, 4, true));
  CHECK_FALSE(holds(upper, 3, true));
}

TEST_CASE("Genes run on what is sensed now, not on what was; the next state shows it") {
  const std::vector<SenseParameters> all{sensing("pressed", SenseKind::volume, {.below = 0.9})};
  const auto unit = makeLogicalDna(
      dnaThatSenses("START: a\ng1(a|a)\ng2(flat|a, pressed)\ng3(round|a, !pressed)\n", {"pressed"}), {}, all);
  KnownCell cell;
  const auto run = [&](double volume) {
    cell.volume = volume * 4;
    cell.state = unit->runCellCycle(cell);
    return unit->describe(cell.state);
  };
  cell.state = unit->startState();
  CHECK(run(1) == "a round");
  CHECK(run(0.8) == "a flat pressed");
  CHECK(run(0.8) == "a flat pressed");
  CHECK(run(1) == "a round");
  // Both daughters inherit their mother's senses and forget them with their own first cycle.
  run(0.8);
  cell.state = unit->daughterState(cell.state, true);
  CHECK(unit->describe(cell.state) == "B a flat pressed");
  CHECK(run(1) == "a round");
}

TEST_CASE("What was sensed goes on being sensed until the number has passed the other bound; daughters too") {
  const std::vector<SenseParameters> all{sensing("pressed", SenseKind::volume, {.below = 0.9, .until = 0.95})};
  const auto unit = makeLogicalDna(dnaThatSenses("START: a\ng1(a|a)\ng2(b|pressed)\n", {"pressed"}), {}, all);
  KnownCell cell;
  cell.state = unit->startState();
  std::string seen;
  for (double volume : {0.92, 0.89, 0.92, 0.95, 0.96, 0.92}) {
    cell.volume = 4 * volume;
    cell.state = unit->runCellCycle(cell);
    seen += unit->describe(cell.state) + ";";
  }
  CHECK(seen == "a;a b pressed;a b pressed;a b pressed;a;a;");
  cell.state = unit->daughterState(unit->stateOf("a pressed"), false);
  cell.volume = 4 * 0.92;
  CHECK(unit->describe(unit->runCellCycle(cell)) == "a b pressed");
}

TEST_CASE("Cells count that hold a substance, or one with a beginning, as their states are now") {
  const std::vector<SenseParameters> all{sensing("many", SenseKind::neighbours, {.atLeast = 1}, "AB*"),
                                         sensing("one", SenseKind::neighbours, {.atLeast = 1}, "AB"),
                                         sensing("any", SenseKind::neighbours, {.atLeast = 1})};
  const auto unit =
      makeLogicalDna(dnaThatSenses("START: a, AB, ABa, B2\ng1(a|a)\ng2(x|many, one, any)\ng3(x|AB, ABa, B2)\n",
                                   {"many", "one", "any"}),
                     {}, all);
  KnownCell cell, other;
  cell.state = unit->startState();
  cell.touching = {{&other, 1}};
  const auto sensed = [&](const char* state) {
    other.state = unit->stateOf(state);
    return unit->describe(unit->runCellCycle(cell));
  };
  CHECK(sensed("AB") == "a any many one x");
  CHECK(sensed("ABa") == "a any many x");
  CHECK(sensed("B2") == "a any x");
  cell.touching.clear();
  CHECK(sensed("AB") == "a x");
}

TEST_CASE("A DNA without senses never looks; one that reads no such substance is refused; 64 senses are the most") {
  struct Blind final : CellContext {
    std::span<const Neighbour> neighbours() const override { throw std::runtime_error("looked"); }
  } blind;
  const auto unit = makeLogicalDna(parseDna("START: a\ng1(b|a)\n", "f"), {});
  CHECK(unit->describe(unit->runCellCycle(blind)) == "b");
  const Dna dna = parseDna("START: a\ng1(b|a)\n", "f");
  const std::vector<SenseParameters> one{sensing("touched", SenseKind::neighbours, {.atLeast = 1})};
  CHECK_THROWS_WITH(makeLogicalDna(dna, {}, one),
                    "senses: no gene reads 'touched'; write a gene that reads it, or remove this");
  const std::vector<SenseParameters> most(64, sensing("a", SenseKind::age, {.above = 1})), more(65, most[0]);
  CHECK_NOTHROW(makeLogicalDna(dna, {}, most));
  CHECK_THROWS_WITH(makeLogicalDna(dna, {}, more), "senses: 65 of them; give at most 64");
}

TEST_CASE("A newborn's first cycle is as long as what she becomes says; later ones are as long as ever") {
  CycleParameters cycle;
  cycle.length = 2;
  cycle.perSubstance = {{"egg", 8}};
  cycle.atBirth = {{"AB", 3.5}, {"P*", 4}, {"P1x", 3}};
  const auto unit = makeLogicalDna(
      parseDna("START: egg\ng1(AB|egg, A)\ng2(P1|egg, B)\ng3(AB|AB)\ng4(P1x|P1, B)\ng5(x|egg)\n", "f"), cycle);
  const auto length = [&](const char* state) { return unit->cycleLength(unit->stateOf(state)); };
  CHECK(length("egg") == 8);
  CHECK(length("A egg") == 3.5);
  CHECK(length("B egg") == 4);
  CHECK(length("B P1") == 3);  // the shorter of two lengths that fit
  CHECK(length("AB") == 2);    // not a newborn
  CHECK(length("A AB") == 3.5);
  CHECK(length("A x") == 2);
  CHECK(length("A P1 egg") == 3.5);
}

TEST_CASE("A cell that would divide waits for its size, or for what it is to gain; others do not") {
  const Dna dna = parseDna("START: a, b\ng1(divide|a)\ng2(a|b)\n", "f");
  CycleParameters cycle;
  KnownCell cell;
  cell.time = 1, cell.ownSize = 0.75, cell.bornWith = 0.5;
  const auto waits = [&](DivisionSize::Rule rule, double size) {
    cycle.divisionSize = DivisionSize{rule, size};
    const auto unit = makeLogicalDna(dna, cycle);
    cell.state = unit->stateOf("b");
    CHECK(unit->wantsToRunCellCycle(cell) == (cell.time >= 1));
    cell.state = unit->startState();
    return !unit->wantsToRunCellCycle(cell);
  };
  CHECK(waits(DivisionSize::Rule::sizer, 0.8));
  CHECK_FALSE(waits(DivisionSize::Rule::sizer, 0.75));
  CHECK(waits(DivisionSize::Rule::adder, 0.26));
  CHECK_FALSE(waits(DivisionSize::Rule::adder, 0.25));
  cell.time = 0.99;
  CHECK(waits(DivisionSize::Rule::sizer, 0.1));  // the cell's time has not come
}
