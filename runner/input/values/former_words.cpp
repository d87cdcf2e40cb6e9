#include "values/former_words.h"

#include <algorithm>

namespace morula::scenario {
namespace {

constexpr FormerWord formerWords[] = {
    {"physics.contact.friction", "", "physics.contact.viscosity",
     "at the slip speeds of cells it is a damper, and not Coulomb's friction",
     "write the new key, with the value as it is"},
    {"physics.integrator", "fire", "quasi-static",
     "cells settle by a number of evaluations in proportion to time, and not to a tolerance",
     "write quasi-static, and physics.quasi-static.residual if the end of the run shall be at rest"},
    {"physics.settle", "", "physics.quasi-static",
     "cells settle by a number of evaluations in proportion to time, and not to a tolerance",
     "remove this; physics.quasi-static has evaluations, drag, together and, for the end of the run, residual"},
};

}  // namespace

const FormerWord* formerKey(std::string_view path) { return formerValue(path, ""); }

const FormerWord* formerValue(std::string_view path, std::string_view value) {
  const auto found =
      std::ranges::find_if(formerWords, [&](const FormerWord& w) { return w.path == path && w.value == value; });
  return found == std::end(formerWords) ? nullptr : found;
}

}  // namespace morula::scenario
