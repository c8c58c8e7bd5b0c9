#include "respond/wave_contact.h"

#include <algorithm>
#include <cmath>

#include "algebra/dense.h"
#include "base/numbers.h"
#include "base/text.h"
#include "dynamics/ground_steps.h"
#include "dynamics/interface_space.h"
#include "fem/caisson/reading_names.h"
#include "response/load_step.h"
#include "run/contact/contact_demand.h"
#include "run/contact/contact_recorder.h"
#include "run/contact/ground_errors.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr double most_steps = 1e5;
/// As in a run: both routes to F_T, and the balance of energies.
constexpr double tolerable_routes = 1e-7, tolerable_energy = 1e-6;

enum ReadingOfGround { shear, x_G, rotation, water };  // as in GroundModel::readings

/// The largest value of F_T, landward (sign = 1) or seaward: at the ends of steps, and where P bends inside them,
/// between which x_G'' is straight.
Extremum peak(const std::vector<double>& time, const Eigen::RowVectorXd& F, const TimeFunction& P, int sign) {
  Extremum most{time.front(), F[0]};
  const auto see = [&](double t, double value) {
    if (sign * value > sign * most.value) most = {t, value};
  };
  std::size_t next = 0;
  const std::vector<double>& bends = P.samples();
  for (std::size_t n = 1; n < time.size(); ++n) {
    const double a = time[n - 1], b = time[n], middle = 0.5 * (a + b);
    const auto i = static_cast<Eigen::Index>(n);
    while (next < bends.size() && bends[next] <= a) ++next;
    for (; next < bends.size() && bends[next] < b; ++next) {
      const double t = bends[next], part = (t - a) / (b - a);
      const auto line = [part](double from, double to) { return (1. - part) * from + part * to; };
      see(t, line(F[i - 1], F[i]) + P(t, middle) - line(P(a, middle), P(b, middle)));
    }
    see(b, F[i]);
  }
  return most;
}

/// Indices of times as close as those at which a run looks: a 32nd of the shortest load.
std::vector<std::size_t> looks_of(const Scene& loads, const std::vector<double>& time) {
  const double apart = shortest_duration(loads) / 32.;
  std::vector<std::size_t> list{0};
  for (std::size_t i = 1; i < time.size(); ++i)
    if (i + 1 == time.size() || time[i + 1] > time[list.back()] + apart) list.push_back(i);
  return list;
}

}  // namespace

struct WaveContacts::Marched {
  Series series;  ///< of GroundModel::readings
  NodeContact contact;
};

/// What marches on a ground have inverted, for the next one of the same thread.
struct WaveContacts::Room {
  std::vector<std::shared_ptr<detail::GroundStages>> stages;
};

WaveContacts::WaveContacts(const ReducedModelFile& model, const std::optional<ModelSliding>& sliding)
    : model_(model),
      contact_(*model.contact),
      sliding_(sliding),
      interface_(contact_.interface),
      force_(model.modes.feedthrough.row(model.modes.index(reading::force))),
      grounds_(contact_.levels.size()) {
  if (!sliding) return;
  if (!model.sliding || model.sliding->friction != sliding->friction) interface_.friction = sliding->friction;
  interface_.normal_force *= sliding->submerged_weight / interface_.normal_force.sum();
}

WaveContacts::~WaveContacts() = default;

LoadsOfWave WaveContacts::loads_of(const WaveFile& file, int wave, double end) const {
  LoadsOfWave out;
  out.scene.tolerance = contact_.tolerance;
  out.scene.time.end = end;
  double largest = 0.;
  for (int k = 0; k < file.n_loads; ++k) {
    const Eigen::RowVectorXd row = file.wave(wave).row(k);
    out.history.emplace_back();
    if (row.isZero(0.)) continue;
    const std::vector<double> value(row.begin(), row.end());
    out.history.back() = piecewise_linear(file.time, value);
    Load& load = out.scene.loads[model_.modes.load_name[static_cast<std::size_t>(k)]];
    load.history = out.history.back();
    load.duration = sampled_duration(file.time, value, end);
    out.P = sum(out.P, scaled(load.history, force_[k]));
    const double force = std::abs(contact_.on_caisson(k, 0)) * row.cwiseAbs().maxCoeff();
    if (force > largest) out.arm = contact_.on_caisson(k, 1);
    largest = std::max(largest, force);
  }
  out.interface = interface_;
  out.uplift = uplift_of(out);
  return out;
}

/// As in a run whose peak of the uplift is that of this wave.
std::vector<UpliftLoad> WaveContacts::uplift_of(const LoadsOfWave& loads) const {
  if (!sliding_ || !(sliding_->uplift_per_force > 0.)) return {};
  const double end = loads.scene.time.end;
  const bool seaward = pushes_seaward_alone(loads.P, end);
  UpliftChoice uplift;
  uplift.course = sliding_->uplift == "held" ? UpliftCourse::held : UpliftCourse::in_phase;
  uplift.lag = sliding_->lag;
  uplift.peak = sliding_->uplift_per_force *
                std::max(0., (seaward ? -1 : 1) * extremum(loads.P, 0., end, seaward ? -1 : 1).value);
  UpliftLoad load;
  load.node = contact_.uplift.col(seaward ? 1 : 0);
  load.pressure = prescribed_uplift(uplift, loads.P, end);
  return {load};
}

const MarchedGround& WaveContacts::ground(std::size_t number) const {
  const std::lock_guard<std::mutex> hold(lock_);
  std::unique_ptr<MarchedGround>& one = grounds_[number];
  if (!one) one = std::make_unique<MarchedGround>(marched(contact_, contact_.levels[number]));
  return *one;
}

/// As choose_step() finds it, by the largest model of the ground.
double WaveContacts::apparent_period(double s, double arm) const {
  const GroundLevel& level = contact_.levels.back();
  const Eigen::Index r = level.n_free();
  const auto row = [r](const Eigen::MatrixXd& rows, int i) -> Vector { return rows.row(i).head(r).transpose(); };
  const Vector x = row(level.position, x_G), force = x + arm * row(level.position, rotation);
  for (int halved = 0; halved <= 4; ++halved, s /= 2.) {
    Eigen::MatrixXd E = s * s * level.M + s * level.C;
    E.diagonal() += level.K.col(0);
    const Vector q = solve_dense(std::move(E), force);
    const double moved = x.dot(q);
    if (!(moved > 0.)) continue;
    const double of_water = s * row(level.velocity, water).dot(q) + s * s * row(level.acceleration, water).dot(q);
    const double mass = model_.caisson_mass - of_water / (s * s * moved), stiffness = 1. / moved - mass * s * s;
    if (stiffness > 0.) return 2. * pi * std::sqrt(mass / stiffness);
  }
  return 0.;
}

/// Those of a run with these loads; not longer than the case asks for.
TimeGrid WaveContacts::steps_of(const LoadsOfWave& loads) const {
  constexpr int order = 2;  // of steps with contact
  const double end = loads.scene.time.end;
  const LoadStep of_loads = step_of_loads(loads.scene, order);
  const auto period_at = [&](double s) {
    const std::lock_guard<std::mutex> hold(lock_);
    const auto [place, is_new] = periods_.try_emplace({s, loads.arm});
    if (is_new) place->second = apparent_period(s, loads.arm);
    return place->second;
  };
  double period = period_at(pi / of_loads.duration);
  for (int i = 0; i < 2 && of_loads.lone_jump && period > 0.; ++i) period = period_at(pi / period);
  const double of_period = std::min(step_fraction(loads.scene, order) * period, end);
  double step = of_loads.largest_step;
  if (period > 0.) step = of_loads.lone_jump ? of_period : std::min(of_period, step);
  step *= contact_step;
  if (contact_.step > 0.) step = std::min(step, contact_.step);
  std::vector<double> kinks = loads.P.kinks();
  for (const UpliftLoad& load : loads.uplift)
    kinks.insert(kinks.end(), load.pressure.kinks().begin(), load.pressure.kinks().end());
  for (const TimeFunction& history : loads.history)
    kinks.insert(kinks.end(), history.kinks().begin(), history.kinks().end());
  if (const double n = estimated_steps(kinks.size(), end, step); n > most_steps)
    throw NumericsError("its loads are so short that they take about " + significant(n, 2) + " steps");
  return make_time_grid(std::move(kinks), end, step);
}

WaveContacts::Marched WaveContacts::march_level(std::size_t number, const LoadsOfWave& loads, const TimeGrid& grid,
                                                Room& room) const {
  const MarchedGround& from = ground(number);
  const GroundLevel& level = contact_.levels[number];
  System system = from.system;
  system.interface = loads.interface;
  for (std::size_t k = 0; k < system.loads.size(); ++k) system.loads[k].history = loads.history[k];
  for (const UpliftLoad& uplift : loads.uplift) {
    SystemLoad apart{"sliding.uplift", Vector::Zero(system.size()), uplift.pressure};
    apart.vector.tail(loads.interface.n_nodes()) = uplift.node;
    system.loads.push_back(std::move(apart));
  }
  if (room.stages.size() <= number) room.stages.resize(number + 1);
  if (!room.stages[number]) room.stages[number] = std::make_shared<detail::GroundStages>();
  const std::unique_ptr<Scheme> scheme = make_contact_scheme(system, from.matrices, room.stages[number]);
  ContactRecorder recorder(system, *scheme);
  Motions motions;
  MarchOptions options;
  options.observers = {&recorder, &motions};
  if (!(contact_.step > 0.)) options.leap = contact_leap(contact_.tolerance);
  Response response = march(system, *scheme, grid, options);
  Marched out{std::move(response.ends), recorder.summary()};
  const auto f = out.series.load.topRows(level.feedthrough.cols());
  out.series.reading = product(level.position, motions.x()) + product(level.velocity, motions.v()) +
                       product(level.acceleration, motions.a()) + level.feedthrough * f;
  out.contact.dissipated = response.energy.back().friction;
  const Eigen::RowVectorXd F = out.series.reading.row(shear), P = force_ * f,
                           moved = product(level.position.row(x_G), motions.a()),
                           by_inertia = P + out.series.reading.row(water) - model_.caisson_mass * moved;
  const double largest = std::max(F.cwiseAbs().maxCoeff(), 1e-6 * P.cwiseAbs().maxCoeff());
  const double routes = (F - by_inertia).cwiseAbs().maxCoeff() / largest, off = response.energy.back().mismatch();
  if (!(routes <= tolerable_routes) || !(off <= tolerable_energy))
    throw NumericsError("the march does not balance: forces by " + significant(routes, 2) + ", energies by " +
                        significant(off, 2));
  return out;
}

std::unique_ptr<WaveContacts::Room> WaveContacts::take_room() const {
  const std::lock_guard<std::mutex> hold(lock_);
  if (rooms_.empty()) return std::make_unique<Room>();
  std::unique_ptr<Room> room = std::move(rooms_.back());
  rooms_.pop_back();
  return room;
}

void WaveContacts::march_wave(const LoadsOfWave& loads, WaveResponse& out) const {
  const TimeGrid grid = steps_of(loads);
  std::unique_ptr<Room> room = take_room();
  std::optional<Marched> before;
  ContactGround error;
  for (std::size_t i = 0; i < contact_.levels.size(); ++i) {
    Marched now = march_level(i, loads, grid, *room);
    if (before) {
      const double apart = differences(now.series, before->series)[shear];
      error = ground_errors({now.series.reading.row(shear), now.contact},
                            {before->series.reading.row(shear), before->contact}, apart);
      error.coordinates = static_cast<int>(contact_.levels[i].n_free());
      error.solves = contact_.levels[i].solves;
    }
    const bool met = before && meets(error, now.contact, contact_.tolerance);
    before = std::move(now);
    if (i > 0) {
      out.contact->solved = before->contact;
      out.contact->solved->ground = error;
    }
    if (!met) continue;
    const Eigen::RowVectorXd F = before->series.reading.row(shear);
    const Extremum landward = peak(before->series.time, F, loads.P, 1);
    out.response = PeaksOfShear{landward.value, landward.time, peak(before->series.time, F, loads.P, -1).value};
    break;
  }
  if (!out.response) out.why_not_contact = why_ground_misses(error);
  const std::lock_guard<std::mutex> hold(lock_);
  rooms_.push_back(std::move(room));
}

void WaveContacts::answer(const WaveFile& file, int wave, double end, const WaveSamples& loads, const WaveGrid& grid,
                          const ReadingsAt* at, WaveResponse& out) const {
  answer(loads_of(file, wave, end), loads, grid, at, out);
  if (!out.why_not_contact.empty() && out.contact) out.contact->solved.reset();
}

void WaveContacts::answer(const LoadsOfWave& functions, const WaveSamples& loads, const WaveGrid& grid,
                          const ReadingsAt* at, WaveResponse& out) const try {
  const Interface& interface = functions.interface;
  const std::vector<std::size_t> looks = looks_of(functions.scene, grid.time);
  Series forces;
  for (const std::size_t i : looks) forces.time.push_back(grid.time[i]);
  forces.reading = at != nullptr ? at->of(loads, looks) : respond_at(contact_.demand, with_jumps(loads, grid), looks);
  out.contact = ContactSummary{
      interface.friction, interface.normal_force.sum(), interface.n_nodes(), {0., 1., contact_.margin, false}, {}};
  look_at_demand(interface, functions.uplift, forces, out.contact->demand);
  if (out.contact->demand.reached)
    march_wave(functions, out);
  else
    out.response = PeaksOfShear{out.peak_shear, out.peak_shear_time, out.peak_shear_seaward};
} catch (const NumericsError& error) {
  if (out.contact) out.contact->solved.reset();
  out.why_not_contact = error.what();
}

}  // namespace upbead
