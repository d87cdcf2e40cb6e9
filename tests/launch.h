#pragma once
// Runs the built program as users do: in its own process, with arguments, exit code, and separate stdout and stderr.
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

/// The words of a command line.
using Words = std::vector<std::string>;
Words joined(Words first, const Words& more);

/// A shipped scenario that is quick to run: four cells with bodies that divide, a check and a golden file.
inline const std::string uniqueFour = "scenarios/thesis/unique-four.yaml";

/// Returns how often a part occurs in a text.
std::size_t occurrences(const std::string& text, const std::string& part);

/// Returns the built program's file, for tests that start the program through a shell.
std::string programFile();

/// Runs `morula arguments…` in the source folder and waits for its end; calls `meanwhile` with the process's id while
/// it runs.
Launched launch(const Words& arguments, const Environment& environment = {},
                const std::function<void(int)>& meanwhile = {});

/// Runs as `launch`; stops the test, and shows the output, unless the exit code is `code`.
Launched endsWith(int code, const Words& arguments, const Environment& environment = {});
inline Launched succeeds(const Words& arguments, const Environment& environment = {}) {
  return endsWith(0, arguments, environment);
}

/// Runs as `launch`, with stderr on a terminal, and returns its bytes in `err`. Returns nothing on systems without
/// pseudo-terminals; the test then warns with skippedWithoutTerminal.
std::optional<Launched> launchOnTerminal(const Words& arguments, const Environment& environment = {});

/// The warning of tests that need a pseudo-terminal.
inline constexpr auto skippedWithoutTerminal = "skipped: no pseudo-terminals here";

/// Waits until `holds` returns true, for many minutes if needed, because machines may be busy. Throws if it never does.
void waitUntil(const std::function<bool()>& holds);

/// Waits until a run computes: the process handles SIGINT, and has used a tenth of a second of CPU time since.
void waitUntilComputing(int process);

/// An empty folder that is removed with its owner.
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

/// Checks that the run ended with this code, printed nothing on stdout, and gave this reason on stderr.
void refuses(const Launched& launched, int code, const std::string& because);
void refuses(const Words& arguments, int code, const std::string& because);
/// Runs with --json and returns the output, which begins with "morula": 1; the exit code must be `code`.
nlohmann::json jsonOf(Words arguments, int code = 0);
/// Accepts the scenario's result, as users may outside of continuous integration.
void accept(const std::string& scenario, const std::string& why = "the first one");
/// Runs a scenario in a folder of its own, without pictures.
Launched runText(const std::string& scenario, const Words& more = {});
/// Returns the text with `by` in place of the first `what`, which the text must hold.
std::string replaced(std::string text, const std::string& what, const std::string& by);

std::string readWhole(const std::string& file);
void writeWhole(const std::string& file, const std::string& text);

}  // namespace morula::test
