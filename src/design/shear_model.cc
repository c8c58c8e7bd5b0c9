#include "shear_model.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "fem/caisson_readings.h"
#include "upbead/output/model_file.h"

namespace upbead {

namespace {

constexpr double mass_tolerance = 0.01;

bool has(const ModalModel& modes, const std::string& name) {
  return std::any_of(modes.reading_label.begin(), modes.reading_label.end(),
                     [&name](const ReadingLabel& label) { return label.name == name; });
}

/// P of a unit of each load (N/m).
Eigen::RowVectorXd forces(const ModalModel& modes) {
  return modes.feedthrough.row(modes.index(reading::force));
}

/// The load of that name, else the one with the largest force; -1 where there is none.
int load_of(const ReducedModelFile& file, const std::string& name) {
  if (!name.empty()) {
    const auto& names = file.modes.load_name;
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
  }
  int best = -1;
  double largest = 0.;
  for (int k = 0; k < file.modes.n_loads(); ++k) {
    const double peak = std::abs(forces(file.modes)[k]) * file.loads[static_cast<std::size_t>(k)].peak;
    if (peak > largest || best < 0) best = k;
    largest = std::max(largest, peak);
  }
  return best;
}

void check_mass(double mass, const Section& section, const Water& water, const Place& place, Diagnostics& mistakes) {
  const double weight = mass * water.gravity;
  if (std::abs(weight / section.weight - 1.) <= mass_tolerance) return;
  mistakes.add(place,
               "the caisson of the model weighs " + significant(weight, 5) +
                   " N/m, that of [section] weight = " + significant(section.weight, 5) + " N/m",
               "give one caisson in both, within 1 %");
}

}  // namespace

WaveModel read_wave_model(const std::string& path, const DynamicsTable& table, const Section& section,
                          const Water& water, const Place& place) {
  const ReducedModelFile file = read_model_file(path);
  Diagnostics mistakes;
  if (!has(file.modes, reading::force) || !has(file.modes, reading::shear_force) || file.caisson_mass <= 0.)
    throw InputError(place, "the model '" + path + "' has no caisson, so nothing can slide",
                     "reduce a case with a caisson");
  const int load = load_of(file, table.load);
  if (load < 0)
    mistakes.add(place, "the model has no load '" + table.load + "'",
                 suggestion(table.load, file.modes.load_name, "loads"));
  else if (forces(file.modes)[load] == 0.)
    mistakes.add(place,
                 "the load '" + file.modes.load_name[static_cast<std::size_t>(load)] +
                     "' of the model puts no horizontal force on the caisson",
                 "name another one as load");
  check_mass(file.caisson_mass, section, water, place, mistakes);
  mistakes.throw_if_any();
  return {file.title,
          file.modes.load_name[static_cast<std::size_t>(load)],
          {file.modes, load, file.modes.index(reading::shear_force), forces(file.modes)[load], file.caisson_mass}};
}

}  // namespace upbead
