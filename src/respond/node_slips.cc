#include "respond/node_slips.h"

#include <algorithm>

#include "base/progress.h"
#include "fem/caisson/reading_names.h"
#include "respond/respond_waves.h"
#include "respond/wave_contact.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// The wave as a file of the model's loads; its samples end at zero.
WaveFile file_of(const ReducedModelFile& model, int load, const WaveOnBottom& wave) {
  const auto n = static_cast<Eigen::Index>(wave.force.size());
  WaveFile file;
  file.n_loads = model.modes.n_loads();
  file.value = WaveSamples::Zero(file.n_loads, n);
  for (Eigen::Index i = 0; i < n; ++i) file.time.push_back(static_cast<double>(i) * wave.step);
  const double per_load = model.modes.feedthrough(model.modes.index(reading::force), load);
  file.value.row(load) = Eigen::Map<const Eigen::RowVectorXd>(wave.force.data(), n) / per_load;
  return file;
}

/// U, largest at the seaward edge and zero at the heel, as in a case.
UpliftLoad triangle(const Interface& interface, const std::vector<double>& time, const std::vector<double>& U) {
  const std::vector<double>& x = interface.position;
  UpliftLoad load;
  load.node = Vector::Zero(interface.n_nodes());
  const double heel = x.back();
  for (std::size_t i = 0; i < x.size(); ++i)
    load.node[static_cast<Eigen::Index>(i)] = interface.length[i] * (heel - x[i]);
  load.node /= load.node.sum();
  load.pressure = piecewise_linear(time, U);
  return load;
}

DearSlip slip_of(const WaveContacts& contacts, const ReadingsAt& demand, const ReducedModelFile& model, int load,
                 const WaveOnBottom& wave) {
  if (wave.push != 0.) return {0., 0., "still water at two levels has no contact node by node"};
  const WaveFile file = file_of(model, load, wave);
  const double end = file.time.back() + echo_of(model);
  const WaveGrid grid = make_wave_grid(file.time, wave.step, end);
  LoadsOfWave loads = contacts.loads_of(file, 0, end);
  loads.interface.friction = wave.friction;
  loads.interface.normal_force *= wave.weight / loads.interface.normal_force.sum();
  loads.uplift = {triangle(loads.interface, file.time, wave.uplift)};
  WaveResponse out;
  contacts.answer(loads, on_grid(file, 0, grid.time), grid, grid.equal ? &demand : nullptr, out);
  if (out.response && !out.contact->solved) return {};
  if (!out.contact || !out.contact->solved) return {0., 0., out.why_not_contact};
  const NodeContact& solved = *out.contact->solved;
  if (solved.end_velocity != 0.) return {0., 0., "it still slides when the wave is over"};
  return {std::max(solved.least_slip, 0.) * wave.mass_ratio, solved.ground->slip * wave.mass_ratio, ""};
}

}  // namespace

std::vector<DearSlip> node_slips(const ReducedModelFile& model, int load, const std::vector<WaveOnBottom>& waves) {
  std::vector<DearSlip> slips(waves.size());
  if (waves.empty()) return slips;
  const WaveContacts contacts(model, {});
  const ReadingsAt demand(contacts.demand(), waves.front().step);
  in_parallel(waves.size(), "sliding node by node",
              [&](std::size_t i) { slips[i] = slip_of(contacts, demand, model, load, waves[i]); });
  return slips;
}

}  // namespace upbead
