#include "base/choice.h"

#include "base/did_you_mean.h"
#include "base/error.h"

namespace morula {

void refuseName(std::string_view word, const std::vector<std::string>& names) {
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "" : &name == &names.back() ? " or " : ", ") + name;
  const std::string near = closest(word, names);
  throw InputError("'" + std::string(word) + "' is not known; needs " + list +
                   (near.empty() ? "" : "; did you mean " + near + "?"));
}

}  // namespace morula
