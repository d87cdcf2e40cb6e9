#pragma once
// The old form of the lines `error`, with one number for the time step and one for the mesh: the largest of at most 16
// times. Goldens that earlier programs wrote are read with it, and keep it until their errors are measured again
// (`morula review SCENARIO --into-golden`); the digest that seals a golden holds these lines as they stand.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/members.h"

namespace morula {

struct Golden;
struct GoldenError;

/// A line `error` of the old form.
struct OldGoldenError {
  static constexpr const char *kind = "error", *check = "stated";
  std::string quantity;
  double time = 0, until = 0;       // error of time step and single precision; last comparison [time]
  std::optional<double> mesh;       // error of the mesh; 0 for spheres; absent: not known
  std::optional<double> meshUntil;  // [time]
  int line = 0;
};
MORULA_MEMBERS(OldGoldenError, quantity, time, until, mesh, meshUntil, line)

/// Returns true if the fields after `error` have the old form, which has five of them.
bool isOldError(std::string_view fields);
/// Returns the errors that a golden states, in their order. Errors of the old form have no error at rest.
std::vector<GoldenError> errorsOf(const Golden& golden);
/// Returns true if the golden states errors of the old form.
bool hasOldErrors(const Golden& golden);
/// Tells readers what is known of errors of the old form.
inline constexpr const char* oldErrorNote = "only one number is known, the largest of at most 16 times";

}  // namespace morula
