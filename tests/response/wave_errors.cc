#include "wave_errors.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/stopwatch.h"
#include "dynamics/answer_error.h"
#include "response/reduction.h"
#include "upbead/dynamics/modal_response.h"

namespace upbead::test {

namespace {

using Parameters = std::map<std::string, double>;

/// A section small enough for thousands of steps.
Parameters compact() {
  return {{"seabed_front", 40.}, {"seabed_back", 40.}, {"grading", 6.}};
}

void undamp(Scene& scene) {
  for (auto& [name, region] : scene.regions) region.damping.reset();
}

void drain(Scene& scene) {
  for (const char* region : {"seabed", "mound"}) {
    scene.regions[region].flow = Flow::drained;
    scene.regions[region].hydraulic_conductivity.reset();
  }
  for (auto& [name, side] : scene.boundaries) side.pressure.reset();
}

void absorb(Scene& scene) {
  for (const char* side : {"left", "right"}) scene.boundaries[side].displacement = DisplacementCondition::absorbing;
}

void make_elastic(Region& caisson) {
  caisson.kind = RegionKind::solid;
  caisson.deformation = Deformation::elastic;
  caisson.youngs_modulus = 3e9;
  caisson.poissons_ratio = 0.2;
  caisson.damping = Rayleigh{0.02, {2., 40.}};
}

/// The same straight lines, sampled at half the step.
Eigen::VectorXd halved(const Eigen::VectorXd& f) {
  Eigen::VectorXd all(2 * f.size() - 1);
  for (Eigen::Index i = 0; i < f.size(); ++i) all[2 * i] = f[i];
  for (Eigen::Index i = 0; i + 1 < f.size(); ++i) all[2 * i + 1] = 0.5 * (f[i] + f[i + 1]);
  return all;
}

/// `cut`: sample after which the load jumps to zero; negative: none.
Eigen::RowVectorXd marched(const Kernel& kernel, const Eigen::VectorXd& before, Eigen::Index cut) {
  Eigen::VectorXd after = before;
  if (cut < 0) return convolve(kernel, before, after).row(0);
  after[cut] = 0.;
  if (cut + 1 >= before.size()) return convolve(kernel, before, after).row(0);
  Eigen::VectorXd left = before;
  left.tail(before.size() - cut - 1).setZero();  // so that there is no line down to the next sample
  return convolve(kernel, left, after).row(0);
}

/// The model's response to the same load.
Eigen::RowVectorXd answer(const ModalModel& model, int reading, double step, const WaveSamples& loads,
                          Eigen::Index cut) {
  SampledLoads sampled;
  for (Eigen::Index i = 0; i < loads.cols(); ++i) sampled.time.push_back(static_cast<double>(i) * step);
  sampled.begin = loads.leftCols(loads.cols() - 1);
  sampled.end = loads.rightCols(loads.cols() - 1);
  if (cut >= 0 && cut < sampled.begin.cols()) sampled.begin.col(cut).setZero();
  return respond(model, sampled).reading.row(reading);
}

void change(const std::string& name, Scene& scene, Parameters& parameters) {
  if (name == "sand" || name == "sea" || name == "undamped" || name == "slow") return;
  if (name == "drained") return drain(scene);
  if (name == "layers") {  // soft ground, a stiff mound
    scene.regions["seabed"].shear_modulus = 8e6;
    scene.regions["mound"].shear_modulus = 1.2e8;
    parameters["seabed_depth"] = 8.;
  } else if (name == "absorbing") {
    absorb(scene);
  } else if (name == "elastic caisson") {
    make_elastic(scene.regions["caisson"]);
  } else if (name == "tall, dry") {
    drain(scene);
    undamp(scene);
    parameters["caisson_height"] = 24.;
    parameters["mound_height"] = 3.;
  } else {
    throw std::out_of_range("no scene '" + name + "'");
  }
}

}  // namespace

const std::vector<std::string>& error_scene_names() {
  static const std::vector<std::string> names{
      "sand", "sea", "undamped", "drained", "layers", "absorbing", "elastic caisson", "tall, dry", "slow"};
  return names;
}

ErrorScene error_scene(const std::string& name, double cells) {
  const double duration = name == "slow" ? 0.6 : name == "layers" ? 0.08 : 0.15;
  const double end = name == "slow" ? 2. : name == "tall, dry" ? 1.5 : 1.;
  ErrorScene made{name, breakwater(triangle(1e6, duration)), nullptr, duration, end};
  Parameters parameters = compact();
  if (name == "sea" || name == "slow") {
    add_sea(made.scene);
    for (const auto& [key, value] : with_sea()) parameters[key] = value;
  }
  if (name == "undamped") undamp(made.scene);
  change(name, made.scene, parameters);
  made.scene.time.end = end;
  made.mesh = breakwater_mesh(cells, parameters);
  return made;
}

WaveErrors::WaveErrors(const ErrorScene& scene, double steps, double length, unsigned seed)
    : compiled_(scene.scene, *scene.mesh),
      end_(scene.end),
      duration_(scene.duration),
      step_(scene.duration / steps),
      n_(static_cast<int>(std::ceil(length * end_ / step_)) + 1),
      shear_(compiled_.system.reading("shear_force")),
      records_({0.1 * end_, length * end_, std::max(0.1, 8. / steps) * duration_, 100. * duration_}, seed) {
  const Stopwatch reducing;
  reduction_ = reduce_scene(compiled_.resolved, compiled_.scene, {true, true, {}});
  require_converged(reduction_);
  reduce_seconds = reducing.seconds();
  const Stopwatch nesting;
  const NestedSpace space{krylov_shift(compiled_.resolved), reduction_.n_vectors, compiled_.scene.body_coordinates};
  nested_ = nested_models(compiled_.system, space, {shear_});
  nested_seconds = nesting.seconds();
  kernel_ = discrete_kernel(compiled_.system, {}, 0, {shear_}, 0.5 * step_, 2 * (n_ - 1));
  coarse_kernel_ = discrete_kernel(compiled_.system, {}, 0, {shear_}, step_, n_ - 1);
}

WaveError WaveErrors::next() {
  const RandomRecord record = records_.next();
  const int last = std::min(n_ - 1, static_cast<int>(std::ceil(record.length / step_)));
  const int n = std::min(n_, std::max(last, static_cast<int>(std::ceil(end_ / step_))) + 1);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(n_);
  for (int i = 0; i < last; ++i) force[i] = record.value(i * step_);
  if (record.cut) force[last] = force[last - 1];
  const Eigen::RowVectorXd truth = marched(kernel_, halved(force), record.cut ? 2 * last : -1)(Eigen::seqN(0, n, 2));
  const Eigen::RowVectorXd coarse = marched(coarse_kernel_, force, record.cut ? last : -1).head(n);
  const WaveSamples loads = force.head(n).transpose();
  const Eigen::RowVectorXd found = answer(reduction_.model, shear_, step_, loads, record.cut ? last : -1);
  const ResponseDifference difference = ResponseError(reduction_.model, shear_, nested_, step_, n, 1000).of(loads);
  const double peak = truth.cwiseAbs().maxCoeff(), told = found.cwiseAbs().maxCoeff();
  return {record.kind,
          record.length / end_,
          record.duration / duration_,
          (coarse - truth).cwiseAbs().maxCoeff() / peak,
          (found - truth).cwiseAbs().maxCoeff() / peak,
          std::abs(told / peak - 1.),
          difference.of_model.cwiseAbs().maxCoeff() / told,
          difference.of_middle.cwiseAbs().maxCoeff() / told,
          difference.bound() / told};
}

}  // namespace upbead::test
