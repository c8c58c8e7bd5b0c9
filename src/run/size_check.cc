#include "size_check.h"

#include "base/text.h"
#include "response/step_choice.h"
#include "upbead/run/simulation.h"

namespace upbead {

namespace {

constexpr double most_steps = 1e6, most_fields = 1e4;

std::size_t n_kinks(const Scene& scene) {
  std::size_t n = 0;
  for (const auto& [name, load] : scene.loads) n += load.history.kinks().size();
  return n;
}

int order_of(const Scene& scene) {
  return scene.time.scheme == TimeScheme::generalised_alpha ? 2 : 4;
}

}  // namespace

void check_steps(const Scene& scene, double step, const std::optional<StepGrowth>& growth, const std::string& because) {
  const double end = scene.time.end, n = estimated_steps(n_kinks(scene), end, step, growth);
  if (n <= most_steps) return;
  const std::string what = " s makes about " + significant(n) + " steps, more than " + significant(most_steps);
  if (scene.time.step)
    throw InputError(at_key("time.step"),
                     "time.step = " + significant(step) + " s until time.end = " + significant(end) + what,
                     "raise time.step, or lower time.end");
  throw InputError(at_key("time.end"),
                   "time.end = " + significant(end) + " s in steps of " + significant(step) + what +
                       "; the step follows from " + because,
                   "lower time.end, or give time.step");
}

void check_size(const Scene& scene) {
  const double end = scene.time.end;
  if (scene.fields_every && end / *scene.fields_every > most_fields)
    throw InputError(at_key("output.fields.every"),
                     "every = " + significant(*scene.fields_every) + " s until time.end = " + significant(end) +
                         " s makes about " + significant(end / *scene.fields_every) + " fields, more than " +
                         significant(most_fields),
                     "raise every, or lower time.end");
  if (scene.time.step) return check_steps(scene, *scene.time.step, {}, "");
  const LoadStep loads = step_of_loads(scene, order_of(scene));
  if (loads.lone_jump) return;
  const std::string load = loads.load.empty() ? "the loads" : "[loads." + loads.load + "]";
  check_steps(scene, loads.largest_step, loads.growth, load + ", which lasts " + significant(loads.duration) + " s");
}

}  // namespace upbead
