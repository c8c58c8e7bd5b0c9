#include "several_processes.h"

#include "model/exclusions.h"

#include <chrono>
#include <thread>

#include "cli/failure.h"
#include "upbead/base/error.h"

namespace upbead {

void check_processes(const Case& input, bool with_checkpoints) {
  Diagnostics mistakes;
  if (with_checkpoints)
    mistakes.add({}, "no checkpoints are kept on several processes", "leave out --checkpoint and --resume");
  for (const Exclusion& reason : excluded(input.scene, Treatment::several_processes))
    mistakes.add(input.place(reason.key), reason.why + " on several processes",
                 "remove it, or run upbead alone, without mpirun");
  mistakes.throw_if_any();
}

void run_together(const Processes* processes, const std::function<void()>& work) {
  if (processes == nullptr) return work();
  const auto leave_it_to_the_first = [processes](int seconds) {
    if (processes->rank() > 0) std::this_thread::sleep_for(std::chrono::seconds(seconds));
  };
  try {
    work();
  } catch (const InputError&) {  // all read the same
    leave_it_to_the_first(60);
    processes->end_all(tell_failure());
  } catch (...) {  // mostly all fail alike
    leave_it_to_the_first(2);
    processes->end_all(tell_failure());
  }
}

}  // namespace upbead
