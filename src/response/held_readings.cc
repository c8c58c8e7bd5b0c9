#include "response/held_readings.h"

#include <string>
#include <utility>

#include "fem/caisson/reading_names.h"

namespace upbead {

HeldReadings held_readings(const std::vector<ReadingLabel>& of_scene, double width) {
  const auto at = [&](const char* name) { return static_cast<Eigen::Index>(index_of(of_scene, name)); };
  HeldReadings held;
  held.sums.setZero(4, static_cast<Eigen::Index>(of_scene.size()));
  for (const char* own : {reading::shear_force, reading::displacement_x}) {
    held.sums(static_cast<Eigen::Index>(held.labels.size()), at(own)) = 1.;
    held.labels.push_back(of_scene[static_cast<std::size_t>(at(own))]);
  }
  for (const auto& [edge, sign] : {std::pair("heel", -1.), std::pair("toe", 1.)}) {
    const auto row = static_cast<Eigen::Index>(held.labels.size());
    held.sums(row, at(reading::normal_force)) = 0.5 * width;
    held.sums(row, at(reading::uplift)) = -0.5 * width;
    for (const char* moment : {reading::base_moment, reading::uplift_moment}) held.sums(row, at(moment)) = sign;
    held.labels.push_back({std::string(edge) + "_moment", "N m/m",
                           "moment of the change of the effective forces on the base about its " + std::string(edge)});
  }
  return held;
}

System with_readings_as_loads(System scene) {
  for (const char* name : {reading::uplift, reading::uplift_moment}) {
    SystemLoad load;
    load.name = name;
    load.vector = Vector::Zero(scene.size());
    for (const auto& [unknown, weight] : scene.readings[static_cast<std::size_t>(scene.reading(name))].velocity)
      load.vector[unknown] = weight;
    scene.loads.push_back(std::move(load));
  }
  for (Reading& reading : scene.readings)
    if (!reading.feedthrough.empty()) reading.feedthrough.resize(scene.loads.size(), 0.);
  return scene;
}

}  // namespace upbead
