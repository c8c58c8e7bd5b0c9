#include "upbead/dynamics/reduce.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "dynamics/growing_model.h"
#include "dynamics/projection.h"
#include "dynamics/state_space.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Vectors per independent load: at the first look, and at least so many from one look to the next, or a quarter of
/// what is there: a look takes the eigenvalues of a matrix four times as large as there are vectors.
constexpr int first_look = 24, vectors_between_looks = 6;
constexpr double usual_vectors = 46.;  ///< per independent load: a guess for people who wait
/// |H| may move by so many times the tolerance, as it is the smaller model that is wrong by so much.
constexpr double transfer_tolerance = 4.;
/// A reading counts as small where it stays below this part of the largest of its unit.
constexpr double small_reading = 1e-3;

/// The loads all together, then each alone.
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

/// Largest values of each reading, those of symmetric nothings lifted to a part of the largest of their unit.
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

/// Takes in how far the responses to one training lie apart.
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

/// The system with the velocities of those coordinates as its last readings.
ReducedSystem with_velocities(ReducedSystem system, const std::vector<int>& coordinate) {
  const Eigen::Index I = system.velocity.rows(), n = static_cast<Eigen::Index>(coordinate.size());
  for (Eigen::MatrixXd* rows : {&system.position, &system.velocity, &system.acceleration, &system.feedthrough})
    rows->conservativeResizeLike(Eigen::MatrixXd::Zero(I + n, rows->cols()));
  for (Eigen::Index i = 0; i < n; ++i) system.velocity(I + i, coordinate[i]) = 1.;
  system.reading_label.resize(static_cast<std::size_t>(I + n));
  return system;
}

/// Of the last look alone.
PressureModel model_of_pressures(const ReduceOptions& options, const ReducedSystem& system, const FieldBasis& phi) {
  ModalModel model = model_of(options, with_velocities(system, phi.coordinate));
  const auto n = static_cast<Eigen::Index>(phi.coordinate.size());
  model.reading = model.reading.bottomRows(n).eval();
  model.feedthrough = model.feedthrough.bottomRows(n).eval();
  model.impulse = model.impulse.bottomRows(n).eval();
  model.reading_label.assign(phi.coordinate.size(), {});
  return {phi, std::move(model)};
}

bool meets(const NestedError& error, const ReduceOptions& options) {
  return error.history <= options.tolerance && error.others <= options.tolerance_of_others;
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

void GrowingModel::compare_looks(const ModalModel& model, const std::vector<Eigen::MatrixXd>& now) {
  if (before_.empty()) return;
  out_.error = {0., 0., 0., Eigen::VectorXd::Zero(model.n_readings())};
  for (std::size_t i = 0; i < now.size(); ++i) compare(model, options_.measured, now[i], before_[i], out_.error);
  out_.history.emplace_back(out_.n_vectors, out_.error);
  coarse_ = std::move(out_.model);
}

bool GrowingModel::grow() {
  if (exhausted_ || target_ > most_) return false;
  SecondOrderKrylov& krylov = space_->krylov;
  const double usual = usual_vectors * out_.n_independent_loads;
  while (krylov.n_vectors() < target_ && !exhausted_) {
    exhausted_ = !krylov.extend();
    if (options_.progress) options_.progress(std::min(0.95, static_cast<double>(krylov.n_vectors()) / usual));
  }
  target_ += std::max(vectors_between_looks * out_.n_independent_loads, target_ / 4);
  out_.n_vectors = krylov.n_vectors();
  out_.n_solves = krylov.n_solves();
  space_->projection.extend();
  ModalModel model = model_of(options_, system());
  std::vector<Eigen::MatrixXd> now = responses(model, loads_);
  compare_looks(model, now);
  out_.converged = exhausted_ || (!out_.history.empty() && meets(out_.error, options_));
  out_.model = std::move(model);
  before_ = std::move(now);
  return true;
}

Reduction GrowingModel::finish() {
  if (!out_.history.empty())
    out_.omega = agreed_frequency(coarse_, out_.model, options_.measured, transfer_tolerance * options_.tolerance,
                                  1. / options_.training.time.back(), 100. * options_.shift);
  out_.system = system();
  if (options_.keep_pressures) out_.pressures = model_of_pressures(options_, out_.system, space_->krylov.phi());
  return std::move(out_);
}

Reduction reduce(const System& system, const ReduceOptions& options) {
  GrowingModel model(system, options);
  while (!model.reduction().converged && model.grow()) {
  }
  return model.finish();
}

}  // namespace upbead
