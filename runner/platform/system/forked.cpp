#include "system/forked.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <sstream>
#include <utility>

#include "base/error.h"
#include "files/read_file.h"
#include "system/child_process.h"

namespace morula {
namespace {

constexpr std::size_t mostText = 16384;  // a quarter of what a pipe takes without a reader

void lower(decltype(RLIMIT_CPU) what, rlim_t most) {
  rlimit limit{};
  ::getrlimit(what, &limit);
  limit.rlim_cur = std::min(limit.rlim_max, most);
  ::setrlimit(what, &limit);
}

/// [byte] Of address space that this process has.
std::uint64_t addressSpace() {
  std::istringstream words(readHead("/proc/self/statm", 128));
  std::uint64_t pages = 0;
  words >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

/// Of this process; 1 where the system does not tell.
int threadsNow() {
  const std::string stat = readHead("/proc/self/stat", 1024);
  std::istringstream words(stat.substr(stat.rfind(')') + 1));  // behind the program's name
  std::string word;
  for (int i = 0; i < 17; ++i) words >> word;
  int threads = 1;  // its 20th field
  return words >> threads ? threads : 1;
}

void limit(const ForkedLimits& limits) {
  lower(RLIMIT_CORE, 0);  // what SIGXCPU ends is no mistake to look into
  if (limits.cpuSeconds) {
    std::signal(SIGXCPU, SIG_DFL);
    lower(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(*limits.cpuSeconds)));
  }
  if (limits.memory) lower(RLIMIT_AS, addressSpace() + *limits.memory);
}

/// Signals wait while this lives, or until `let`.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsWait() { let(); }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;
  void let() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_;
};

[[noreturn]] void work(const ForkedLimits& limits, const std::function<ForkedAnswer()>& what, pid_t parent,
                       int answerTo, SignalsWait& signals) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(128 + SIGKILL);  // it died before
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    std::signal(signal, SIG_DFL);  // whatever its parent does at them
  signals.let();
  limit(limits);
  const ForkedAnswer answer = what();
  const std::string text = answer.text.substr(0, mostText);
  if (::write(answerTo, text.data(), text.size()) < 0) ::_exit(70);
  ::_exit(answer.code);
}

}  // namespace

Forked::Forked(const ForkedLimits& limits, const std::function<ForkedAnswer()>& what) {
#if !defined(__SANITIZE_THREAD__)  // which has a thread of its own
  MORULA_CHECK(threadsNow() == 1, "others would be missing in the new process, with whatever they hold locked");
#endif
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw processError("no pipe");
  const pid_t parent = ::getpid();
  // A signal to the new process must not meet the handlers of this one, which would take it for its own.
  SignalsWait signals;
  process_ = ::fork();
  if (process_ == 0) work(limits, what, parent, ends[1], signals);
  ::close(ends[1]);
  answer_ = ends[0];
  if (process_ > 0) return;
  const int reason = std::exchange(errno, 0);
  ::close(answer_);
  errno = reason;
  throw processError("cannot be made");
}

Forked::~Forked() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  wait();
}

Forked::Forked(Forked&& other) noexcept
    : process_(std::exchange(other.process_, -1)), answer_(std::exchange(other.answer_, -1)) {}

ForkedEnd Forked::wait() {
  ForkedEnd end;
  end.answer.text = readToEnd(answer_);
  ::close(std::exchange(answer_, -1));
  int status = 0;
  rusage used{};
  const pid_t process = std::exchange(process_, -1);
  while (::wait4(process, &status, 0, &used) < 0)
    if (errno != EINTR) throw processError("cannot be waited for");
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  else end.answer.code = WEXITSTATUS(status);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  end.cpuSeconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  end.maxMemory = static_cast<std::uint64_t>(used.ru_maxrss) * 1024;
  return end;
}

void Forked::stop(int signal) {
  if (process_ > 0) ::kill(process_, signal);
}

std::vector<std::size_t> endedAmong(const std::vector<Forked*>& processes, double seconds) {
  std::vector<pollfd> pipes;
  for (const Forked* p : processes) pipes.push_back({p->answer_, POLLIN, 0});
  std::vector<std::size_t> ended;
  if (::poll(pipes.data(), pipes.size(), static_cast<int>(1000 * seconds)) <= 0) return ended;
  for (std::size_t i = 0; i < pipes.size(); ++i)
    if (pipes[i].revents != 0) ended.push_back(i);
  return ended;
}

void liftMemoryLimit() {
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_AS, &limit);
}

std::string signalName(int signal) {
  const char* const name = ::sigabbrev_np(signal);
  return name ? std::string("SIG") + name : "signal " + std::to_string(signal);
}

}  // namespace morula
