#pragma once
// A share of a study's tasks, for one machine of several.
#include <cstddef>
#include <string>
#include <vector>

namespace morula {

/// The tasks number, number + of, number + 2·of, … of the plan, counted from 1. The plan alone decides, so machines need not
/// communicate. Consecutive tasks, which belong to one condition and cost about the same, are in different shards.
struct Shard {
  std::size_t number = 1, of = 1;  // number: from 1
};

/// "3/40". Throws InputError.
Shard parseShard(const std::string& text);

/// Of tasks 0 to count − 1, rising.
std::vector<std::size_t> tasksOf(const Shard& shard, std::size_t count);

}  // namespace morula
