#pragma once
// A small run made by hand: the egg divides, A lives, B dies.
#include "golden/facts.h"

namespace morula {

inline LineageEntry cell(const char* path, double born, std::uint64_t bornStep, Fate fate, StateId state,
                         double ended = 0, std::uint64_t endedStep = 0) {
  return {CellPath::parse(path), born, ended, bornStep, endedStep, fate, state};
}

inline CellMeasures measures(const char* path, double volume) {
  CellMeasures m;
  m.path = CellPath::parse(path);
  m["volume"] = volume;
  m["area"] = 0.1 + 0.2;
  m["pressure"] = 0.40625;
  m["x"] = -0.0, m["y"] = 1e-17, m["z"] = -0.25;
  m["sphericity"] = 0.97;
  m["neighbours"] = 1;
  return m;
}

inline GoldenFacts exampleFacts() {
  GoldenFacts f;
  f.scenario = "thesis/example";
  f.scenarioHash = "0123456789abcdef0123456789abcdef";
  f.seed = 7;
  f.steps = 1024;
  f.lineage = {cell("", 0, 0, Fate::divided, 0, 1, 256), cell("A", 1, 256, Fate::alive, 1),
               cell("B", 1, 256, Fate::died, 2, 3, 768)};
  f.describe = [](StateId s) { return std::vector<std::string>{"START a0", "a4", ""}.at(s); };
  f.timeSteps = {{0, 0, 0.00390625}, {256, 1, 0.001953125}};
  f.stateHash = {0xabc, 0xdef};
  const CellPath egg, a = egg.daughter(false), b = egg.daughter(true);
  f.chain = {{0, {1, 1}, {{}, {}, {{egg, {0, 0x1001}}}, {}, {}}},
             {256, {2, 2}, {{}, {}, {{egg, {0, 0x1002}}}, {}, {}}},
             {512, {3, 3}, {{}, {}, {{a, {0, 0x1003}}, {b, {0, 0x1004}}}, {}, {}}}};
  f.images = {{"organism", "painter-1", {4, 4}}};
  f.costs = {{"list_builds", 5}};
  f.mechanics = true;
  f.end.time = 4;
  f.end.step = 1024;
  for (const auto& [name, value] : {std::pair("cells", 1.0),
                                    {"volume", 2},
                                    {"kinetic_energy", 1e-9},
                                    {"mean_pressure", 0.5},
                                    {"shell_fill", 0.5},
                                    {"outermost", 0.9}})
    f.end[name] = value;
  f.cells = {measures("A", 2)};
  WorldMeasures early = f.end;
  early.time = 0.5;
  early.step = 128;
  f.samples = {early, f.end};
  return f;
}

/// Returns data without measures that joined the table later, so that texts of the example stay as they are.
inline GoldenData dataOf(const GoldenFacts& facts) {
  GoldenData data = makeGoldenData(facts);
  const std::string known =
      " cells volume kinetic_energy mean_pressure shell_fill outermost area pressure x y z sphericity neighbours ";
  std::erase_if(data.items, [&](const GoldenItem& i) {
    const auto* value = std::get_if<GoldenValue>(&i);
    return value && known.find(' ' + value->name.measure + ' ') == known.npos;
  });
  return data;
}

inline GoldenData exampleData() { return dataOf(exampleFacts()); }

inline Golden exampleGolden(std::vector<ToleranceRule> rules = {}) {
  return {exampleData(), "A. Tester", "first result", std::move(rules), "example.golden"};
}

/// Returns the golden after it was written and read.
inline Golden reread(const Golden& golden) { return readGolden(writeGolden(golden), golden.file); }

/// Returns a golden's text with `line` replaced by `other`.
inline std::string with(std::string text, const std::string& line, const std::string& other) {
  return text.replace(text.find(line), line.size(), other);
}

inline ToleranceRule rule(const std::string& text) { return readRule("tolerance " + text, "rule"); }

}  // namespace morula
