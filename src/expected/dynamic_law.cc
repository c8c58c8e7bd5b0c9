#include "expected/dynamic_law.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>

#include "base/numbers.h"
#include "upbead/sliding/block.h"

namespace upbead {

DynamicLaw::DynamicLaw(const Breakwater& breakwater, const SeaState& state, const ImpactAssumptions& assumptions,
                       std::shared_ptr<const ShearAnswer> answer)
    : forces_(breakwater, state), assumptions_(assumptions), answer_(std::move(answer)) {}

ImpactWave DynamicLaw::on_wall(double height, const WaveFactors& factors) const {
  // The factor of P scales the history; its rise and duration are those of the wave without it.
  WaveFactors of_uplift = factors;
  of_uplift.force = 1.;
  const Breakwater& breakwater = forces_.breakwater();
  ImpactWave wave = impact_wave(
      assumptions_,
      wave_on_wall(height, forces_.period(), forces_.at(height, of_uplift, PressureFormula::standing),
                   forces_.at(height, of_uplift), breaker_of(assumptions_, breakwater.section, forces_.wavelength())),
      breakwater.water, breakwater.section.berm_depth);
  wave.peak *= factors.force;
  wave.standing_force *= factors.force;
  return wave;
}

double DynamicLaw::resistance(const Section& section) const {
  return section.friction * (section.submerged_weight + forces_.still().weight);
}

double DynamicLaw::most(const ImpactWave& wave, const Section& section) const {
  const double F = answer_->bound(limits(wave), number_of_samples(wave, answer_->step()));
  return F + std::abs(forces_.still().push) + section.friction * wave.uplift - resistance(section);
}

bool DynamicLaw::may_slide(double height, const WaveFactors& factors) const {
  return most(on_wall(height, factors), with_factors(forces_.breakwater().section, factors)) > 0.;
}

double DynamicLaw::threshold(const WaveFactors& factors) const {
  const Section section = with_factors(forces_.breakwater().section, factors);
  return detail::first_height([&](double height) { return most(on_wall(height, factors), section); });
}

bool operator==(const WaysToFail& a, const WaysToFail& b) {
  const auto of = [](const WaysToFail& w) {
    return std::array{w.sliding, w.sliding_seaward, w.overturning, w.heel_pressure, w.toe_pressure, w.circles};
  };
  return of(a) == of(b);
}

WaysToFail worst_of(const WaysToFail& a, const WaysToFail& b) {
  return {std::min(a.sliding, b.sliding),           std::min(a.sliding_seaward, b.sliding_seaward),
          std::min(a.overturning, b.overturning),   std::max(a.heel_pressure, b.heel_pressure),
          std::max(a.toe_pressure, b.toe_pressure), std::min(a.circles, b.circles)};
}

namespace {

void sample(const ShearAnswer& model, DynamicWave& out) {
  const int n = number_of_samples(out.wave, model.step());
  out.force.resize(static_cast<std::size_t>(n));
  sample_force(out.wave, model.step(), n, out.force.data());
}

/// Computes F_T and F_S for a force that has been sampled.
void answer(const ShearAnswer& model, const ImpactAssumptions& assumptions, const Section& section, DynamicWave& out) {
  const std::size_t size = out.force.size();
  const int n = static_cast<int>(size);
  out.shear.resize(size);
  out.sliding_force.resize(size);
  model.respond(out.force.data(), n, out.shear.data());
  sample_uplift(out.wave, assumptions.uplift, model.step(), n, out.force.data(), out.sliding_force.data());
  for (std::size_t i = 0; i < size; ++i) out.sliding_force[i] = out.shear[i] + section.friction * out.sliding_force[i];
}

}  // namespace

double DynamicLaw::slide_under(const DynamicWave& out, const Section& section) const {
  const double R = resistance(section);
  std::vector<double> F = out.sliding_force;
  for (double& force : F) force += forces_.still().push;
  const auto start = std::find_if(F.begin(), F.end(), [R](double f) { return std::abs(f) > R; });
  if (start == F.end()) return 0.;
  const auto rest = std::max<std::ptrdiff_t>(start - F.begin() - 1, 0);
  History history;
  history.value.assign(F.begin() + rest, F.end());
  for (std::size_t i = 0; i < history.value.size(); ++i)
    history.time.push_back((static_cast<double>(rest) + static_cast<double>(i)) * answer_->step());
  return slide(section.weight / forces_.breakwater().water.gravity, history, R).residual;
}

double DynamicLaw::distance(double height, const WaveFactors& factors) const {
  const Section section = with_factors(forces_.breakwater().section, factors);
  DynamicWave out;
  out.wave = on_wall(height, factors);
  if (most(out.wave, section) <= 0.) return 0.;
  sample(*answer_, out);
  const double excess = std::abs(forces_.still().push) + section.friction * out.wave.uplift - resistance(section);
  if (answer_->bound(out.force.data(), static_cast<int>(out.force.size())) + excess <= 0.) return 0.;
  answer(*answer_, assumptions_, section, out);
  return std::max(slide_under(out, section), 0.);
}

DynamicWave DynamicLaw::wave(double height, const WaveFactors& factors) const {
  const Section section = with_factors(forces_.breakwater().section, factors);
  DynamicWave out;
  out.wave = on_wall(height, factors);
  sample(*answer_, out);
  answer(*answer_, assumptions_, section, out);
  for (std::size_t i = 0; i < out.force.size(); ++i) out.time.push_back(static_cast<double>(i) * answer_->step());
  // where still water lifts the caisson, nothing holds it
  out.sliding = resistance(section) < 0. ? std::numeric_limits<double>::infinity() : slide_under(out, section);
  return out;
}

std::vector<double> DynamicLaw::sampled(const ImpactWave& wave) const {
  std::vector<double> force(static_cast<std::size_t>(number_of_samples(wave, answer_->step())));
  sample_force(wave, answer_->step(), static_cast<int>(force.size()), force.data());
  return force;
}

std::vector<double> DynamicLaw::times(std::size_t n) const {
  std::vector<double> time(n);
  for (std::size_t i = 0; i < n; ++i) time[i] = static_cast<double>(i) * answer_->step();
  return time;
}

WaveOnBottom DynamicLaw::on_bottom(double height, const WaveFactors& factors) const {
  const ImpactWave wave = on_wall(height, factors);
  const Section section = with_factors(forces_.breakwater().section, factors);
  WaveOnBottom out;
  out.step = answer_->step();
  out.force = sampled(wave);
  out.force.back() = 0.;  // T/2 is over
  out.uplift.resize(out.force.size());
  sample_uplift(wave, assumptions_.uplift, out.step, static_cast<int>(out.force.size()), out.force.data(),
                out.uplift.data());
  const auto top = std::max_element(out.force.begin(), out.force.end());
  for (auto i = out.force.begin(); i != top; ++i) {
    double& U = out.uplift[static_cast<std::size_t>(i - out.force.begin())];
    U = std::min(U, wave.uplift * *i / *top);
  }
  out.friction = section.friction;
  out.weight = section.submerged_weight + forces_.still().weight;
  out.push = forces_.still().push;
  out.mass_ratio = answer_->caisson_mass() * forces_.breakwater().water.gravity / section.weight;
  return out;
}

EffectiveBase DynamicLaw::base_under(const ImpactWave& wave, const std::vector<double>& force, const Section& s) const {
  const double step = answer_->step(), B = s.width;
  const int n = static_cast<int>(force.size());
  EffectiveBase base;
  base.width = B;
  const StillWater& still = forces_.still();
  base.weight = s.submerged_weight + still.weight;
  base.weight_moment =
      s.submerged_weight * (0.5 * B - s.centroid.value_or(0.5 * B)) + still.weight * B / 6. + still.push_moment;
  base.push = still.push;
  base.push_moment = still.push_moment;
  base.uplift.resize(force.size());
  sample_uplift(wave, assumptions_.uplift, step, n, force.data(), base.uplift.data());
  const Eigen::MatrixXd reading = answer_->base(force);
  for (int i = 0; i < n; ++i) {
    double& U = base.uplift[static_cast<std::size_t>(i)];
    base.uplift_moment.push_back(U * B / 6. + reading(3, i));  // U is a triangle, zero at the heel
    U += reading(2, i);
    base.force.push_back(base.weight + reading(0, i) - U);
    base.moment.push_back(base.weight_moment + reading(1, i) + base.uplift_moment.back());
  }
  return base;
}

std::optional<WorstBase> DynamicLaw::base(double height, const WaveFactors& factors) const {
  if (!answer_->knows_base()) return std::nullopt;
  const ImpactWave wave = on_wall(height, factors);
  const std::vector<double> force = sampled(wave);
  const Section section = with_factors(forces_.breakwater().section, factors);
  const EffectiveBase base = base_under(wave, force, section);
  const std::vector<double> time = times(force.size());
  WorstBase worst = worst_of(base_extremes(base, time));
  worst.edge_stress = least_edge_stress(base, time).stress;
  return worst;
}

namespace {

/// Sets the least mu N'/F_T both ways.
void see_friction(double friction, const EffectiveBase& base, const std::vector<double>& shear, WaysToFail& ways) {
  const double trifle = 1e-6 * friction * base.weight;
  for (std::size_t i = 0; i < shear.size(); ++i) {
    if (std::abs(shear[i]) <= trifle) continue;
    double& least = shear[i] > 0. ? ways.sliding : ways.sliding_seaward;
    least = std::min(least, friction * std::max(base.force[i], 0.) / std::abs(shear[i]));
  }
}

}  // namespace

std::optional<WaysToFail> DynamicLaw::ways(double height, const WaveFactors& factors) const {
  const CircleFamily* circles = answer_->circles();
  if (!circles) return std::nullopt;
  const ImpactWave wave = on_wall(height, factors);
  const std::vector<double> force = sampled(wave);
  const Section section = with_factors(forces_.breakwater().section, factors);
  const EffectiveBase base = base_under(wave, force, section);
  std::vector<double> shear(force.size());
  answer_->respond(force.data(), static_cast<int>(force.size()), shear.data());
  for (double& F : shear) F += base.push;
  const WorstBase worst = worst_of(base_extremes(base, times(force.size())));
  WaysToFail ways;
  ways.overturning = worst.overturning_margin;
  ways.heel_pressure = worst.heel_pressure;
  ways.toe_pressure = worst.toe_pressure;
  see_friction(section.friction, base, shear, ways);
  const auto found = circle_of_wave(*circles, base.force, base.moment, shear,
                                    [&](const auto& moments) { return answer_->pressures(force, moments); });
  if (found) ways.circles = found->factor;
  return ways;
}

namespace {

template <class Function>
double root(const Function& f, double from, double to) {
  boost::uintmax_t most = 60;
  const auto bracket =
      boost::math::tools::toms748_solve(f, from, to, boost::math::tools::eps_tolerance<double>(40), most);
  return 0.5 * (bracket.first + bracket.second);
}

double triangle(const ImpactWave& wave, double t) {
  if (t <= wave.rise) return wave.peak * t / wave.rise;
  return t < wave.duration ? wave.peak * (wave.duration - t) / (wave.duration - wave.rise) : 0.;
}

/// The times between which the triangle is above gamma P_1 sin(omega t); both are equal where it never is. Between 0
/// and t_r and between t_r and t_d the difference of triangle and sine is convex; it is 0 at 0, not negative at t_r
/// and not positive at t_d. So it changes its sign at most once on each flank.
std::array<double, 2> where_triangle_leads(const ImpactWave& wave, double gamma) {
  const double omega = 2. * pi / wave.period, peak = gamma * wave.standing_force;
  const auto excess = [&](double t) { return triangle(wave, t) - peak * std::sin(omega * t); };
  const double rise = wave.rise, end = wave.duration;
  const double early = 1e-6 * rise;
  if (excess(rise) <= 0.) return {rise, rise};  // P_I = P_1 but for round-off: the triangle is never above
  return {excess(early) < 0. ? root(excess, early, rise) : 0., excess(end) < 0. ? root(excess, rise, end) : end};
}

/// Impulse of max(gamma P_1 sin(omega t), triangle) over half a period.
double impulse(const ImpactWave& wave, double gamma) {
  const double omega = 2. * pi / wave.period, peak = gamma * wave.standing_force;
  const double rise = wave.rise, end = wave.duration;
  const auto [t1, t2] = where_triangle_leads(wave, gamma);
  const double sine = peak / omega * (2. - (std::cos(omega * t1) - std::cos(omega * t2)));
  const double up = 0.5 * wave.peak / rise * (rise * rise - t1 * t1);
  const double down = 0.5 * wave.peak / (end - rise) * (std::pow(end - rise, 2) - std::pow(end - t2, 2));
  return sine + up + down;
}

double reduction(const ImpactWave& wave) {
  const double whole = wave.standing_force * wave.period / pi;
  const auto excess = [&](double gamma) { return impulse(wave, gamma) - whole; };
  if (excess(0.) >= 0.) return 0.;
  if (excess(1.) <= 1e-14 * whole) return 1.;  // round-off, where the triangle is never above
  return root(excess, 0., 1.);
}

/// sin(n angle) for n = 0, 1, 2 ... by turning a vector; it drifts by some 1e-13 in a thousand turns.
class Sines {
 public:
  explicit Sines(double angle) : turn_(std::polar(1., angle)) {}
  double next() {
    const double sine = at_.imag();
    at_ = {at_.real() * turn_.real() - at_.imag() * turn_.imag(),
           at_.real() * turn_.imag() + at_.imag() * turn_.real()};
    return sine;
  }

 private:
  std::complex<double> turn_, at_{1., 0.};
};

}  // namespace

WaveOnWall wave_on_wall(double height, double period, const WavePressure& standing, const WavePressure& extended,
                        const std::optional<double>& breaker) {
  return {height, period, standing.force, standing.alpha_star, standing.uplift, extended.force, breaker};
}

std::optional<double> breaker_of(const ImpactAssumptions& a, const Section& section, double wavelength) {
  if (!a.proverbs) return std::nullopt;
  return breaker_on_wall(*a.proverbs, section, wavelength);
}

ImpactWave impact_wave(const ImpactAssumptions& a, const WaveOnWall& on_wall, const Water& water, double berm_depth) {
  const double g = water.gravity, T = on_wall.period;
  ImpactWave wave;
  wave.period = T;
  wave.standing_force = on_wall.standing_force;
  wave.peak = a.peak_gain ? on_wall.standing_force * (1. + *a.peak_gain * on_wall.alpha_star)
                          : std::max(on_wall.goda_force, on_wall.standing_force);
  wave.uplift = on_wall.uplift;
  double height = on_wall.height, relative = a.rise_coefficient;
  if (a.proverbs && on_wall.breaker && height >= *on_wall.breaker) {
    height = *on_wall.breaker;
    relative *= relative_rise(*a.proverbs);
    const double impact = relative_impact(*a.proverbs, a.proverbs->quantile);
    wave.peak = std::max(wave.peak, impact * water.density * g * height * height);
  }
  const double relative_peak = wave.peak / (water.density * g * height * height);  // F*
  const double rise = relative * std::sqrt(berm_depth / g) / relative_peak;
  const double duration = rise * (a.duration_least + a.duration_gain * std::exp(-a.duration_decay * rise / T));
  wave.duration = std::min(duration, 0.5 * T);
  wave.rise = std::min(rise, 0.5 * wave.duration);
  wave.reduction = reduction(wave);
  return wave;
}

double force_at(const ImpactWave& wave, double t) {
  if (t <= 0. || t >= 0.5 * wave.period) return 0.;
  const double standing = wave.reduction * wave.standing_force * std::sin(2. * pi * t / wave.period);
  return std::max(standing, triangle(wave, t));
}

std::array<double, 2> where_triangle_leads(const ImpactWave& wave) {
  return where_triangle_leads(wave, wave.reduction);
}

ForceLimits limits(const ImpactWave& wave) {
  const double standing = wave.reduction * wave.standing_force, sine = standing * 2. * pi / wave.period;
  return {std::max(wave.peak, standing), wave.rise, std::max(wave.peak / wave.rise, sine),
          std::max(wave.peak / (wave.duration - wave.rise), sine)};
}

int number_of_samples(const ImpactWave& wave, double step) {
  return static_cast<int>(std::ceil(0.5 * wave.period / step)) + 1;
}

void sample_force(const ImpactWave& wave, double step, int n, double* force) {
  Sines sines(2. * pi * step / wave.period);
  const double standing = wave.reduction * wave.standing_force;
  for (int i = 0; i < n; ++i) force[i] = std::max({standing * sines.next(), triangle(wave, i * step), 0.});
}

void sample_uplift(const ImpactWave& wave, ImpactUplift shape, double step, int n, const double* force,
                   double* uplift) {
  Sines sines(2. * pi * step / wave.period);
  const double largest = std::max(wave.peak, wave.reduction * wave.standing_force);
  for (int i = 0; i < n; ++i) {
    const double sine = std::max(sines.next(), 0.);
    if (shape == ImpactUplift::in_phase)
      uplift[i] = wave.uplift * force[i] / largest;
    else if (shape == ImpactUplift::held && i * step <= 0.25 * wave.period)
      uplift[i] = wave.uplift;
    else
      uplift[i] = wave.uplift * sine;
  }
}

namespace {

constexpr int windows = 400;  // widths for which late_windows_ is computed
/// As many modes as a processor takes at once: with 8, the bound shows for nine in ten waves without sliding that
/// they do not slide.
constexpr int few_modes = 8;

/// The model with only the wave's load.
ModalModel one_load(ModalModel model, int load) {
  model.load = model.load.col(load).eval();
  model.feedthrough = model.feedthrough.col(load).eval();
  model.impulse = model.impulse.col(load).eval();
  model.load_name = {model.load_name[static_cast<std::size_t>(load)]};
  return model;
}

/// The model with only the wave's load and one reading.
ModalModel one_path(const ShearModel& model, int reading) {
  return one_load(model.modes.with_reading(reading), model.load);
}

}  // namespace

ShearAnswer::ShearAnswer(const ShearModel& model, double step, double longest)
    : step_(step),
      mass_(model.caisson_mass),
      load_per_force_(1. / model.force_per_load),
      batch_(one_path(model, model.shear), 0, step),
      few_(truncated(one_path(model, model.shear), few_modes)),
      few_batch_(few_.model, 0, step) {
  if (model.force_per_load == 0.) throw std::invalid_argument("the load puts no horizontal force on the caisson");
  for (const int reading : model.base) base_.emplace_back(one_path(model, reading), 0, step);
  if (model.circles) {
    circles_ = model.circles;
    pressures_.emplace(one_load(model.circles->pressures, model.load), step);
  }
  make_bounds(static_cast<int>(std::ceil(longest / step)) + 2);
}

Eigen::MatrixXd ShearAnswer::pressures(const std::vector<double>& force,
                                       const std::vector<std::size_t>& moments) const {
  const auto n = static_cast<Eigen::Index>(force.size());
  const WaveSamples loads = load_per_force_ * Eigen::Map<const Eigen::RowVectorXd>(force.data(), n);
  return pressures_->of(loads, moments);
}

void ShearAnswer::make_bounds(int n) {
  const auto size = static_cast<std::size_t>(n);
  std::vector<double> unit(size, 0.), hat(size), ramp(size);
  unit[1] = 1.;
  respond(unit.data(), n, hat.data());
  std::fill(unit.begin() + 1, unit.end(), 1.);
  respond(unit.data(), n, ramp.data());
  hat_.assign(size, 0.);
  late_.assign(size, 0.);
  for (std::size_t i = 1; i < size; ++i) {
    hat_[i] = hat_[i - 1] + std::abs(hat[i]);
    late_[i] = late_[i - 1] + step_ * std::abs(ramp[i] - 1.);
  }
  stride_ = 1 + n / windows;
  for (std::size_t width = 0; width < size; width += static_cast<std::size_t>(stride_)) {
    double most = 0.;
    for (std::size_t i = 0; i + width < size; ++i) most = std::max(most, late_[i + width] - late_[i]);
    late_windows_.push_back(most);
  }
}

void ShearAnswer::respond(const double* force, int n, double* shear) const {
  const WaveSamples loads = load_per_force_ * Eigen::Map<const Eigen::RowVectorXd>(force, n);
  Eigen::RowVectorXd answer(n);
  batch_.respond(loads, answer);
  Eigen::Map<Eigen::RowVectorXd>(shear, n) = answer;
}

double ShearAnswer::bound(const double* force, int n) const {
  const WaveSamples loads = load_per_force_ * Eigen::Map<const Eigen::RowVectorXd>(force, n);
  Eigen::RowVectorXd answer(n);
  few_batch_.respond(loads, answer);
  return answer.cwiseAbs().maxCoeff() + truncation_error(few_, loads.row(0), step_);
}

Eigen::MatrixXd ShearAnswer::base(const std::vector<double>& force) const {
  const auto n = static_cast<Eigen::Index>(force.size());
  const WaveSamples loads = load_per_force_ * Eigen::Map<const Eigen::RowVectorXd>(force.data(), n);
  Eigen::MatrixXd answer(base_.size(), n);
  Eigen::RowVectorXd one(n);
  for (std::size_t r = 0; r < base_.size(); ++r) {
    base_[r].respond(loads, one);
    answer.row(static_cast<Eigen::Index>(r)) = one;
  }
  return answer;
}

/// F_T(t_n) = sum_k a_(n-k) P_k is at most the largest |P| times the sum of all |a|. Summed by parts it is also P_n +
/// sum_k (P_k - P_(k-1)) (s_(n-k) - 1). This sum is at most that of its steep part, wherever in time |s - 1| is
/// largest, plus that of the rest. The first bound is better for stiff caissons and jumps, the second for slow waves.
double ShearAnswer::bound(const ForceLimits& force, int n) const {
  const auto i = static_cast<std::size_t>(n);
  if (i >= hat_.size()) return std::numeric_limits<double>::infinity();
  const auto width = static_cast<std::size_t>(force.rise / step_ / stride_) + 2;  // one more for a step across the end
  const double steep = width < late_windows_.size() ? late_windows_[width] : late_[i];
  const double late = force.largest + force.first_slope * steep + force.later_slope * late_[i];
  return std::min(hat_[i] * force.largest, late);
}

}  // namespace upbead
