// Ctrl-C and kill end a run by an exception, so that no incomplete file stays on the disk.
#pragma once

#include <exception>

namespace upbead {

/// The person (SIGINT) or the system (SIGTERM) wants the program to end.
class Interrupted : public std::exception {
 public:
  explicit Interrupted(int signal) : signal_(signal) {}
  int signal() const { return signal_; }
  const char* what() const noexcept override { return "interrupted"; }

 private:
  int signal_;
};

/// From now on the first SIGINT and the first SIGTERM are only noted; a second one of either ends the program at
/// once.
void note_interrupts();

/// Whether a signal has been noted.
bool interrupt_noted();

/// Throws Interrupted where a signal has been noted. Call between the steps of long work.
void check_interrupt();

}  // namespace upbead
