#include "response/base_history.h"

#include "fem/caisson_readings.h"
#include "inside_steps.h"
#include "response/shear_response.h"

namespace upbead {

namespace {

std::vector<double> to_vector(const Samples& values) {
  return {values.begin(), values.end()};
}

}  // namespace

BaseHistory read_base_history(const CompiledScene& compiled, const Response& response, bool inertia) {
  const Series& ends = response.ends;
  BaseHistory history;
  history.step_time = ends.time;
  history.normal_force = to_vector(samples(compiled, ends, reading::normal_force));
  history.uplift = to_vector(samples(compiled, ends, reading::uplift));
  if (!inertia) {
    history.time = ends.time;
    history.shear_force = to_vector(samples(compiled, ends, reading::shear_force));
    history.force = to_vector(samples(compiled, ends, reading::force));
    return history;
  }
  const TimeFunction P = force_on_caisson(compiled);
  const InsideSteps inside(compiled, response, P);
  inside.for_each(samples(compiled, ends, reading::water_force), [&history](double t, double F_T, double force) {
    if (!history.time.empty() && t == history.time.back() && F_T == history.shear_force.back() &&
        force == history.force.back())
      return;  // nothing jumps between these steps
    history.time.push_back(t);
    history.shear_force.push_back(F_T);
    history.force.push_back(force);
  });
  return history;
}

}  // namespace upbead
