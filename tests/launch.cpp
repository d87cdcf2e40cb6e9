#include "launch.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "catch.h"

namespace morula::test {

namespace {

/// Turns the child process into the program.
[[noreturn]] void become(const Words& arguments, const Environment& environment, int out, int err) {
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  std::vector<char*> argv{const_cast<char*>("morula")};
  for (const auto& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  if (chdir(MORULA_SOURCE_DIR) == 0) execv(MORULA_PROGRAM, argv.data());
  _exit(127);
}

/// The two ends of a pseudo-terminal: the program writes to one, and the test reads from the other. Both are −1 if
/// there is no pseudo-terminal.
struct Terminal {
  int program = -1, reader = -1;
};

Terminal openTerminal() {
  const int reader = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (reader < 0) return {};
  const char* name = grantpt(reader) == 0 && unlockpt(reader) == 0 ? ptsname(reader) : nullptr;
  const int program = name ? open(name, O_RDWR | O_NOCTTY | O_CLOEXEC) : -1;
  if (program < 0) {
    close(reader);
    return {};
  }
  return {program, reader};
}

int waitFor(int process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {}
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++n;
  return n;
}

std::string programFile() { return MORULA_PROGRAM; }

Words joined(Words first, const Words& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

Launched launch(const Words& arguments, const Environment& environment, const std::function<void(int)>& meanwhile) {
  const TemporaryFolder folder;
  const auto outFile = folder / "out", errFile = folder / "err";
  const int out = open(outFile.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
  const int err = open(errFile.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
  const int process = fork();
  if (process < 0) throw std::runtime_error("fork failed");
  if (process == 0) become(arguments, environment, out, err);
  close(out);
  close(err);
  if (meanwhile) meanwhile(process);
  const int code = waitFor(process);
  return {code, readWhole(outFile), readWhole(errFile)};
}

Launched endsWith(int code, const Words& arguments, const Environment& environment) {
  const Launched launched = launch(arguments, environment);
  CAPTURE(arguments, launched.out, launched.err);
  REQUIRE(launched.code == code);
  return launched;
}

void waitUntil(const std::function<bool()>& holds) {
  for (int i = 0; i < 600'000; ++i) {
    if (holds()) return;
    usleep(2'000);
  }
  throw std::runtime_error("it does not come to hold");
}

void waitUntilComputing(int process) {
  const std::string folder = "/proc/" + std::to_string(process);
  const auto cpuTime = [&] {  // [clock ticks] user time, the 14th field
    const std::string stat = readWhole(folder + "/stat");
    std::istringstream words(stat.substr(stat.rfind(')') + 1));
    std::string word;
    for (int i = 0; i < 12; ++i) words >> word;
    return word.empty() ? 0 : std::stol(word);
  };
  waitUntil([&] {
    const std::string status = readWhole(folder + "/status"), caught = "SigCgt:\t";
    const auto at = status.find(caught);
    return at != status.npos && (std::stoull(status.substr(at + caught.size(), 16), nullptr, 16) >> (SIGINT - 1) & 1);
  });
  const long begun = cpuTime();
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)  // sanitizers make the start slow
  const double seconds = 3;
#else
  const double seconds = .1;
#endif
  waitUntil([&] { return double(cpuTime() - begun) >= seconds * double(sysconf(_SC_CLK_TCK)); });
}

std::optional<Launched> launchOnTerminal(const Words& arguments, const Environment& environment) {
  const Terminal ends = openTerminal();
  if (ends.program < 0) return {};
  const TemporaryFolder folder;
  const auto outFile = folder / "out";
  const int out = open(outFile.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
  const int process = fork();
  if (process < 0) throw std::runtime_error("fork failed");
  if (process == 0) become(arguments, environment, out, ends.program);
  close(out);
  close(ends.program);
  Launched result;
  char buffer[4096];
  for (ssize_t n; (n = read(ends.reader, buffer, sizeof buffer)) > 0 || (n < 0 && errno == EINTR);)
    if (n > 0) result.err.append(buffer, static_cast<std::size_t>(n));
  close(ends.reader);
  result.code = waitFor(process);
  result.out = readWhole(outFile);
  return result;
}

TemporaryFolder::TemporaryFolder() {
  auto pattern = (std::filesystem::temp_directory_path() / "morula-test-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder to be had");
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void refuses(const Launched& launched, int code, const std::string& because) {
  INFO(launched.err);
  CHECK(launched.code == code);
  CHECK(launched.out.empty());
  CHECK_THAT(launched.err, ContainsSubstring(because));
}

void refuses(const Words& arguments, int code, const std::string& because) {
  refuses(launch(arguments), code, because);
}

nlohmann::json jsonOf(Words arguments, int code) {
  arguments.push_back("--json");
  const auto json = nlohmann::json::parse(endsWith(code, arguments).out);
  CHECK(json["morula"] == 1);
  return json;
}

void accept(const std::string& scenario, const std::string& why) {
  succeeds({"review", scenario, "--accept", "--by", "tests", "--why", why, "--quiet"}, {{"CI", ""}});
}

Launched runText(const std::string& scenario, const Words& more) {
  const TemporaryFolder folder;
  writeWhole(folder / "s.yaml", scenario);
  return launch(joined({"run", folder / "s.yaml", "--out", folder / "out", "--no-pictures"}, more));
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

std::string readWhole(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void writeWhole(const std::string& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

}  // namespace morula::test
