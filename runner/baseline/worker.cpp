#include "baseline/worker.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <sstream>
#include <thread>

#include "base/error.h"
#include "baseline/bullet_world.h"
#include "baseline/wire.h"

namespace morula {

namespace {

double cpuSeconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

FileError failed(const std::string& what) {
  return FileError("Bullet's process: " + what + ": " + std::strerror(errno));
}

/// Writes all or as much as the other side takes.
void send(int to, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = ::write(to, text.data() + done, text.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return;  // it ended: its exit code says why
    done += static_cast<std::size_t>(n);
  }
}

std::string receive(int from) {
  std::string text;
  std::array<char, 65536> buffer;
  while (true) {
    const ssize_t n = ::read(from, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(n));
  }
}

struct Pipe {
  int read = -1, write = -1;
  Pipe() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw failed("no pipe");
    read = ends[0], write = ends[1];
  }
  ~Pipe() { closeRead(), closeWrite(); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void closeRead() { read = read < 0 ? -1 : (::close(read), -1); }
  void closeWrite() { write = write < 0 ? -1 : (::close(write), -1); }
};

int waitFor(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) throw failed("cannot be waited for");
  return status;
}

}  // namespace

void serveBullet(std::istream& in, std::ostream& out) {
  const BulletRequest request = readRequest(in);
  BulletWorld world(request.scene);
  BulletResult result;
  for (int i = 0; i < request.steps; ++i) {
    const double before = cpuSeconds();
    world.step();
    result.stepSeconds.push_back(cpuSeconds() - before);
  }
  result.cells = world.cells();
  writeResult(out, result);
}

BulletResult runInBullet(const BulletRequest& request, const std::string& program) {
  std::ostringstream text;
  writeRequest(text, request);
  Pipe question, answer;
  const pid_t process = ::fork();
  if (process < 0) throw failed("cannot be started");
  if (process == 0) {
    ::dup2(question.read, STDIN_FILENO);
    ::dup2(answer.write, STDOUT_FILENO);
    ::execl(program.c_str(), "morula", "bullet-worker", static_cast<char*>(nullptr));
    ::_exit(127);
  }
  question.closeRead();
  answer.closeWrite();
  std::string reply;
  std::thread sender([&] {
    // A worker that ends early must not end us by SIGPIPE: blocked in this thread, the write just fails.
    sigset_t pipes;
    sigemptyset(&pipes);
    sigaddset(&pipes, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipes, nullptr);
    send(question.write, text.str());
    question.closeWrite();
  });
  reply = receive(answer.read);
  sender.join();
  const int status = waitFor(process);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw FileError("Bullet's process " + program +
                    (WIFEXITED(status) ? " ended with code " + std::to_string(WEXITSTATUS(status))
                                       : " was ended by signal " + std::to_string(WTERMSIG(status))));
  std::istringstream in(reply);
  return readResult(in);
}

std::string ownProgram() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

}  // namespace morula
