#include "upbead/dynamics/reduce.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "algebra/dense.h"
#include "dynamics/basis.h"
#include "dynamics/growing_model.h"

namespace upbead {

namespace {

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
  return basis.unit.asDiagonal() * product(basis.columns(), coordinates);
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

GrowingModel::GrowingModel(const System& system, const ReduceOptions& options, BasisRoom* room)
    : GrowingModel(std::static_pointer_cast<Looks>(room != nullptr ? room->basis(system, options)
                                                                   : std::make_shared<GrowingBasis>(system, options)),
                   options) {
  basis_ = std::static_pointer_cast<GrowingBasis>(looks_);
}

GrowingModel::GrowingModel(std::shared_ptr<Looks> looks, const ReduceOptions& options)
    : options_(options), looks_(std::move(looks)), loads_(trainings(options.training, options.each_load)) {
  out_.tolerance = options.tolerance;
  out_.tolerance_of_others = options.tolerance_of_others;
  out_.measured = options.measured;
  out_.n_independent_loads = looks_->n_independent_loads();
  out_.n_spared = looks_->has_looks() ? looks_->n_solves() : 0;
  out_.factorise_seconds = out_.n_spared > 0 ? 0. : looks_->factorise_seconds();
}

GrowingModel::~GrowingModel() = default;

const ReducedSystem& GrowingModel::system() const {
  return look_->system;
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

const Look& GrowingModel::look_at(std::size_t number) {
  const double usual = usual_vectors * out_.n_independent_loads;
  return looks_->look(number, [&](int n_vectors) {
    if (options_.progress) options_.progress(std::min(0.95, n_vectors / usual));
  });
}

void GrowingModel::prepare() {
  look_at(0);
}

void GrowingModel::train(const SampledLoads& training, const std::function<void(double)>& progress) {
  options_.training = training;
  options_.progress = progress;
  loads_ = trainings(training, options_.each_load);
}

bool GrowingModel::grow() {
  if (look_ != nullptr && (look_->exhausted || look_->next > options_.max_vectors * out_.n_independent_loads))
    return false;
  look_ = &look_at(n_looks_);
  out_.n_vectors = look_->n_vectors;
  out_.n_solves = look_->n_solves;
  Modes modes = options_.model ? Modes{options_.model(system()), {}} : basis_->modes(n_looks_, kept_by(options_));
  ++n_looks_;
  std::vector<Eigen::MatrixXd> now = responses(modes.model, loads_);
  compare_looks(modes.model, modes.kept, now);
  const bool converged = look_->exhausted || (!out_.history.empty() && meets(out_.error, options_));
  out_.converged = looks_->layout().largest(converged ? 1. : 0.) > 0.;  // none goes on without the others
  out_.model = std::move(modes.model);
  kept_ = std::move(modes.kept);
  before_ = std::move(now);
  return true;
}

Reduction GrowingModel::finish() {
  if (!out_.history.empty())
    out_.omega = agreed_frequency(coarse_, out_.model, options_.measured, transfer_tolerance * options_.tolerance,
                                  1. / options_.training.time.back(), 100. * options_.shift);
  else if (look_->exhausted)  // with all unknowns nothing is left out
    out_.omega = 100. * options_.shift;
  out_.system = system();
  out_.n_spared = std::min(out_.n_spared, out_.n_solves);
  const FieldBasis phi = options_.keep_pressures || options_.keep_states ? basis_->phi(*look_) : FieldBasis();
  if (options_.keep_pressures) out_.pressures = PressureModel{phi, of_pressures(options_, kept_, phi)};
  if (options_.keep_states) out_.states = StateModel{basis_->displacements(*look_), phi, std::move(kept_)};
  return std::move(out_);
}

Reduction reduce(const System& system, const ReduceOptions& options, BasisRoom* room) {
  GrowingModel model(system, options, room);
  while (!model.reduction().converged && model.grow()) {
  }
  return model.finish();
}

}  // namespace upbead
