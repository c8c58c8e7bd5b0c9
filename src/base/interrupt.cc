#include "base/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace upbead {

namespace {

volatile std::sig_atomic_t noted_signal = 0;

void note(int signal) {
  noted_signal = signal;
}

}  // namespace

void note_interrupts() {
  struct sigaction action = {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  for (int signal : {SIGINT, SIGTERM}) {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    // nohup and background jobs ignore these signals
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

bool interrupt_noted() {
  return noted_signal != 0;
}

void check_interrupt() {
  if (interrupt_noted()) throw Interrupted(noted_signal);
}

}  // namespace upbead
