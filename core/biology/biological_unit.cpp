#include "biology/biological_unit.h"

#include "base/error.h"

namespace morula {

StateId BiologicalUnit::stateOf(const std::string&) {
  throw InputError("this biology cannot tell states by their descriptions; it needs a stateOf of its own");
}

}  // namespace morula
