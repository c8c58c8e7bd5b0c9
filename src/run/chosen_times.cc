#include "run/chosen_times.h"

#include <algorithm>

#include "dynamics/dense_output.h"

namespace upbead {

std::vector<double> times_of_fields(const Scene& scene) {
  std::vector<double> times;
  if (!scene.fields_every) return times;
  for (int i = 1; i * *scene.fields_every < scene.time.end; ++i) times.push_back(i * *scene.fields_every);
  times.insert(times.end(), scene.output_times.begin(), scene.output_times.end());
  std::sort(times.begin(), times.end());
  return times;
}

std::vector<double> times_to_look_at(const Scene& scene) {
  return scene.fields_every ? times_of_fields(scene) : scene.output_times;
}

double time_tolerance(const Scene& scene) {
  return 1e-8 * scene.time.end;  // steps closer than a tenth of this count as one
}

std::vector<double> equal_times(const Scene& scene) {
  std::vector<double> times;
  if (!scene.output_every) return times;
  const double end = scene.time.end;
  for (int i = 0; i * *scene.output_every <= end + time_tolerance(scene); ++i)
    times.push_back(std::min(i * *scene.output_every, end));
  return times;
}

void read_at_chosen_times(Solution& solution) {
  const Scene& scene = solution.simulation->given;
  const Series& ends = solution.response.ends;
  if (!scene.output_times.empty()) solution.at_times = at_times(ends, scene.output_times, time_tolerance(scene));
  if (scene.output_every && !solution.dense) solution.dense = straight_between(ends, equal_times(scene));
}

}  // namespace upbead
