#pragma once
// Ctrl-C and kill end a run cleanly: the run is stored as killed. A second signal ends the program at once.

namespace morula {

/// An object during whose life SIGINT and SIGTERM are noted instead of ending the program.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  /// Returns the signal that has come, or 0.
  static int caught();
};

/// The exception for a signal during runs that leave nothing behind.
struct Interrupted {
  int signal;
};

/// Throws Interrupted if a signal has come, while a SignalWatch lives.
void stopAtSignal();

}  // namespace morula
