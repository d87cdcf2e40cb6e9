#pragma once
// Ctrl-C and kill end a run cleanly: it is stored as killed. A second signal ends the program at once.

namespace morula {

/// While one lives, SIGINT and SIGTERM are noted instead of ending the program.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  /// The signal that has come, or 0.
  static int caught();
};

/// A signal has come while runs were made that leave nothing behind.
struct Interrupted {
  int signal;
};

/// Throws Interrupted if a signal has come, while a SignalWatch lives.
void stopAtSignal();

}  // namespace morula
