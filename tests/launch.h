#pragma once
// Runs the built program as users do: its own process, arguments, exit code, stdout and stderr apart.
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace morula::test {

struct Launched {
  int code = -1;  // exit code, or 128 + the signal that killed it
  std::string out, err;
};

using Environment = std::map<std::string, std::string>;

/// Of a command line.
using Words = std::vector<std::string>;
Words joined(Words first, const Words& more);

/// A shipped scenario that is quick to run: four cells with bodies that divide, a check and a golden file.
inline const std::string uniqueFour = "scenarios/thesis/unique-four.yaml";

/// How often a part is in a text.
std::size_t occurrences(const std::string& text, const std::string& part);

/// The built program, for tests that start it through a shell.
std::string programFile();

/// Runs `morula arguments…` in the source folder and waits for its end; calls `meanwhile` with the process's id while
/// it runs.
Launched launch(const Words& arguments, const Environment& environment = {},
                const std::function<void(int)>& meanwhile = {});

/// The same; stops the test, and shows what was said, unless it ends with `code`.
Launched endsWith(int code, const Words& arguments, const Environment& environment = {});
inline Launched succeeds(const Words& arguments, const Environment& environment = {}) {
  return endsWith(0, arguments, environment);
}

/// As `launch`, with stderr on a terminal, which `err` holds what was written to. None where the system has no
/// pseudo-terminals: then the test says so (skippedWithoutTerminal) and has nothing to look at.
std::optional<Launched> launchOnTerminal(const Words& arguments, const Environment& environment = {});

/// What such a test says.
inline constexpr auto skippedWithoutTerminal = "skipped: no pseudo-terminals here";

/// Waits until it holds, for many minutes if need be: how long that takes is a matter of the machine's load. Throws if
/// it never comes to hold.
void waitUntil(const std::function<bool()>& holds);

/// Waits until a run has begun to compute: the process minds SIGINT, and has used a tenth of a second of CPU time
/// since.
void waitUntilComputing(int process);

/// An empty folder that goes away with its owner.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// It ended with this code, printed nothing on stdout, and said so.
void refuses(const Launched& launched, int code, const std::string& because);
void refuses(const Words& arguments, int code, const std::string& because);
/// What it prints as JSON with --json, which begins with "morula": 1; it ends with `code`.
nlohmann::json jsonOf(Words arguments, int code = 0);
/// Accepts the scenario's result, as people may outside of continuous integration.
void accept(const std::string& scenario, const std::string& why = "the first one");
/// Runs a scenario in a folder of its own, without pictures.
Launched runText(const std::string& scenario, const Words& more = {});
/// The text with `by` in place of the first `what`, which is in it.
std::string replaced(std::string text, const std::string& what, const std::string& by);

std::string readWhole(const std::string& file);
void writeWhole(const std::string& file, const std::string& text);

}  // namespace morula::test
