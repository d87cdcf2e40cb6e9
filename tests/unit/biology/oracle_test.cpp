// The compiled DNA against the thesis' procedure: a walk over the list of genes that looks up every input in the cell's
// state.
#include <algorithm>
#include <set>

#include "base/random.h"
#include "catch.h"
#include "organism.h"

using namespace morula;

namespace {

struct PlainGene {
  std::string product;
  std::vector<std::string> inputs, repressors;
};

using PlainState = std::set<std::string>;

PlainState walk(const std::vector<PlainGene>& genes, const PlainState& state) {
  PlainState next;
  for (const PlainGene& gene : genes)
    if (std::ranges::all_of(gene.inputs, [&](const std::string& input) { return state.contains(input); }) &&
        std::ranges::none_of(gene.repressors, [&](const std::string& name) { return state.contains(name); }))
      next.insert(gene.product);
  return next;
}

std::string joined(const PlainState& state) {
  std::string text;
  for (const std::string& substance : state) text += (text.empty() ? "" : " ") + substance;
  return text;
}

/// A stream of small random numbers, with one stream for each case.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) { draw_.seed = seed; }
  unsigned below(unsigned n) { return randomWords(draw_, number_++)[0] % n; }

 private:
  Draw draw_;
  std::uint32_t number_ = 0;
};

struct Case {
  std::string text;
  PlainState start;
  std::vector<PlainGene> genes;
};

/// Returns a random DNA with few substances, so that they meet: most cells go on, some divide, some die.
Case randomCase(std::uint64_t seed) {
  Dice dice(seed);
  Case c;
  const unsigned substances = 3 + dice.below(10), genes = 4 + dice.below(40);
  const auto name = [](unsigned i) { return std::string("s").append(std::to_string(i)); };
  const auto any = [&] { return name(dice.below(substances)); };
  for (unsigned i = 0; i < substances; ++i) c.start.insert(name(i));  // makes every substance known
  std::set<std::pair<std::string, std::set<std::string>>> written;
  c.text = "START: ";
  for (const std::string& s : c.start) c.text += (c.text.back() == ' ' ? "" : ", ") + s;
  for (unsigned i = 0; i < genes; ++i) {
    const unsigned kind = dice.below(20);
    const std::string product = kind < 3 ? "divide" : kind == 3 ? "die" : kind == 4 ? "grow" : any();
    std::set<std::string> inputs;
    for (unsigned n = 1 + dice.below(3); n > 0; --n) inputs.insert(any());
    if (kind == 3) inputs.insert("A"), inputs.insert(any()), inputs.insert(any());  // death is rare
    if (const unsigned asymmetry = dice.below(4); asymmetry < 2 && kind != 3) inputs.insert(asymmetry ? "A" : "B");
    std::set<std::string> repressors;
    for (unsigned n = dice.below(6) / 3 * dice.below(3); n > 0; --n) {
      const std::string repressor = dice.below(8) ? any() : dice.below(2) ? "A" : "B";
      if (!inputs.contains(repressor)) repressors.insert(repressor);
    }
    std::set<std::string> content = inputs;
    for (const std::string& repressor : repressors) content.insert("!" + repressor);
    if (!written.insert({product, content}).second) continue;
    c.genes.push_back({product, {inputs.begin(), inputs.end()}, {repressors.begin(), repressors.end()}});
    std::string line = "\ng";
    line += std::to_string(i) + "(" + product + "|";
    for (const std::string& input : inputs) line += (line.back() == '|' ? "" : ",") + input;
    for (const std::string& repressor : repressors) line += ", !" + repressor;
    c.text += line + ")";
  }
  return c;
}

}  // namespace

TEST_CASE("random DNAs do what a plain walk over their genes does") {
  int divisions = 0, deaths = 0, distinct = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Case c = randomCase(seed);
    INFO("seed " << seed << "\n" << c.text);
    Organism organism(c.text);
    std::map<std::string, PlainState> plain = {{"", c.start}};
    std::set<std::string> states;
    for (int cycle = 0; cycle < 30 && !plain.empty() && plain.size() < 100; ++cycle) {
      organism.runCellCycle();
      std::map<std::string, PlainState> next;
      for (const auto& [path, state] : plain) {
        PlainState after = walk(c.genes, state);
        if (after.contains("die")) {
          ++deaths;
        } else if (after.contains("divide")) {
          ++divisions;
          for (const char* letter : {"A", "B"}) {
            PlainState daughter = after;
            daughter.insert(letter);
            next[path + letter] = daughter;
          }
        } else {
          next[path] = after;
        }
      }
      plain = std::move(next);
      std::map<std::string, std::string> expected;
      for (const auto& [path, state] : plain) states.insert(expected[path] = joined(state));
      REQUIRE(organism.cells() == expected);
    }
    distinct += static_cast<int>(states.size());
  }
  // Everything that can happen must have happened often.
  CHECK(divisions > 1000);
  CHECK(deaths > 100);
  CHECK(distinct > 1000);
}
