#include "cli/respond_cases.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "base/text.h"
#include "case/case_run.h"
#include "case/scene_text.h"
#include "case/script_trust.h"
#include "cli/reduced_case.h"
#include "fem/compile.h"
#include "response/reduction.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

Case case_with_loads(const std::string& path) {
  Case input = read_case(path, {});
  require_trust(input, false);
  require_loads(input);
  std::cerr << notes_on(input);
  return input;
}

ReducedModelFile model_of_case(const std::string& path, OutputFolder& folder) {
  Case input = case_with_loads(path);
  const ReducedModelFile model = reduced_case(input, {}, folder.name()).file;
  folder.write("reduced.h5", model_file(model));
  return model;
}

/// The rows of the system's loads that the loads of the model stand for; -1: the case has no such load.
std::vector<int> rows_of(const std::vector<std::string>& names, const System& system) {
  std::vector<int> rows;
  for (const std::string& name : names) {
    const auto found = std::find_if(system.loads.begin(), system.loads.end(),
                                    [&name](const SystemLoad& load) { return load.name == name; });
    rows.push_back(found == system.loads.end() ? -1 : static_cast<int>(found - system.loads.begin()));
  }
  return rows;
}

/// The loads at their times; a jump is a line over a millionth of the step after it.
WaveFile as_wave(const std::string& name, const SampledLoads& loads, const std::vector<int>& rows) {
  WaveFile file;
  file.name = name;
  file.n_loads = static_cast<int>(rows.size());
  std::vector<Eigen::VectorXd> values;
  const auto add = [&](double time, const auto& column) {
    Eigen::VectorXd value = Eigen::VectorXd::Zero(file.n_loads);
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (rows[k] >= 0) value[static_cast<Eigen::Index>(k)] = column[rows[k]];
    file.time.push_back(time);
    values.push_back(value);
  };
  for (Eigen::Index n = 0; n < loads.begin.cols(); ++n) {
    const double from = loads.time[static_cast<std::size_t>(n)], to = loads.time[static_cast<std::size_t>(n + 1)];
    if (n == 0) add(from, loads.begin.col(0));
    if (n > 0 && loads.begin.col(n) != loads.end.col(n - 1)) add(from + 1e-6 * (to - from), loads.begin.col(n));
    add(to, loads.end.col(n));
  }
  file.value.resize(file.n_loads, static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) file.value.col(static_cast<Eigen::Index>(i)) = values[i];
  return file;
}

/// A load of the case that acts and that the model does not have would be left out.
void require_all_loads(const Case& input, const System& system, const SampledLoads& loads, const std::vector<int>& rows,
                       const std::vector<std::string>& names) {
  const std::string joined = ".pore_pressure";  // join_pore_pressures() has it in the load before
  for (int k = 0; k < static_cast<int>(system.loads.size()); ++k) {
    const std::string& name = system.loads[static_cast<std::size_t>(k)].name;
    const bool is_joined = name.size() > joined.size() && name.substr(name.size() - joined.size()) == joined;
    const bool acts = !loads.begin.row(k).isZero(0.) || !loads.end.row(k).isZero(0.);
    if (acts && !is_joined && std::find(rows.begin(), rows.end(), k) == rows.end())
      throw InputError(input.place(dotted("loads", name)),
                       in_quotes(name) + " is no load of the model; its loads are " + join(names),
                       "reduce the case with all its loads, or let this one have factor = 0");
  }
}

/// Whether a prescribed uplift follows the force otherwise, or the case takes it from elsewhere.
bool has_other_uplift(const std::optional<ModelSliding>& of_case, const std::optional<ModelSliding>& of_model) {
  constexpr double written = 0.01;  // a peak has two digits or more
  const ModelSliding a = of_case.value_or(ModelSliding()), b = of_model.value_or(ModelSliding());
  const double most = std::max(a.uplift_per_force, b.uplift_per_force);
  return a.uplift != b.uplift || a.lag != b.lag || std::abs(a.uplift_per_force - b.uplift_per_force) > written * most;
}

/// Warning model_of_other_scene: only the loads' histories are of the case.
NumberedWarnings scene_warnings(const Case& input, const Simulation& simulation, const ReducedModelFile& model) {
  const std::string text = effective_case(input, ".");
  std::vector<std::string> names = tables_that_differ(model.case_text, text);
  append(names, actions_that_differ(model.case_text, text));
  if (has_other_uplift(sliding_of_case(input.scene, simulation), model.sliding)) names.emplace_back("sliding.uplift");
  if (names.empty()) return {};
  return {{"model_of_other_scene", static_cast<double>(names.size()), 0., "1",
           in_quotes(input.stem) +
               " is of another scene than the model, which answers the histories of its loads in "
               "its own: they differ in " +
               join(names, ", "),
           "reduce that case, too, or solve it by 'upbead run'"}};
}

WaveFile wave_of_case(const std::string& path, const ReducedModelFile& model) {
  Case input = case_with_loads(path);
  const Simulation simulation = simulation_of(input, settle_end(input));
  const System& system = simulation.system();
  const std::vector<int> rows = rows_of(model.modes.load_name, system);
  if (std::all_of(rows.begin(), rows.end(), [](int row) { return row < 0; }))
    throw InputError(input.place("loads"), "the case has no load of the model: " + join(model.modes.load_name),
                     "name a load as in the case that was reduced");
  const SampledLoads loads = sampled_loads(simulation.scene(), system);
  require_all_loads(input, system, loads, rows, model.modes.load_name);
  WaveFile wave = as_wave(input.stem, loads, rows);
  wave.rings_down = true;
  append(wave.notes.warnings, scene_warnings(input, simulation, model));
  append(wave.notes.warnings, warnings_of_case(input, simulation).loads);
  return wave;
}

}  // namespace

Command respond_cases_command() {
  return respond_command({model_of_case, wave_of_case});
}

}  // namespace upbead
