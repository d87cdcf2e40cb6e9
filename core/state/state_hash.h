#pragma once
// The whole state as one number, and as one number for each of its parts.
#include <cstdint>
#include <optional>
#include <vector>

#include "base/cell_path.h"
#include "base/hash.h"

namespace morula {

struct World;

struct CellHash {
  CellPath path;
  Hash hash;
  friend bool operator==(const CellHash&, const CellHash&) = default;
};

/// The hashes of a state. Equal bits give equal hashes, on every machine; which part differs tells where two runs part.
struct StateHashes {
  Hash whole;  // over all parts
  Hash clock;
  std::vector<CellHash> cells;  // the living ones by lineage path, each with its biology and its body
  Hash connections;             // all that ever were; zero where nothing connects
  Hash lineage;
  friend bool operator==(const StateHashes&, const StateHashes&) = default;
};

/// Returns the hash over all parts, from the hashes of the parts.
Hash hashWhole(const StateHashes& parts);
/// Hashes a state. Throws BugError for a NaN, which is a failed run and not a hash.
StateHashes hashState(const World& world);
inline Hash stateHash(const World& world) { return hashState(world).whole; }

/// One link of a chain of hashes over the states of a run. It depends on its own state and, through the link
/// before, on all earlier ones, so a chain of which only some links are kept still shows any difference.
struct ChainLink {
  std::uint64_t step = 0;
  Hash hash;  // over the link before, the step and the state
  StateHashes state;
  friend bool operator==(const ChainLink&, const ChainLink&) = default;
};

/// Returns the hash that a link must have; `before` is empty for the first link.
Hash hashLink(const std::optional<Hash>& before, std::uint64_t step, const Hash& state);
/// Returns the next link. Throws as hashState does.
ChainLink nextLink(const std::optional<Hash>& before, const World& world);

}  // namespace morula
