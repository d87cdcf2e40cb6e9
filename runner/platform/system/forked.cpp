#include "system/forked.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <charconv>
#include <cmath>
#include <csignal>
#include <utility>

#include "base/error.h"
#include "files/read_file.h"
#include "files/text.h"
#include "system/process.h"

namespace morula {
namespace {

constexpr std::size_t maxText = 16384;  // a quarter of the capacity of a pipe without a reader

/// Returns the size of the address space of this process [byte].
std::uint64_t addressSpace() {
  std::uint64_t pages = 0;
  const std::string all = readHead("/proc/self/statm", 128);
  std::from_chars(all.data(), all.data() + all.size(), pages);
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

/// Returns the number of this process's threads; 1 if the system does not tell.
int threadsNow() {
  const std::string stat = readHead("/proc/self/stat", 1024);
  const std::vector<std::string> words =
      wordsOf(std::string_view(stat).substr(stat.rfind(')') + 1));  // the fields behind the name
  int threads = 1;
  if (words.size() > 17)
    std::from_chars(words[17].data(), words[17].data() + words[17].size(), threads);  // the 20th field
  return threads;
}

void limit(const ForkedLimits& limits) {
  setLimit(RLIMIT_CORE, 0);  // an end by SIGXCPU is no mistake, so no core is kept
  if (limits.cpuSeconds) {
    std::signal(SIGXCPU, SIG_DFL);
    setLimit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(*limits.cpuSeconds)));
  }
  if (limits.memory) setLimit(RLIMIT_AS, addressSpace() + *limits.memory);
}

/// Blocks signals while it lives, or until `let`.
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
  if (::getppid() != parent) ::_exit(128 + SIGKILL);  // the parent has died already
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    std::signal(signal, SIG_DFL);  // the parent's handlers do not apply
  signals.let();
  limit(limits);
  const ForkedAnswer answer = what();
  const std::string text = answer.text.substr(0, maxText);
  if (::write(answerTo, text.data(), text.size()) < 0) ::_exit(70);
  ::_exit(answer.code);
}

}  // namespace

Forked::Forked(const ForkedLimits& limits, const std::function<ForkedAnswer()>& what) {
#if !defined(__SANITIZE_THREAD__)  // the thread sanitizer has a thread of its own
  MORULA_CHECK(threadsNow() == 1, "others would be missing in the new process, with whatever they hold locked");
#endif
  Pipe answer = makePipe();
  const pid_t parent = ::getpid();
  // Signals are blocked: one sent to the new process must not meet the handlers of this process.
  SignalsWait signals;
  process_ = ::fork();
  if (process_ == 0) work(limits, what, parent, answer.write.number(), signals);
  if (process_ < 0) throw processError("cannot be made");
  answer_ = std::move(answer.read);
}

Forked::~Forked() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  wait();
}

Forked::Forked(Forked&& other) noexcept
    : process_(std::exchange(other.process_, -1)), answer_(std::move(other.answer_)) {}

ForkedEnd Forked::wait() {
  ForkedEnd end;
  end.answer.text = readToEnd(answer_);
  answer_.close();
  const ProcessEnd process = waitFor(std::exchange(process_, -1));
  if (WIFSIGNALED(process.status)) end.signal = WTERMSIG(process.status);
  else end.answer.code = WEXITSTATUS(process.status);
  end.cpuSeconds = process.cpuSeconds;
  end.maxMemory = process.maxMemory;
  return end;
}

void Forked::stop(int signal) {
  if (process_ > 0) ::kill(process_, signal);
}

std::vector<std::size_t> endedAmong(const std::vector<Forked*>& processes, double seconds) {
  std::vector<pollfd> pipes;
  for (const Forked* p : processes) pipes.push_back({p->answer_.number(), POLLIN, 0});
  std::vector<std::size_t> ended;
  if (::poll(pipes.data(), pipes.size(), static_cast<int>(1000 * seconds)) <= 0) return ended;
  for (std::size_t i = 0; i < pipes.size(); ++i)
    if (pipes[i].revents != 0) ended.push_back(i);
  return ended;
}

void liftMemoryLimit() { setLimit(RLIMIT_AS, RLIM_INFINITY); }

std::string signalName(int signal) {
  const char* const name = ::sigabbrev_np(signal);
  return name ? std::string("SIG") + name : "signal " + std::to_string(signal);
}

}  // namespace morula
