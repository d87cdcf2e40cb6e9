#pragma once
// The parameters of cycles and senses, as a scenario gives them.
#include <array>
#include <map>
#include <optional>
#include <string>

#include "base/choice.h"
#include "base/members.h"
#include "base/vec3.h"

namespace morula {

/// The size at which a cell may divide: its volume at rest over the egg's.
struct DivisionSize {
  enum class Rule { sizer, adder };  // the number is part of what a scenario means
  Rule rule = Rule::sizer;           // the size itself, or the gain since the cell's birth
  double size = 1;                   // [1]
};
MORULA_MEMBERS(DivisionSize, rule, size)

/// When the genes of a daughter are first read.
enum class FirstCycle { afterLength, atBirth };
template <>
inline constexpr auto choices<FirstCycle> = std::to_array<Choice<FirstCycle>>(
    {{FirstCycle::afterLength, "after-length", "a daughter holds her mother's substances until her first cycle is due"},
     {FirstCycle::atBirth, "at-birth",
      "a daughter's genes are read when she is born, so she holds her own substances while she lives; what she then "
      "wishes counts from her next cycle on"}});

struct CycleParameters {
  double length = 1;  // [time] between cell cycles
  // [time] Lengths for cells that hold the substance, or one with this beginning before '*'; the shortest wins.
  std::map<std::string, double> perSubstance;
  // [time] Lengths from birth to the first cycle, for a newborn whose genes will make this substance (or one with this
  // beginning before '*'). The shortest wins, and goes before perSubstance.
  std::map<std::string, double> atBirth;
  std::optional<DivisionSize> divisionSize;  // absent: cells divide when it is time, whatever their size
  FirstCycle first = FirstCycle::afterLength;
};
MORULA_MEMBERS(CycleParameters, length, perSubstance, atBirth, divisionSize, first)

enum class SenseKind {  // the number is part of what a scenario means: new kinds stand last
  volume,
  pressure,
  age,
  elongation,
  shell,
  position,
  neighbours,
  contact,
  majority,
  near,
  diffusion,
  connected,
  sister,
};

/// A condition on a measured number; all bounds that are given must hold.
struct Threshold {
  std::optional<double> below = {}, above = {}, atMost = {}, atLeast = {};
  // Hysteresis, beside another bound: once the condition holds, it goes on until the number has passed this bound, too.
  std::optional<double> until = {};
};
MORULA_MEMBERS(Threshold, below, above, atMost, atLeast, until)

/// One thing that cells perceive. At a cell's cycle the simulator inserts the substance if the condition holds, and
/// takes it away if not, as it inserts A and B. sense.h says what each kind measures and which members it has.
struct SenseParameters {
  std::string substance = {};  // the inserted substance
  SenseKind kind = SenseKind::volume;
  Threshold is = {};    // for kinds that compare a number
  std::string of = {};  // a substance of the cells that count, or its beginning before '*'; "": all count
  std::optional<double> number = {};  // the contact's area [length²], a distance or a range [length]
  Vector axis{1, 0, 0};               // for `position`; any length but 0
  bool lives = true;                  // for `sister`, where `of` is "": whether she must live
};
MORULA_MEMBERS(SenseParameters, substance, kind, is, of, number, axis, lives)

}  // namespace morula
