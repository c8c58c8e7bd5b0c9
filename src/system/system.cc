#include "upbead/system/system.h"

#include <stdexcept>

namespace upbead {

std::string ReadingName::text() const {
  const std::string whose = node < 0 ? probe : std::to_string(node);
  return (group.empty() ? "" : group + "/") + (whose.empty() ? "" : whose + "/") + quantity;
}

int System::reading(const std::string& name) const {
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (readings[i].name.text() == name) return static_cast<int>(i);
  throw std::out_of_range("no reading '" + name + "'");
}

Reading position_reading(ReadingName name, std::string unit, std::string description, Row row) {
  return {std::move(name), std::move(unit), std::move(description), std::move(row), {}, {}, {}};
}

Reading velocity_reading(ReadingName name, std::string unit, std::string description, Row row) {
  return {std::move(name), std::move(unit), std::move(description), {}, std::move(row), {}, {}};
}

Reading acceleration_reading(ReadingName name, std::string unit, std::string description, Row row) {
  return {std::move(name), std::move(unit), std::move(description), {}, {}, std::move(row), {}};
}

State at_rest(const System& system) {
  const Vector zero = Vector::Zero(system.size());
  return {0., zero, zero, zero};
}

double evaluate(const Reading& reading, const State& state, const std::vector<double>& load) {
  double y = 0.;
  for (const auto& [i, weight] : reading.position) y += weight * state.x[i];
  for (const auto& [i, weight] : reading.velocity) y += weight * state.v[i];
  for (const auto& [i, weight] : reading.acceleration) y += weight * state.a[i];
  for (std::size_t k = 0; k < reading.feedthrough.size(); ++k) y += reading.feedthrough[k] * load[k];
  return y;
}

}  // namespace upbead
