#include "cli/respond_cases.h"

#include <algorithm>
#include <iostream>

#include "base/text.h"
#include "case/case_run.h"
#include "case/input_files.h"
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

WaveFile wave_of_case(const std::string& path, const ReducedModelFile& model) {
  Case input = case_with_loads(path);
  const Simulation simulation = simulation_of(input, settle_end(input));
  const System& system = simulation.system();
  const std::vector<int> rows = rows_of(model.modes.load_name, system);
  if (std::all_of(rows.begin(), rows.end(), [](int row) { return row < 0; }))
    throw InputError(input.place("loads"), "the case has no load of the model: " + join(model.modes.load_name),
                     "name a load as in the case that was reduced");
  WaveFile wave = as_wave(input.stem, sampled_loads(simulation.scene(), system), rows);
  append(wave.notes.warnings, warnings_of_case(input, simulation).loads);
  return wave;
}

}  // namespace

Command respond_cases_command() {
  return respond_command({model_of_case, wave_of_case});
}

}  // namespace upbead
