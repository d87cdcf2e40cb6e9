#include "system/child_process.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <thread>

#include "base/error.h"
#include "files/folders.h"

namespace morula {
namespace {

/// Writes all or as much as the other side takes.
void send(int to, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = ::write(to, text.data() + done, text.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return;  // it ended: its exit code says why
    done += static_cast<std::size_t>(n);
  }
}

struct Pipe {
  int read = -1, write = -1;
  Pipe() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw processError("no pipe");
    read = ends[0], write = ends[1];
  }
  ~Pipe() { closeRead(), closeWrite(); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void closeRead() { read = read < 0 ? -1 : (::close(read), -1); }
  void closeWrite() { write = write < 0 ? -1 : (::close(write), -1); }
};

void waitFor(pid_t process, ChildEnd& end) {
  rusage used{};
  while (::wait4(process, &end.status, 0, &used) < 0)
    if (errno != EINTR) throw processError("cannot be waited for");
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  end.cpuSeconds = seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// In the child: the kernel ends it once it has computed so long, whatever it is stuck in.
void limitCpuTime(int seconds) {
  if (seconds <= 0) return;
  rlimit limit{};
  ::getrlimit(RLIMIT_CPU, &limit);
  limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(seconds));  // then SIGXCPU
  ::setrlimit(RLIMIT_CPU, &limit);
}

}  // namespace

FileError processError(const std::string& what) {
  return FileError("a process of its own: " + what + ": " + std::strerror(errno));
}

std::string readToEnd(int from) {
  std::string text;
  std::array<char, 65536> buffer;
  while (true) {
    const ssize_t n = ::read(from, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(n));
  }
}

bool ChildEnd::well() const { return WIFEXITED(status) && WEXITSTATUS(status) == 0; }
bool ChildEnd::outOfTime() const { return WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU; }
bool ChildEnd::notStarted() const { return WIFEXITED(status) && WEXITSTATUS(status) == 127; }
int ChildEnd::code() const { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

std::string ChildEnd::text() const {
  if (WIFEXITED(status)) return "ended with code " + std::to_string(WEXITSTATUS(status));
  return "was ended by signal " + std::to_string(WTERMSIG(status));
}

ChildEnd runChild(const std::vector<std::string>& command, const ChildOptions& options) {
  std::vector<char*> words;  // before the fork: after it only what is safe in a signal handler may be called
  for (const auto& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  Pipe question, answer;
  const pid_t process = ::fork();
  if (process < 0) throw processError("cannot be started");
  if (process == 0) {
    limitCpuTime(options.cpuSeconds);
    if (options.silent) ::dup2(::open("/dev/null", O_WRONLY | O_CLOEXEC), STDERR_FILENO);
    ::dup2(question.read, STDIN_FILENO);
    ::dup2(answer.write, STDOUT_FILENO);
    if (options.errorsToo) ::dup2(answer.write, STDERR_FILENO);
    ::execvp(words[0], words.data());
    ::_exit(127);
  }
  question.closeRead();
  answer.closeWrite();
  std::thread sender([&] {
    // A child that ends early must not end us by SIGPIPE: blocked in this thread, the write just fails.
    sigset_t pipes;
    sigemptyset(&pipes);
    sigaddset(&pipes, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipes, nullptr);
    send(question.write, options.input);
    question.closeWrite();
  });
  ChildEnd end;
  std::exception_ptr noMemory;  // for what it says
  try {
    end.said = readToEnd(answer.read);
  } catch (...) { noMemory = std::current_exception(); }
  answer.closeRead();  // a child that says more ends by that, and does not keep the sender waiting
  sender.join();
  waitFor(process, end);
  if (noMemory) std::rethrow_exception(noMemory);
  return end;
}

std::string ownProgram() { return readLink("/proc/self/exe").string(); }

}  // namespace morula
