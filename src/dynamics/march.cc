#include "upbead/dynamics/march.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "base/interrupt.h"
#include "dynamics/joined.h"
#include "dynamics/step_interior.h"
#include "system/part.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

Series empty_series(const System& system, int n) {
  return {{},
          Eigen::MatrixXd(static_cast<Eigen::Index>(system.readings.size()), n),
          Eigen::MatrixXd(static_cast<Eigen::Index>(system.loads.size()), n)};
}

void record(const System& system, const State& state, const std::vector<double>& load, const Vector* added,
            Series& series) {
  const auto column = static_cast<Eigen::Index>(series.time.size());
  series.time.push_back(state.time);
  for (std::size_t i = 0; i < system.readings.size(); ++i)
    series.reading(static_cast<Eigen::Index>(i), column) = evaluate(system.readings[i], state, load);
  if (added) series.reading.col(column) += *added;
  for (std::size_t k = 0; k < load.size(); ++k) series.load(static_cast<Eigen::Index>(k), column) = load[k];
}

void trim(Series& series) {
  const auto n = static_cast<Eigen::Index>(series.time.size());
  series.reading.conservativeResize(Eigen::NoChange, n);
  series.load.conservativeResize(Eigen::NoChange, n);
}

int n_in_steps(int n_steps) {
  return n_steps * static_cast<int>(inside_places.size());
}

/// Fills the first columns of an empty series.
void refill(const Series& so_far, Series& series) {
  const auto n = static_cast<Eigen::Index>(so_far.time.size());
  series.time = so_far.time;
  series.reading.leftCols(n) = so_far.reading;
  series.load.leftCols(n) = so_far.load;
}

void check_finite(const State& state) {
  if (std::isfinite(state.x.sum()) && std::isfinite(state.v.sum()) && std::isfinite(state.a.sum())) return;
  throw NumericsError("the state at t = " + std::to_string(state.time) + " s is not finite");
}

/// Stops a march once its energy has died away. In a divided system that energy is a sum over processes, the same on
/// all, so that all stop at once.
class EarlyStop {
 public:
  EarlyStop(const System& system, const Scheme& scheme, double end, double fraction)
      : system_(system), layout_(layout_of(system)), fraction_(fraction) {
    if (fraction > 0. && !scheme.accounts_energy())
      throw std::invalid_argument("stop_at_energy needs a scheme that accounts for energy");
    for (double kink : kinks(system))
      if (kink < end) last_kink_ = std::max(last_kink_, kink);
  }
  void recall(const std::vector<EnergyAccount>& so_far) {
    for (const EnergyAccount& energy : so_far) largest_ = std::max(largest_, energy.stored());
  }
  bool due(const EnergyAccount& energy, double time, double step) {
    if (fraction_ <= 0.) return false;
    const double stored = layout_.sum(energy.stored());
    largest_ = std::max(largest_, stored);
    return time > last_kink_ && stored < fraction_ * largest_ && loads_are_over(time, step);
  }

 private:
  bool loads_are_over(double time, double step) const {
    return std::all_of(system_.loads.begin(), system_.loads.end(), [&](const SystemLoad& load) {
      return load.history(time) == 0. && keeps_value(load.history, time, step);
    });
  }

  const System& system_;
  Layout layout_;
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
    if (scheme.order() >= 4) interior_.emplace(system);
    response_.inside = empty_series(system, interior_ ? n_in_steps(n_steps) : 0);
  }
  void add(const State& state) {
    check_finite(state);
    if (interior_ && response_.ends.time.empty())
      interior_->begin(state, 0.);
    else if (interior_)
      interior_->add_step(state, response_.inside);
    const Vector* added = scheme_.added_to_readings();
    record(system_, state, scheme_.end_load(), added, response_.ends);
    record(system_, scheme_.balanced().state, scheme_.balanced().load, added, response_.balanced);
    if (scheme_.accounts_energy()) response_.energy.push_back(scheme_.energy());
  }
  void recall(const Response& so_far) {
    refill(so_far.ends, response_.ends);
    refill(so_far.balanced, response_.balanced);
    refill(so_far.inside, response_.inside);
    response_.energy = so_far.energy;
    const std::vector<double>& time = so_far.ends.time;
    if (interior_) interior_->begin(so_far.final_state, time.size() > 1 ? time.back() - time[time.size() - 2] : 0.);
  }
  /// The results up to the latest step.
  Response so_far(const State& state) const { return complete(response_, state); }
  Response finish(const State& state) { return complete(std::move(response_), state); }

 private:
  static Response complete(Response response, const State& state) {
    trim(response.ends);
    trim(response.balanced);
    trim(response.inside);
    response.final_state = state;
    response.n_steps = static_cast<int>(response.ends.time.size()) - 1;
    return response;
  }

  const System& system_;
  const Scheme& scheme_;
  std::optional<StepInterior> interior_;
  Response response_;
};

const char* const no_fit = "the checkpoint does not belong to this scene";

/// Detects a checkpoint that was edited; a fingerprint guards against all other differences.
void require_fit(const MarchCheckpoint& checkpoint, const System& system, int n_steps, bool has_inside) {
  const Response& so_far = checkpoint.so_far;
  const auto fits = [&](const Series& series, std::size_t n) {
    return series.time.size() == n && series.reading.rows() == static_cast<Eigen::Index>(system.readings.size()) &&
           series.load.rows() == static_cast<Eigen::Index>(system.loads.size());
  };
  const std::size_t n = so_far.ends.time.size(),
                    n_within = has_inside && n > 0 ? n_in_steps(static_cast<int>(n) - 1) : 0;
  const bool fit = fits(so_far.ends, n) && fits(so_far.balanced, n) && fits(so_far.inside, n_within) &&
                   so_far.n_steps >= 0 && so_far.n_steps <= n_steps &&
                   so_far.final_state.x.size() == whole_size(system) &&
                   checkpoint.memory.balanced.load.size() == system.loads.size() &&
                   checkpoint.memory.end_load.size() == system.loads.size();
  if (!fit) throw NumericsError(no_fit);
}

/// A march between its steps.
class March {
 public:
  March(const System& system, Scheme& scheme, const TimeGrid& grid, const MarchOptions& options)
      : system_(system),
        scheme_(scheme),
        options_(options),
        layout_(layout_of(system)),
        keeps_(layout_.largest(options.checkpoints.due ? 1. : 0.) > 0.),
        n_steps_(grid.n_steps()),
        solves_(scheme.n_solves()),
        factorisations_(scheme.n_factorisations()),
        state_(at_rest(system)),
        recorder_(system, scheme, n_steps_),
        early_stop_(system, scheme, grid.end, options.stop_at_energy) {
    scheme.start(state_);
    if (options.checkpoints.resume_from)
      recall(*options.checkpoints.resume_from);
    else
      recorder_.add(state_);
    observe();
  }

  int n_done() const { return done_; }
  bool stopped() const { return stopped_; }

  /// Advances by at most n_left equal steps of h. Returns the number of steps taken.
  int advance(double time, double h, int n_left) {
    state_.time = time;
    const int leap = options_.leap;
    const int n = leap > 1 && leap <= n_left && scheme_.leap(state_, leap * h) ? leap : 1;
    if (n == 1) scheme_.advance(state_, h);
    recorder_.add(state_);
    done_ += n;
    if (keeps_ && is_due()) keep_checkpoint();
    observe();
    check_interrupt();  // marches without an observer may be long, too
    stopped_ = done_ < n_steps_ && early_stop_.due(scheme_.energy(), state_.time, h);
    return n;
  }

  Response finish() { return with_counts(recorder_.finish(state_)); }

 private:
  void observe() const {
    for (MarchObserver* observer : options_.observers) observer->see(state_, done_, n_steps_);
  }
  /// Where one process finds a checkpoint due, all keep it.
  bool is_due() const {
    const auto& due = options_.checkpoints.due;
    return layout_.largest(due && due() ? 1. : 0.) > 0.;
  }
  void keep_checkpoint() const {
    const MarchCheckpoint whole = joined(system_, checkpoint());
    if (options_.checkpoints.keep) options_.checkpoints.keep(whole);
    layout_.sum(0.);  // none ends the others, as an interrupt would, before it is written
  }
  MarchCheckpoint checkpoint() const {
    std::vector<double> observed;
    for (const MarchObserver* observer : options_.observers) {
      const std::vector<double> memory = observer->memory();
      observed.insert(observed.end(), memory.begin(), memory.end());
    }
    return {with_counts(recorder_.so_far(state_)), scheme_.memory(), observed};
  }
  void recall(const MarchCheckpoint& whole) {
    require_fit(whole, system_, n_steps_, scheme_.order() >= 4);
    const MarchCheckpoint checkpoint = restricted(system_, whole);
    const Response& so_far = checkpoint.so_far;
    state_ = so_far.final_state;
    scheme_.recall(checkpoint.memory);
    auto known = checkpoint.observed.begin();
    for (MarchObserver* observer : options_.observers) {
      const auto n = static_cast<std::ptrdiff_t>(observer->memory().size());
      if (checkpoint.observed.end() - known < n) throw NumericsError(no_fit);
      observer->recall({known, known + n});
      known += n;
    }
    recorder_.recall(so_far);
    early_stop_.recall(whole.so_far.energy);
    done_ = so_far.n_steps;
    solves_ -= so_far.n_solves;
  }
  Response with_counts(Response response) const {
    response.n_solves = scheme_.n_solves() - solves_;
    response.n_factorisations = scheme_.n_factorisations() - factorisations_;
    response.order = scheme_.order();
    response.stopped_early = stopped_;
    return response;
  }

  const System& system_;
  Scheme& scheme_;
  const MarchOptions& options_;
  Layout layout_;
  bool keeps_;  ///< checkpoints, on some process
  int n_steps_, solves_, factorisations_;
  State state_;
  Recorder recorder_;
  EarlyStop early_stop_;
  int done_ = 0;
  bool stopped_ = false;
};

}  // namespace

ObserverFunction progress_observer(std::function<void(double)> progress) {
  const auto tell = [progress = std::move(progress)](const State&, int step, int n_steps) {
    if (progress) progress(n_steps > 0 ? static_cast<double>(step) / n_steps : 1.);
  };
  return ObserverFunction(tell, false);
}

Response march(const System& system, Scheme& scheme, const TimeGrid& grid, const MarchOptions& options) {
  March march(system, scheme, grid, options);
  int first = 0;  // step of the segment
  for (const TimeSegment& segment : grid.segments) {
    for (int i = std::max(0, march.n_done() - first); i < segment.n_steps && !march.stopped();)  // sums of steps drift
      i += march.advance(segment.start + i * segment.step, segment.step, segment.n_steps - i);
    first += segment.n_steps;
  }
  Response response = march.finish();
  add_up(system, response);
  return response;
}

}  // namespace upbead
