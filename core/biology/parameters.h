#pragma once
// What a scenario may say about the pace of biology.
#include <map>
#include <string>

namespace morula {

struct CycleParameters {
  double length = 1;                           // [time] between cell cycles
  std::map<std::string, double> perSubstance;  // [time] for cells that hold the substance; the shortest wins
};

}  // namespace morula
