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

/// The exception that ends a run on a signal if nothing of the run is stored.
struct Interrupted {
  int signal;
};

/// Throws Interrupted if a signal has come during the life of a SignalWatch.
void stopAtSignal();

}  // namespace morula
