#pragma once
// The facts of a run that a golden file records, as plain data: filling and testing them needs no simulation.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "biology/lineage.h"
#include "golden/golden.h"
#include "observation/measures.h"
#include "state/state_hash.h"

namespace morula {

struct GoldenFacts {
  std::string scenario;  // "thesis/unique-four"
  std::string scenarioHash;
  std::uint64_t seed = 0;
  std::uint64_t steps = 0;
  std::vector<LineageEntry> lineage;
  std::function<std::string(StateId)> describe;  // returns a state's substances
  std::vector<GoldenTimeStep> timeSteps;
  Hash stateHash;
  std::vector<GoldenCost> costs;
  std::vector<GoldenImage> images;
  std::vector<ChainLink> chain;
  bool mechanics = false;  // false: a lineage-only scene, without values
  WorldMeasures end;
  std::vector<CellMeasures> cells;     // at the end
  std::vector<WorldMeasures> samples;  // during the run
  std::vector<GoldenItem> tables;      // lines `column` and `row` of recorded tables [store/recorded_tables.h]
};

/// Max number of cells (ever born) whose lives are recorded one by one. Larger lineages are recorded as counts and
/// digests per generation.
inline constexpr std::size_t goldenLineageLimit = 4096;
/// Max number of living cells whose own values are recorded, beside the organism's.
inline constexpr std::size_t goldenCellLimit = 256;
/// Max number of recorded links of the chain of hashes: every first, second, fourth … link is kept so that no more
/// remain.
inline constexpr std::size_t goldenChainLimit = 64;

GoldenData makeGoldenData(const GoldenFacts& facts);

}  // namespace morula
