#pragma once
// A run in a database: the hashes of its states, without the states themselves.
#include <string>
#include <vector>

#include "explain/run_source.h"

namespace morula {

class StoredRunSource : public RunSource {
 public:
  /// `chain` as the database has it, `steps` and `failure` as the run ended.
  StoredRunSource(std::string name, std::vector<ChainLink> chain, std::uint64_t steps, std::string failure);
  std::string name() const override { return name_; }
  /// Of the steps asked for, those that are stored.
  HashTrace hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) override;
  std::unique_ptr<World> stateAt(std::uint64_t) override;

 private:
  std::string name_, failure_;
  std::vector<ChainLink> chain_;
  std::uint64_t steps_;
};

/// What is wrong with a stored chain in itself: a row lost, put in or edited. Each link's hash must follow from its
/// state and the link before, each state's from its parts. "" if all holds. `step`: of the first bad link.
std::string findBrokenLink(const std::vector<ChainLink>& chain, std::uint64_t& step);

}  // namespace morula
