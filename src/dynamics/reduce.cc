#include "upbead/dynamics/reduce.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "dynamics/growing_model.h"
#include "dynamics/projection.h"
#include "dynamics/state_space.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Vectors per independent load at the first look, and the fewest from one look to the next, where a quarter of the
/// present number is added if that is more: a look takes the eigenvalues of a matrix four times as large as there are
/// vectors.
constexpr int first_look = 24, vectors_between_looks = 6;
constexpr double usual_vectors = 46.;  ///< per independent load: a guess, to show the progress
/// |H| may differ by this multiple of the tolerance, as it is the smaller model that is wrong by so much.
constexpr double transfer_tolerance = 4.;
/// A reading counts as small where it stays below this part of the largest of its unit.
constexpr double small_reading = 1e-3;

/// All loads together, then each load alone.
std::vector<SampledLoads> trainings(const SampledLoads& all, bool each_load) {
  std::vector<SampledLoads> list{all};
  for (Eigen::Index k = 0; each_load && all.begin.rows() > 1 && k < all.begin.rows(); ++k) {
    SampledLoads alone = all;
    for (Eigen::MatrixXd* part : {&alone.begin, &alone.end}) {
      part->setZero();
      part->row(k) = (part == &alone.begin ? all.begin : all.end).row(k);
    }
    list.push_back(std::move(alone));
  }
  return list;
}

std::vector<Eigen::MatrixXd> responses(const ModalModel& model, const std::vector<SampledLoads>& loads) {
  std::vector<Eigen::MatrixXd> list;
  for (const SampledLoads& load : loads) list.push_back(respond(model, load).reading);
  return list;
}

/// Largest value of each reading; a reading that is zero by symmetry gets a share of the largest value of its unit.
Eigen::VectorXd scales(const ModalModel& model, const Eigen::MatrixXd& y) {
  std::map<std::string, double> of_unit;
  Eigen::VectorXd scale = y.cwiseAbs().rowwise().maxCoeff();
  for (Eigen::Index i = 0; i < scale.size(); ++i) {
    double& largest = of_unit[model.reading_label[i].unit];
    largest = std::max(largest, scale[i]);
  }
  for (Eigen::Index i = 0; i < scale.size(); ++i)
    scale[i] = std::max(scale[i], small_reading * of_unit[model.reading_label[i].unit]);
  return scale;
}

/// Adds to `error` the differences between the responses of two models to one training.
void compare(const ModalModel& model, const std::vector<int>& measured, const Eigen::MatrixXd& fine,
             const Eigen::MatrixXd& coarse, NestedError& error) {
  const Eigen::VectorXd scale = scales(model, fine), difference = (fine - coarse).cwiseAbs().rowwise().maxCoeff();
  for (Eigen::Index i = 0; i < scale.size(); ++i) {
    if (scale[i] == 0.) continue;
    const bool is_measured = std::find(measured.begin(), measured.end(), i) != measured.end();
    error.of_reading[i] = std::max(error.of_reading[i], difference[i] / scale[i]);
    double& largest = is_measured ? error.history : error.others;
    largest = std::max(largest, error.of_reading[i]);
    if (!is_measured) continue;
    const double up = std::abs(fine.row(i).maxCoeff() - coarse.row(i).maxCoeff());
    const double down = std::abs(fine.row(i).minCoeff() - coarse.row(i).minCoeff());
    error.peak = std::max({error.peak, up / scale[i], down / scale[i]});
  }
}

ModalModel model_of(const ReduceOptions& options, const ReducedSystem& system) {
  return options.model ? options.model(system) : modal_model(state_space(system), system);
}

/// The coordinates that are kept as readings of their own, besides those of the system; -1 stands for one that stays
/// 0.
struct KeptCoordinates {
  std::vector<int> position, velocity, acceleration;

  Eigen::Index count() const {
    return static_cast<Eigen::Index>(position.size() + velocity.size() + acceleration.size());
  }
};

KeptCoordinates kept_coordinates(const ReduceOptions& options, const ReducedSystem& system, const FieldBasis& phi) {
  if (options.keep_states) {
    std::vector<int> all(static_cast<std::size_t>(system.size()));
    std::iota(all.begin(), all.end(), 0);
    std::vector<int> moving = all;  // x'' of phi is never used, and x'' of a prescribed x' is in no model
    std::transform(all.begin(), all.end(), moving.begin(), [&](int i) { return system.is_phi[i] ? -1 : i; });
    return {all, all, moving};
  }
  if (options.keep_pressures) return {{}, phi.coordinate, {}};
  return {};
}

/// The system with the kept coordinates as its last readings.
ReducedSystem with_coordinates(ReducedSystem system, const KeptCoordinates& kept) {
  Eigen::Index row = system.velocity.rows();
  const Eigen::Index n = row + kept.count();
  for (Eigen::MatrixXd* rows : {&system.position, &system.velocity, &system.acceleration, &system.feedthrough})
    rows->conservativeResizeLike(Eigen::MatrixXd::Zero(n, rows->cols()));
  for (const auto& [rows, coordinates] : {std::pair{&system.position, &kept.position},
                                          {&system.velocity, &kept.velocity},
                                          {&system.acceleration, &kept.acceleration}})
    for (const int i : *coordinates) {
      if (i >= 0) (*rows)(row, i) = 1.;
      ++row;
    }
  system.reading_label.resize(static_cast<std::size_t>(n));
  return system;
}

/// Splits off the last n readings as a model of their own; `model` keeps all others.
ModalModel split_last(ModalModel& model, Eigen::Index n) {
  ModalModel last = model;
  const Eigen::Index rest = model.reading.rows() - n;
  const auto split = [rest, n](auto& from, auto& to) {
    to = from.bottomRows(n).eval();
    from.conservativeResize(rest, Eigen::NoChange);
  };
  split(model.reading, last.reading);
  split(model.feedthrough, last.feedthrough);
  split(model.impulse, last.impulse);
  last.reading_label.assign(static_cast<std::size_t>(n), {});
  model.reading_label.resize(static_cast<std::size_t>(rest));
  return last;
}

bool meets(const NestedError& error, const ReduceOptions& options) {
  return error.history <= options.tolerance && error.others <= options.tolerance_of_others &&
         error.states <= options.tolerance_of_states;
}

}  // namespace

double agreed_frequency(const ModalModel& coarse, const ModalModel& fine, const std::vector<int>& readings,
                        double tolerance, double decay, double largest) {
  constexpr int n = 200;
  constexpr double decades = 4.;
  double agreed = largest;
  for (const int i : readings)
    for (int k = 0; k < fine.n_loads(); ++k) {
      std::vector<double> omega, difference;
      double scale = 0.;
      for (int j = 0; j <= n; ++j) {
        omega.push_back(largest * std::pow(10., decades * (static_cast<double>(j) / n - 1.)));
        const std::complex<double> s(decay, omega.back()), H = fine.transfer(i, k, s);
        difference.push_back(std::abs(H - coarse.transfer(i, k, s)));
        scale = std::max(scale, std::abs(H));
      }
      for (std::size_t j = 0; j < omega.size() && omega[j] < agreed; ++j)
        if (difference[j] > tolerance * scale) agreed = j == 0 ? 0. : omega[j - 1];
    }
  return agreed;
}

Eigen::MatrixXd phi_velocities(const FieldBasis& basis, const Eigen::MatrixXd& coordinates) {
  return basis.unit.asDiagonal() * (basis.columns() * coordinates);
}

namespace {

/// Of the model of the kept coordinates only the velocities of phi.
ModalModel of_pressures(const ReduceOptions& options, ModalModel kept, const FieldBasis& phi) {
  if (!options.keep_states) return kept;
  const Eigen::Index all = kept.reading.rows() / 3;
  std::vector<Eigen::Index> rows;
  for (const int i : phi.coordinate) rows.push_back(all + i);
  kept.reading = kept.reading(rows, Eigen::all).eval();
  kept.feedthrough = kept.feedthrough(rows, Eigen::all).eval();
  kept.impulse = kept.impulse(rows, Eigen::all).eval();
  kept.reading_label.resize(rows.size());
  return kept;
}

NestedError compare(const ReduceOptions& options, const std::vector<Eigen::MatrixXd>& fine,
                    const std::vector<Eigen::MatrixXd>& coarse, const ModalModel& model) {
  NestedError error;
  error.of_reading = Eigen::VectorXd::Zero(model.n_readings());
  for (std::size_t i = 0; i < fine.size(); ++i) compare(model, options.measured, fine[i], coarse[i], error);
  return error;
}

}  // namespace

struct GrowingModel::Space {
  Space(const System& system, const ReduceOptions& options)
      : krylov(system, options.shift, options.exact, options.kept), projection(system, krylov) {}

  SecondOrderKrylov krylov;
  Projection projection;
};

GrowingModel::GrowingModel(const System& system, const ReduceOptions& options)
    : options_(options),
      space_(std::make_unique<Space>(system, options)),
      loads_(trainings(options.training, options.each_load)) {
  out_.tolerance = options.tolerance;
  out_.tolerance_of_others = options.tolerance_of_others;
  out_.measured = options.measured;
  out_.n_independent_loads = space_->krylov.n_independent_loads();
  out_.factorise_seconds = space_->krylov.factorise_seconds();
  most_ = options.max_vectors * out_.n_independent_loads;
  target_ = std::min(first_look * out_.n_independent_loads, most_);
}

GrowingModel::~GrowingModel() = default;

const ReducedSystem& GrowingModel::system() const {
  return space_->projection.reduced();
}

void GrowingModel::compare_looks(const ModalModel& model, const ModalModel& kept,
                                 const std::vector<Eigen::MatrixXd>& now) {
  if (before_.empty()) return;
  out_.error = compare(options_, now, before_, model);
  if (options_.keep_states && meets(out_.error, options_))
    out_.error.states = energy_distance(system(), respond_in_coordinates(kept, options_.training),
                                        respond_in_coordinates(kept_, options_.training));
  out_.history.emplace_back(out_.n_vectors, out_.error);
  coarse_ = std::move(out_.model);
}

void GrowingModel::reach_target() {
  SecondOrderKrylov& krylov = space_->krylov;
  const double usual = usual_vectors * out_.n_independent_loads;
  while (krylov.n_vectors() < target_ && !exhausted_) {
    exhausted_ = !krylov.extend();
    if (options_.progress) options_.progress(std::min(0.95, static_cast<double>(krylov.n_vectors()) / usual));
  }
  space_->projection.extend();
}

void GrowingModel::prepare() {
  reach_target();
}

void GrowingModel::train(const SampledLoads& training, const std::function<void(double)>& progress) {
  options_.training = training;
  options_.progress = progress;
  loads_ = trainings(training, options_.each_load);
}

bool GrowingModel::grow() {
  if ((exhausted_ && out_.n_vectors > 0) || target_ > most_) return false;
  reach_target();
  const SecondOrderKrylov& krylov = space_->krylov;
  target_ += std::max(vectors_between_looks * out_.n_independent_loads, target_ / 4);
  out_.n_vectors = krylov.n_vectors();
  out_.n_solves = krylov.n_solves();
  const KeptCoordinates coordinates = kept_coordinates(options_, system(), krylov.phi());
  ModalModel model = model_of(options_, coordinates.count() > 0 ? with_coordinates(system(), coordinates) : system());
  ModalModel kept = split_last(model, coordinates.count());
  std::vector<Eigen::MatrixXd> now = responses(model, loads_);
  compare_looks(model, kept, now);
  out_.converged = exhausted_ || (!out_.history.empty() && meets(out_.error, options_));
  out_.model = std::move(model);
  kept_ = std::move(kept);
  before_ = std::move(now);
  return true;
}

Reduction GrowingModel::finish() {
  if (!out_.history.empty())
    out_.omega = agreed_frequency(coarse_, out_.model, options_.measured, transfer_tolerance * options_.tolerance,
                                  1. / options_.training.time.back(), 100. * options_.shift);
  out_.system = system();
  const SecondOrderKrylov& krylov = space_->krylov;
  if (options_.keep_pressures)
    out_.pressures = PressureModel{krylov.phi(), of_pressures(options_, kept_, krylov.phi())};
  if (options_.keep_states) out_.states = StateModel{krylov.displacements(), krylov.phi(), std::move(kept_)};
  return std::move(out_);
}

Reduction reduce(const System& system, const ReduceOptions& options) {
  GrowingModel model(system, options);
  while (!model.reduction().converged && model.grow()) {
  }
  return model.finish();
}

}  // namespace upbead
