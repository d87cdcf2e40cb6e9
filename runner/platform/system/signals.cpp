#include "system/signals.h"

#include <csignal>

namespace morula {
namespace {

volatile std::sig_atomic_t received = 0;

void note(int signal) { received = signal; }

void handle(void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;  // handled once: a second signal has its usual effect
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

SignalWatch::SignalWatch() { handle(note); }
SignalWatch::~SignalWatch() { handle(SIG_DFL); }
int SignalWatch::caught() { return received; }

void stopAtSignal() {
  if (const int signal = SignalWatch::caught()) throw Interrupted{signal};
}

}  // namespace morula
