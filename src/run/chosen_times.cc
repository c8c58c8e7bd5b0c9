#include "run/chosen_times.h"

#include <algorithm>

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

}  // namespace upbead
