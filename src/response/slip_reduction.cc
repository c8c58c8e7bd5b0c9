#include "response/slip_reduction.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "fem/caisson_readings.h"
#include "response/reduction.h"
#include "system/interface.h"

namespace upbead {

namespace {

/// F_T is cut off there for training, as friction would.
constexpr double cut_off = 0.7;
/// Per independent load: more cost more than what they are worth, as eigenvalues take the cube of their number.
constexpr int most_vectors = 60;

/// A history at other times, straight between its own.
Eigen::RowVectorXd at_times(const std::vector<double>& time, const Eigen::RowVectorXd& value,
                            const std::vector<double>& wanted) {
  Eigen::RowVectorXd result(static_cast<Eigen::Index>(wanted.size()));
  std::size_t next = 1;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    while (next + 1 < time.size() && time[next] < wanted[i]) ++next;
    const double part = std::clamp((wanted[i] - time[next - 1]) / (time[next] - time[next - 1]), 0., 1.);
    const auto n = static_cast<Eigen::Index>(next);
    result[static_cast<Eigen::Index>(i)] = (1. - part) * value[n - 1] + part * value[n];
  }
  return result;
}

/// One more load.
void add_row(SampledLoads& loads, const Eigen::RowVectorXd& at_times) {
  const Eigen::Index K = loads.begin.rows(), N = loads.begin.cols();
  for (Eigen::MatrixXd* part : {&loads.begin, &loads.end}) part->conservativeResize(K + 1, Eigen::NoChange);
  loads.begin.row(K) = at_times.head(N);
  loads.end.row(K) = at_times.tail(N);
}

/// The caisson that sticks against its glued twin, at the twin's own times.
double difference(const ModalModel& model, const System& system, const Series& glued, const Eigen::RowVectorXd& shear) {
  std::vector<TimeFunction> histories;
  for (const SystemLoad& load : system.loads) histories.push_back(load.history);
  const Eigen::RowVectorXd stuck = respond(model, sample(histories, glued.time)).reading.row(0);
  return (stuck - shear).cwiseAbs().maxCoeff() / shear.cwiseAbs().maxCoeff();
}

}  // namespace

SlipReduction reduce_slip(const Scene& scene, const CompiledScene& compiled, SlipUplift uplift, const Series& glued,
                          const std::function<void(double)>& progress) {
  if (!compiled.system.interface || !compiled.caisson)
    throw std::invalid_argument("a scene whose caisson slips needs an interface under it");
  System system = with_rigid_slip(compiled.system);
  const int slip = system.n_free() - 1;
  add_slip(system, slip);
  const Eigen::RowVectorXd shear = glued.reading.row(compiled.system.reading(reading::shear_force));
  const double limit = cut_off * shear.cwiseAbs().maxCoeff();

  ReduceOptions options;
  options.shift = krylov_shift(scene);
  options.exact = compiled.body_coordinates;
  options.exact.push_back(slip);
  options.training = sampled_loads(scene, compiled.system);
  add_row(options.training, at_times(glued.time, shear, options.training.time).cwiseMin(limit).cwiseMax(-limit));
  options.measured = {0, 1, 2, 3};
  options.tolerance = scene.tolerance;
  options.max_vectors = most_vectors;
  options.tolerance_of_others = std::numeric_limits<double>::infinity();
  options.progress = progress;
  options.model = [uplift](const ReducedSystem& reduced) {
    return stuck_and_free(reduced, slip_law(reduced, 1., uplift));
  };
  Reduction reduction = reduce(system, options);
  const double glued_error = difference(reduction.model, system, glued, shear);
  return {std::move(reduction.system), reduction.error,     glued_error,
          reduction.converged,         reduction.n_vectors, reduction.n_solves,
          reduction.factorise_seconds};
}

}  // namespace upbead
