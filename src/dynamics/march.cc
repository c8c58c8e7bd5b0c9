#include "upbead/dynamics/march.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "upbead/base/error.h"

namespace upbead {

namespace {

Series empty_series(const System& system, int n) {
  return {{},
          Eigen::MatrixXd(static_cast<Eigen::Index>(system.readings.size()), n),
          Eigen::MatrixXd(static_cast<Eigen::Index>(system.loads.size()), n)};
}

void record(const System& system, const State& state, const std::vector<double>& load, Series& series) {
  const auto column = static_cast<Eigen::Index>(series.time.size());
  series.time.push_back(state.time);
  for (std::size_t i = 0; i < system.readings.size(); ++i)
    series.reading(static_cast<Eigen::Index>(i), column) = evaluate(system.readings[i], state, load);
  for (std::size_t k = 0; k < load.size(); ++k) series.load(static_cast<Eigen::Index>(k), column) = load[k];
}

void trim(Series& series) {
  const auto n = static_cast<Eigen::Index>(series.time.size());
  series.reading.conservativeResize(Eigen::NoChange, n);
  series.load.conservativeResize(Eigen::NoChange, n);
}

void check_finite(const State& state) {
  if (std::isfinite(state.x.sum()) && std::isfinite(state.v.sum()) && std::isfinite(state.a.sum())) return;
  throw NumericsError("the state at t = " + std::to_string(state.time) + " s is not finite");
}

/// Readings and energies of the whole, from those of each process.
void sum_over(const Processes& processes, Response& response) {
  for (Eigen::MatrixXd* readings : {&response.ends.reading, &response.balanced.reading})
    processes.sum(readings->data(), static_cast<int>(readings->size()));
  constexpr std::array terms = {&EnergyAccount::work,     &EnergyAccount::kinetic, &EnergyAccount::strain,
                                &EnergyAccount::fluid,    &EnergyAccount::drag,    &EnergyAccount::damping,
                                &EnergyAccount::radiated, &EnergyAccount::scheme,  &EnergyAccount::lifted,
                                &EnergyAccount::friction};
  std::vector<double> values;
  for (const EnergyAccount& account : response.energy)
    for (const auto term : terms) values.push_back(account.*term);
  processes.sum(values.data(), static_cast<int>(values.size()));
  auto next = values.begin();
  double largest_work = 0.;
  for (EnergyAccount& account : response.energy) {
    for (const auto term : terms) account.*term = *next++;
    account.largest_work = largest_work = std::max(largest_work, std::abs(account.work));
  }
}

/// Stops a march once its energy has died away.
class EarlyStop {
 public:
  EarlyStop(const System& system, const Scheme& scheme, double end, double fraction)
      : system_(system), fraction_(fraction) {
    if (fraction > 0. && !scheme.accounts_energy())
      throw std::invalid_argument("stop_at_energy needs a scheme that accounts for energy");
    if (fraction > 0. && system.is_divided())
      throw std::invalid_argument("stop_at_energy is not done on several processes");
    for (double kink : kinks(system))
      if (kink < end) last_kink_ = std::max(last_kink_, kink);
  }
  bool due(const EnergyAccount& energy, double time, double step) {
    largest_ = std::max(largest_, energy.stored());
    return fraction_ > 0. && time > last_kink_ && energy.stored() < fraction_ * largest_ && loads_are_over(time, step);
  }

 private:
  bool loads_are_over(double time, double step) const {
    return std::all_of(system_.loads.begin(), system_.loads.end(), [&](const SystemLoad& load) {
      return load.history(time) == 0. && keeps_value(load.history, time, step);
    });
  }

  const System& system_;
  double fraction_;
  double last_kink_ = 0.;
  double largest_ = 0.;
};

/// Fills a Response while the march goes on.
class Recorder {
 public:
  Recorder(const System& system, const Scheme& scheme, int n_steps) : system_(system), scheme_(scheme) {
    response_.ends = empty_series(system, n_steps + 1);
    response_.balanced = empty_series(system, n_steps + 1);
  }
  void add(const State& state) {
    check_finite(state);
    record(system_, state, scheme_.end_load(), response_.ends);
    record(system_, scheme_.balanced().state, scheme_.balanced().load, response_.balanced);
    if (scheme_.accounts_energy()) response_.energy.push_back(scheme_.energy());
  }
  Response finish(State state, bool stopped_early) {
    trim(response_.ends);
    trim(response_.balanced);
    response_.final_state = std::move(state);
    response_.n_steps = static_cast<int>(response_.ends.time.size()) - 1;
    response_.stopped_early = stopped_early;
    return std::move(response_);
  }

 private:
  const System& system_;
  const Scheme& scheme_;
  Response response_;
};

}  // namespace

Response march(const System& system, Scheme& scheme, const TimeGrid& grid, const MarchOptions& options) {
  const int n_steps = grid.n_steps(), solves = scheme.n_solves(), factorisations = scheme.n_factorisations();
  State state = at_rest(system);
  scheme.start(state);
  Recorder recorder(system, scheme, n_steps);
  EarlyStop early_stop(system, scheme, grid.end, options.stop_at_energy);
  int step = 0;
  const auto note = [&] {
    recorder.add(state);
    if (options.observer) options.observer(state, step, n_steps);
    ++step;
  };
  note();
  bool stopped = false;
  for (const TimeSegment& segment : grid.segments) {
    for (int i = 0; i < segment.n_steps && !stopped; ++i) {
      state.time = segment.start + i * segment.step;  // the sum of many steps would drift off the kinks
      scheme.advance(state, segment.step);
      note();
      stopped = step <= n_steps && early_stop.due(scheme.energy(), state.time, segment.step);
    }
  }
  Response response = recorder.finish(std::move(state), stopped);
  if (system.is_divided()) sum_over(*system.sharing.processes, response);
  response.n_solves = scheme.n_solves() - solves;
  response.order = scheme.order();
  response.n_factorisations = scheme.n_factorisations() - factorisations;
  return response;
}

}  // namespace upbead
