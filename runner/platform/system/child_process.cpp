#include "system/child_process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <thread>

#include "files/folders.h"

namespace morula {

bool ChildEnd::well() const { return WIFEXITED(status) && WEXITSTATUS(status) == 0; }
bool ChildEnd::outOfTime() const { return WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU; }
bool ChildEnd::notStarted() const { return WIFEXITED(status) && WEXITSTATUS(status) == 127; }
int ChildEnd::code() const { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

std::string ChildEnd::text() const {
  if (WIFEXITED(status)) return "ended with code " + std::to_string(WEXITSTATUS(status));
  return "was ended by signal " + std::to_string(WTERMSIG(status));
}

ChildEnd runChild(const std::vector<std::string>& command, const ChildOptions& options) {
  std::vector<char*> words;  // made before the fork: allocating is not safe after it
  for (const auto& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  Pipe question = makePipe(), answer = makePipe();
  const pid_t process = ::fork();
  if (process < 0) throw processError("cannot be started");
  if (process == 0) {
    if (options.cpuSeconds > 0) setLimit(RLIMIT_CPU, static_cast<rlim_t>(options.cpuSeconds));  // SIGXCPU beyond it
    if (options.silent) ::dup2(::open("/dev/null", O_WRONLY | O_CLOEXEC), STDERR_FILENO);
    ::dup2(question.read.number(), STDIN_FILENO);
    ::dup2(answer.write.number(), STDOUT_FILENO);
    if (options.errorsToo) ::dup2(answer.write.number(), STDERR_FILENO);
    ::execvp(words[0], words.data());
    ::_exit(127);
  }
  question.read.close();
  answer.write.close();
  std::thread sender([&] {
    // If a child ends early, SIGPIPE must not end this process: it is blocked in this thread, so the write just fails.
    sigset_t pipes;
    sigemptyset(&pipes);
    sigaddset(&pipes, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipes, nullptr);
    writeAll(question.write.number(), options.input);  // a failure shows in the child's exit code
    question.write.close();
  });
  std::string said;
  std::exception_ptr noMemory;  // the error of reading the answer
  try {
    said = readToEnd(answer.read);
  } catch (...) { noMemory = std::current_exception(); }
  answer.read.close();  // ends a child that writes more, so that the sender does not wait
  sender.join();
  ChildEnd end{waitFor(process), std::move(said)};
  if (noMemory) std::rethrow_exception(noMemory);
  return end;
}

std::string ownProgram() { return readLink("/proc/self/exe").string(); }

}  // namespace morula
