#pragma once
// Two records of runs side by side, item by item.
#include <string>
#include <vector>

#include "store/records.h"

namespace morula {

struct Item {
  std::string name, label;  // of the column; for people
  std::string before, now;
};

/// What makes a run_id: scenario, seed and what the program was built from.
std::vector<Item> compareIdentity(const RunRecord& before, const RunRecord& now);

/// That, and everything else that is known of how and where the two were run.
std::vector<Item> compareConditions(const RunRecord& before, const RunRecord& now);

}  // namespace morula
