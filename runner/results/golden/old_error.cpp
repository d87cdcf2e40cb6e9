#include "golden/old_error.h"

#include <algorithm>

#include "golden/golden.h"

namespace morula {

bool isOldError(std::string_view fields) { return std::ranges::count(fields, ' ') == 4; }

std::vector<GoldenError> errorsOf(const Golden& golden) {
  std::vector<GoldenError> errors;
  for (const GoldenItem& item : golden.stated) {
    if (const auto* error = std::get_if<GoldenError>(&item)) errors.push_back(*error);
    if (const auto* old = std::get_if<OldGoldenError>(&item))
      errors.push_back({old->quantity, {}, old->time, old->until, {}, old->mesh, old->meshUntil});
  }
  return errors;
}

bool hasOldErrors(const Golden& golden) { return !all<OldGoldenError>(golden.stated).empty(); }

}  // namespace morula
