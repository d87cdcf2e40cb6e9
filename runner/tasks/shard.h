#pragma once
// A share of a study's tasks, for one machine of several.
#include <cstddef>
#include <string>
#include <vector>

namespace morula {

/// Every `of`-th task, from the `number`-th on. It depends on the plan's tasks alone, so that machines that know nothing of
/// each other share them out alike; neighbours in the plan are of one condition, and go to different shares.
struct Shard {
  std::size_t number = 1, of = 1;  // number: from 1
};

/// "3/40". Throws UsageError that names `option`.
Shard parseShard(const std::string& option, const std::string& text);

/// Of tasks 0 to count − 1, rising.
std::vector<std::size_t> tasksOf(const Shard& shard, std::size_t count);

}  // namespace morula
