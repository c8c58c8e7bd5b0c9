#include "several_processes.h"

#include <chrono>
#include <thread>

#include "upbead/base/error.h"
#include "upbead/cli/failure.h"

namespace upbead {

void check_processes(const Case& input, bool with_checkpoints) {
  const Scene& scene = input.scene;
  Mistakes mistakes;
  const auto refuse = [&](bool asked, const std::string& key, const std::string& what) {
    if (asked)
      mistakes.add(input.place(key), what + " on several processes", "remove it, or run upbead alone, without mpirun");
  };
  if (with_checkpoints)
    mistakes.add({}, "no checkpoints are kept on several processes", "leave out --checkpoint and --resume");
  refuse(scene.time.scheme == TimeScheme::reduced, "time.scheme", "no reduced model is made");
  refuse(scene.time.stop_at_energy.has_value(), "time.stop_at_energy", "no run stops early");
  refuse(scene.fields_every.has_value(), "output.fields", "no fields are written");
  refuse(has_frictional_contact(scene), "regions.caisson.interface", "no contact is solved");
  for (const auto& [name, region] : scene.regions)
    refuse(region.strain_law.has_value(), "regions." + name + ".strain", "soil does not follow its strain");
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
