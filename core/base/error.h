#pragma once
// The four kinds of failure, one type each; the runner turns them into exit codes 3, 4, 6 and 70.
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace morula {

/// The resource that ran out, if any. Such an error depends on the machine or on the program, not on the scene, so a
/// run that ended by it is compared with nothing.
enum class Want {
  nothing,
  memory,
  files,  // a disk or a file that could be written
  reason  // the program has a bug
};

/// The user's input is wrong. The text names the place, what is wrong and what would be right. Exit 3.
struct InputError : std::runtime_error {
  explicit InputError(const std::string& what, Want missing = Want::nothing, std::string at = {})
      : std::runtime_error(what), want(missing), key(std::move(at)) {}
  /// The value of a parameter is wrong. The text is the key, followed by `what`.
  static InputError at(const std::string& key, const std::string& what) { return InputError(key + what, {}, key); }
  Want want;
  std::string key;  // the scenario's key with the wrong value, as "physics.time_step"; "" if it is of no one key
};

/// The physics cannot go on. Names cell, step, quantity and the parameter to change. Exit 4.
struct NumericalError : std::runtime_error {
  NumericalError(std::string cell, std::uint64_t step, std::string quantity, std::string remedy,
                 Want want = Want::nothing);
  /// A failure of no one cell.
  NumericalError(std::uint64_t step, std::string quantity, std::string remedy, Want want = Want::nothing);
  /// Takes the full message of a failure that was reported before.
  NumericalError(const std::string& told, Want want);
  std::string cell;  // path of the cell; also "" if the failure is of no one cell
  std::uint64_t step = 0;
  std::string quantity, remedy;
  Want want;
  std::string key;  // the scenario's key that rules the failure out, if its value is what is wrong; else ""
};

/// A file or database that cannot be read or written. The text names the file and the reason. Exit 6.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A bug of the program. Exit 70.
struct BugError : std::logic_error {
  using std::logic_error::logic_error;
};

}  // namespace morula

/// Throws BugError unless the condition holds. Checks the program, never the user's input.
#define MORULA_CHECK(condition, what)                                                                       \
  do {                                                                                                      \
    if (!(condition))                                                                                       \
      throw ::morula::BugError(std::string(__FILE__) + ":" + std::to_string(__LINE__) + ": " + #condition + \
                               " does not hold: " + (what));                                                \
  } while (false)
