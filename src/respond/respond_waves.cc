#include "respond/respond_waves.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "base/progress.h"
#include "base/text.h"
#include "dynamics/answer_error.h"
#include "fem/caisson/reading_names.h"
#include "output/wave_response.h"
#include "respond/answer_step.h"
#include "respond/respond_slip.h"
#include "respond/wave_circles.h"
#include "respond/wave_contact.h"
#include "respond/wave_grid.h"
#include "respond/wave_reading.h"
#include "upbead/base/error.h"
#include "upbead/base/still_water.h"
#include "upbead/sliding/base_pressure.h"

namespace upbead {

namespace {

/// Sets the peaks and the ratio from P and F_T at those times. `smooth`: F_T has no kinks, so that its peaks may be
/// interpolated between the times.
void set_peaks(const std::vector<double>& time, const Eigen::RowVectorXd& P, const Eigen::RowVectorXd& F, bool smooth,
               WaveResponse& out);

struct Peak {
  double time = 0., value = 0.;
};

/// The largest sample; where `smooth` and its neighbours are equally far, the top of the parabola through all three.
Peak largest(const std::vector<double>& time, const Eigen::RowVectorXd& y, bool smooth) {
  Eigen::Index n = 0;
  const double top = y.maxCoeff(&n);
  const auto at = static_cast<std::size_t>(n);
  if (!smooth || n == 0 || n + 1 == y.size()) return {time[at], top};
  const double before = time[at] - time[at - 1], after = time[at + 1] - time[at];
  if (std::abs(after - before) > 1e-6 * before) return {time[at], top};
  const double slope = (y[n + 1] - y[n - 1]) / 2., bend = y[n + 1] - 2. * top + y[n - 1];
  if (!(bend < 0.)) return {time[at], top};
  const double aside = -slope / bend;  // in steps, between -1/2 and 1/2
  return {time[at] + aside * after, top + 0.5 * aside * slope};
}

void set_peaks(const std::vector<double>& time, const Eigen::RowVectorXd& P, const Eigen::RowVectorXd& F, bool smooth,
               WaveResponse& out) {
  const Peak landward = largest(time, F, smooth);
  out.peak_force = P.maxCoeff();
  out.peak_shear = landward.value;
  out.peak_shear_time = landward.time;
  out.peak_shear_seaward = -largest(time, -F, smooth).value;
  out.peak_force_seaward = P.minCoeff();
  const bool seaward = -out.peak_force_seaward > out.peak_force;
  const double force = seaward ? out.peak_force_seaward : out.peak_force;
  if (force != 0.) out.ratio = (seaward ? out.peak_shear_seaward : out.peak_shear) / force;
}

constexpr double most_numbers = 1e8;  // values of P in one file; with F_T and the file, 5 GB of memory

/// Checks of waves with one number of samples and one step.
struct WaveChecks {
  BandCheck band;
  std::optional<ResponseError> error;  ///< none where the model has no larger models
};

/// Checks by number of samples and step: files with the same times share them, as they are expensive to make.
class AllWaveChecks {
 public:
  AllWaveChecks(const ReducedModelFile& model, const ModalModel& shear, int n_waves)
      : model_(model), shear_(shear), n_waves_(n_waves) {}

  std::shared_ptr<const WaveChecks> of(const std::vector<double>& time) {
    const int n = static_cast<int>(time.size());
    std::shared_ptr<const WaveChecks>& checks = made_[{n, time[1]}];
    if (checks) return checks;
    WaveChecks made{{shear_, 0, time[1], n, 2. * pi * model_.highest_frequency}, {}};
    if (model_.nested) made.error.emplace(shear_, 0, *model_.nested, time[1], n, n_waves_);
    return checks = std::make_shared<const WaveChecks>(std::move(made));
  }

 private:
  const ReducedModelFile& model_;
  const ModalModel& shear_;
  int n_waves_;  ///< of all files
  std::map<std::pair<int, double>, std::shared_ptr<const WaveChecks>> made_;
};

/// Upward on the caisson per unit of each load; zero in models without that reading.
Eigen::RowVectorXd vertical_forces(const ModalModel& modes) {
  for (std::size_t r = 0; r < modes.reading_label.size(); ++r)
    if (modes.reading_label[r].name == reading::force_vertical)
      return modes.feedthrough.row(static_cast<Eigen::Index>(r));
  return Eigen::RowVectorXd::Zero(modes.n_loads());
}

/// The base under the W' that is asked for, which stands as far from the middle as that of the model's case; what still
/// water at two levels adds stays (findings/effective_base.cc).
ModelBase base_with(const ReducedModelFile& model, const std::optional<ModelSliding>& sliding) {
  ModelBase base = *model.base;
  if (!sliding || sliding->submerged_weight == base.weight) return base;
  const StillWater still = model.still.value_or(StillWater());
  const double of_water = still.push_moment + still.weight * base.width / 6., own = base.weight - still.weight;
  const double ratio = (sliding->submerged_weight - still.weight) / own;
  base.weight = sliding->submerged_weight;
  base.weight_moment = ratio * (base.weight_moment - of_water) + of_water;
  return base;
}

/// What loads that act up or down alone put on the caisson per unit of each load, as in findings/effective_base.cc.
struct UprightLoads {
  Eigen::RowVectorXd down, moment;  ///< zero for all other loads
  bool known = true;                ///< false: the file is of before their moments
  bool any() const { return !down.isZero(0.); }
};

UprightLoads upright_loads(const ReducedModelFile& model) {
  constexpr double upright = 1e-9;  // of a force: what its other part may be
  const Eigen::Index n = model.modes.n_loads();
  const Eigen::RowVectorXd up = vertical_forces(model.modes),
                           P = model.modes.feedthrough.row(model.modes.index(reading::force));
  UprightLoads found{Eigen::RowVectorXd::Zero(n), Eigen::RowVectorXd::Zero(n)};
  for (Eigen::Index k = 0; k < n; ++k) {
    if (up[k] == 0. || !(std::abs(P[k]) <= upright * std::abs(up[k]))) continue;
    const std::optional<double>& moment = model.loads[static_cast<std::size_t>(k)].moment;
    found.known = found.known && moment;
    found.down[k] = -up[k];
    found.moment[k] = moment.value_or(0.);
  }
  return found;
}

/// Effective forces and pressures on the base, at the times of a grid.
class BaseAnswer {
 public:
  BaseAnswer(const ReducedModelFile& model, const std::optional<ModelSliding>& sliding, const WaveGrid& grid)
      : base_(base_with(model, sliding)),
        upright_(upright_loads(model)),
        normal_(one_reading(model.modes, reading::normal_force), grid),
        moment_(one_reading(model.modes, reading::base_moment), grid),
        uplift_(one_reading(model.modes, reading::uplift), grid),
        uplift_moment_(one_reading(model.modes, reading::uplift_moment), grid) {}

  /// `prescribed`: an uplift in addition to the computed one; empty: none. `seaward`: of waves on the landward wall
  /// alone, under which it is largest at that edge.
  EffectiveBase answer(const WaveSamples& loads, const WaveGrid& grid, bool ends_at_zero,
                       const Eigen::RowVectorXd& prescribed, bool seaward) const {
    const auto of = [&](const WaveReading& reading) { return reading.answer(loads, grid, ends_at_zero); };
    const Eigen::RowVectorXd N = of(normal_), M = of(moment_);
    Eigen::RowVectorXd U = of(uplift_), M_U = of(uplift_moment_);
    if (prescribed.size() > 0) {
      U += prescribed;
      M_U += (seaward ? -1. : 1.) * std::abs(base_.uplift_moment_per_force) * prescribed;
    }
    const auto list = [](const Eigen::RowVectorXd& row) { return std::vector<double>(row.begin(), row.end()); };
    const Eigen::RowVectorXd force = (N - U).array() + base_.weight, moment = (M + M_U).array() + base_.weight_moment;
    EffectiveBase base{base_.width, base_.weight, base_.weight_moment, base_.push,  base_.push_moment,
                       list(U),     list(M_U),    list(force),         list(moment)};
    if (!upright_.any()) return base;
    base.vertical = list(upright_.down * loads);
    base.vertical_moment = list(upright_.moment * loads);
    return base;
  }

  bool knows_upright_loads() const { return upright_.known; }

 private:
  ModelBase base_;
  UprightLoads upright_;
  WaveReading normal_, moment_, uplift_, uplift_moment_;
};

/// Tolerable error of a response between its times, as a share of the model's tolerance.
constexpr double of_tolerance = 0.02;

/// What the waves of all files have in common.
struct Common {
  Common(const ReducedModelFile& reduced, const RespondOptions& asked, int n_waves)
      : model(reduced),
        options(asked),
        shear(one_reading(model.modes, reading::shear_force)),
        checks(reduced, shear, n_waves) {
    const double tolerance = of_tolerance * model.tolerance;
    resolved = {{&shear, tolerance}};
    if (model.nested)
      for (const ModalModel* larger : {&model.nested->middle, &model.nested->reference})
        resolved.push_back({larger, tolerance});
    if (asks_for_base()) {
      for (const char* name : {reading::normal_force, reading::uplift, reading::base_moment, reading::uplift_moment})
        of_base.push_back(one_reading(model.modes, name));
      for (std::size_t i = 0; i < of_base.size(); ++i)
        resolved.push_back({&of_base[i], tolerance * (i < 2 ? 1. : model.base->width)});
    }
    if (model.contact) contacts.emplace(model, options.sliding);
    if (!options.sliding) return;
    why_no_slip = options.why_no_slip;
    if (!model.slip) return;
    try {
      slips.emplace(model, *options.sliding);
    } catch (const NumericsError& error) {
      why_no_slip = error.what();
    }
  }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;

  /// Whether S or slip circles need what presses on the base, whose uplift is known.
  bool asks_for_base() const { return model.base && (options.sliding || (model.circles && !model.sliding)); }

  const ReducedModelFile& model;
  const RespondOptions& options;
  ModalModel shear;
  std::vector<ModalModel> of_base;        ///< readings of the base, where S is asked for
  std::vector<ResolvedReading> resolved;  ///< readings that the times must resolve
  AllWaveChecks checks;
  std::optional<WaveSlips> slips;
  std::optional<WaveContacts> contacts;  ///< where the model has contact node by node
  std::string why_no_slip;               ///< the same for all waves
};

/// The longest step (s) that resolves the responses: a fiftieth of the case's shortest load, or less where LineMisses
/// requires it. A twentieth of the period of the highest frequency resolves all that the model contains, so the step
/// need not be shorter.
double longest_step(const Common& common, const WaveFile& file) {
  double of_loads = infinity, own = 0.;
  for (const ModelLoad& load : common.model.loads)
    if (load.duration > 0.) of_loads = std::min(of_loads, load.duration / 50.);
  for (std::size_t n = 1; n < file.time.size(); ++n) own = std::max(own, file.time[n] - file.time[n - 1]);
  const double shortest = std::min(1. / (20. * common.model.highest_frequency), of_loads);
  if (own <= shortest || !(shortest < of_loads) || of_loads == infinity) return shortest;
  return answer_step(common.resolved, file, shortest, of_loads);
}

/// What the waves of one file have in common, and their results.
class FileWork {
 public:
  FileWork(Common& common, const WaveFile& file)
      : model_(common.model),
        shear_(common.shear),
        file_(file),
        options_(common.options),
        force_(model_.modes.feedthrough.row(model_.modes.index(reading::force))),
        lift_(vertical_forces(model_.modes)),
        longest_step_(longest_step(common, file)),
        end_(options_.end.value_or(whole_answer(model_, file))),
        grid_(make_wave_grid(file.time, longest_step_, end_)),
        check_time_(equal_times(grid_, longest_step_, std::max(file.time.back(), grid_.time.back()))),
        checks_(common.checks.of(check_time_)),
        shear_answer_(shear_, grid_),
        histories_(model_.modes, options_.histories, grid_) {
    if (options_.sliding && options_.sliding->uplift == "computed")
      uplift_.emplace(one_reading(model_.modes, reading::uplift), grid_);
    if (common.asks_for_base()) base_.emplace(model_, options_.sliding, grid_);
    if (base_ && model_.circles) circles_.emplace(*model_.circles, grid_);
    if (common.contacts) contacts_ = &*common.contacts;
    if (contacts_ != nullptr && grid_.equal) demand_.emplace(contacts_->demand(), *grid_.equal);
    if (common.slips) slip_ = common.slips->of_step(grid_.equal.value_or(longest_step_));
    const double n = static_cast<double>(grid_.time.size()) * file.n_waves() *
                     static_cast<double>(1 + options_.histories.names.size());
    if (n > most_numbers)
      throw InputError(Place(),
                       "the answers to the waves of '" + file.name + "' are " + significant(n) +
                           " numbers, more than " + significant(most_numbers),
                       "lower --end, or spread the waves over several files");
    result_.name = file.name;
    result_.time = grid_.time;
    result_.force.resize(file.n_waves(), static_cast<Eigen::Index>(grid_.time.size()));
    result_.shear_force.resizeLike(result_.force);
    result_.histories = histories_.empty(file.n_waves(), grid_);
    result_.waves.resize(static_cast<std::size_t>(file.n_waves()));
    for (WaveResponse& wave : result_.waves) wave.why_not_coupled = common.why_no_slip;
  }

  WaveResponses take() { return std::move(result_); }

  /// May be called for different waves at the same time.
  void answer(int wave) {
    const WaveSamples loads = on_grid(file_, wave, grid_.time);
    const Eigen::RowVectorXd P = force_ * loads;
    const bool ends_at_zero = !grid_.last || loads.col(static_cast<Eigen::Index>(*grid_.last)).isZero(0.);
    const bool begins_at_zero = loads.col(static_cast<Eigen::Index>(grid_.first)).isZero(0.);
    const Eigen::RowVectorXd F = shear_answer_.answer(loads, grid_, ends_at_zero);
    if (!F.allFinite() || !P.allFinite())
      throw NumericsError("the response to a wave of '" + file_.name + "' is not finite; nothing was written");
    result_.force.row(wave) = P;
    result_.shear_force.row(wave) = F;
    histories_.answer(loads, grid_, ends_at_zero, wave, result_.histories);
    WaveResponse& out = result_.waves[static_cast<std::size_t>(wave)];
    // Kinks of the loads make no kinks in F_T, as long as the loads do not jump.
    set_peaks(grid_.time, P, F, begins_at_zero && ends_at_zero && shear_.feedthrough.isZero(0.), out);
    set_checks(check_time_ == grid_.time ? loads : on_grid(file_, wave, check_time_), F, out);
    Eigen::RowVectorXd prescribed;
    if (options_.sliding && !uplift_ && options_.sliding->uplift != "none")
      prescribed = uplift_of_force(*options_.sliding, grid_.time, P);
    if (options_.sliding) set_sliding(loads, prescribed, F, ends_at_zero, out);
    if (base_) set_base(loads, prescribed, F, ends_at_zero, out);
    if (contacts_ != nullptr)
      contacts_->answer(file_, wave, end_, loads, grid_, demand_ && ends_at_zero ? &*demand_ : nullptr, out);
  }

 private:
  void set_checks(const WaveSamples& loads, const Eigen::RowVectorXd& F, WaveResponse& out) const {
    const double peak = F.cwiseAbs().maxCoeff();
    if (peak > 0.) out.beyond_band = checks_->band.beyond(loads) / peak;
    if (checks_->error) out.error_estimate = peak > 0. ? checks_->error->of(loads).bound() / peak : 0.;
  }

  void set_sliding(const WaveSamples& loads, const Eigen::RowVectorXd& prescribed, const Eigen::RowVectorXd& F,
                   bool batch, WaveResponse& out) const {
    const ModelSliding& bottom = *options_.sliding;
    Eigen::RowVectorXd computed;
    if (uplift_) computed = uplift_->answer(loads, grid_, batch);
    const Eigen::RowVectorXd& U = uplift_ ? computed : prescribed;
    out.sliding = sliding_distance(bottom, model_.caisson_mass, grid_.time, F, U);
    if (slip_) {
      SlipOfWave slip = slip_of_wave(*slip_, loads, grid_, batch && grid_.equal.has_value(), bottom, prescribed);
      out.coupled = slip.coupled;
      out.why_not_coupled = std::move(slip.why_not);
    }
    const Eigen::Index last = grid_.last ? static_cast<Eigen::Index>(*grid_.last) : loads.cols() - 1;
    const double force = (force_ * loads.col(last)).value() + bottom.push,
                 normal = bottom.submerged_weight - (U.size() > 0 ? U[last] : 0.) - (lift_ * loads.col(last)).value();
    const bool slid = *out.sliding != 0. || (out.coupled && out.coupled->largest != 0.);
    out.slides_on = slid && !(normal > 0. && std::abs(force) <= bottom.friction * normal);
  }

  /// As warnings_of_pores() of a run asks: contact node by node has the pores' uplift itself.
  void set_left_out(const EffectiveBase& base, const Eigen::RowVectorXd& F, WaveResponse& out) const {
    constexpr double counts = 0.05;  // of W'
    const ModelSliding& bottom = *options_.sliding;
    const double U = *std::max_element(base.uplift.begin(), base.uplift.end());
    if (bottom.uplift != "none" || model_.contact || !(U > counts * bottom.submerged_weight)) return;
    out.left_out_uplift = U;
    out.slides_by_left_out_uplift =
        F.cwiseAbs().maxCoeff() + bottom.friction * U > bottom.friction * bottom.submerged_weight;
  }

  void set_base(const WaveSamples& loads, const Eigen::RowVectorXd& prescribed, const Eigen::RowVectorXd& shear,
                bool batch, WaveResponse& out) const {
    const EffectiveBase base = base_->answer(loads, grid_, batch, prescribed, pushes_seaward_alone(force_ * loads));
    const Eigen::RowVectorXd F = shear.array() + base.push;
    if (circles_) out.circle = circles_->answer(loads, grid_, batch, base, F);
    if (const EdgeStress least = least_edge_stress(base, grid_.time); least.stress < 0.) out.tension = least;
    if (!options_.sliding) return;
    const BaseExtremes worst = base_extremes(base, grid_.time);
    set_left_out(base, F, out);
    out.peak_heel_pressure = worst.peak_heel_pressure;
    out.peak_toe_pressure = worst.peak_toe_pressure;
    if (base_->knows_upright_loads()) out.least_overturning_margin = worst.least_overturning_margin;
    out.least_sliding_factor = least_sliding_factor(options_.sliding->friction, base, F, 1.);
    out.least_sliding_factor_seaward = least_sliding_factor(options_.sliding->friction, base, F, -1.);
  }

  const ReducedModelFile& model_;
  const ModalModel& shear_;
  const WaveFile& file_;
  const RespondOptions& options_;
  Eigen::RowVectorXd force_, lift_;  ///< P, and the force upward, per unit of each load
  double longest_step_, end_;
  WaveGrid grid_;
  std::vector<double> check_time_;  ///< equally spaced, and over the whole wave even where the response ends before it
  std::shared_ptr<const WaveChecks> checks_;
  WaveReading shear_answer_;
  WaveHistories histories_;
  std::optional<BaseAnswer> base_;          ///< where S is asked for and the model has readings of the base
  std::optional<WaveCircles> circles_;      ///< where the model has circles and readings of the base
  std::optional<WaveReading> uplift_;       ///< where S is asked for, with the model's pore pressure
  std::shared_ptr<const WaveSlip> slip_;    ///< where S is asked for and the model has a slip part
  const WaveContacts* contacts_ = nullptr;  ///< where the model has contact node by node
  std::optional<ReadingsAt> demand_;        ///< of it
  WaveResponses result_;
};

void require_caisson(const ModalModel& modes) {
  const auto has = [&modes](const char* name) {
    return std::any_of(modes.reading_label.begin(), modes.reading_label.end(),
                       [name](const ReadingLabel& label) { return label.name == name; });
  };
  if (!has(reading::shear_force) || !has(reading::force))
    throw InputError(Place(), "the model has no readings 'force' and 'shear_force': its mesh has no surface 'caisson'",
                     "reduce a case with a caisson");
}

/// One that decays within a period does not.
bool swings_on(const std::complex<double>& pole) {
  return std::abs(pole.real()) < std::abs(pole.imag());
}

}  // namespace

double swing_period_of(const ModalModel& modes) {
  const Eigen::RowVectorXcd shear = modes.reading.row(modes.index(reading::shear_force));
  double period = 0., most = 0.;
  for (Eigen::Index m = 0; m < modes.pole.size(); ++m) {
    const double part = std::abs(shear[m] / modes.pole[m]) * modes.load.row(m).cwiseAbs().maxCoeff();
    if (!swings_on(modes.pole[m]) || part <= most) continue;
    most = part;
    period = 2. * pi / std::abs(modes.pole[m].imag());
  }
  return period;
}

double echo_of(const ReducedModelFile& model) {
  double period = 0., load = 0.;
  for (const std::complex<double>& pole : model.modes.pole)
    if (swings_on(pole)) period = std::max(period, 2. * pi / std::abs(pole.imag()));
  for (const ModelLoad& one : model.loads) load = std::max(load, one.duration);
  return std::clamp(model.end - load, of_rebound * swing_period_of(model.modes), 3. * period);
}

double whole_answer(const ReducedModelFile& model, const WaveFile& file) {
  return end_of_answer(file, model.end, echo_of(model));
}

std::vector<WaveResponses> respond_to_waves(const ReducedModelFile& model, const std::vector<WaveFile>& files,
                                            const RespondOptions& options) {
  require_caisson(model.modes);
  const int n_waves = std::accumulate(files.begin(), files.end(), 0,
                                      [](int sum, const WaveFile& file) { return sum + file.n_waves(); });
  Common common(model, options, n_waves);
  std::vector<std::unique_ptr<FileWork>> work;
  std::vector<std::pair<FileWork*, int>> pieces;
  for (const WaveFile& file : files) {
    work.push_back(std::make_unique<FileWork>(common, file));
    for (int w = 0; w < file.n_waves(); ++w) pieces.emplace_back(work.back().get(), w);
  }
  in_parallel(pieces.size(), "responding", [&pieces](std::size_t i) { pieces[i].first->answer(pieces[i].second); });
  std::vector<WaveResponses> responses;
  for (const auto& file : work) responses.push_back(file->take());
  return responses;
}

}  // namespace upbead
