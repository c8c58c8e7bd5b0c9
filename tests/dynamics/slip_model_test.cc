// Claims: the stuck phase is the system without s, with F_T the residual of its row; the slip phases are the whole
// system under friction by its own N'; states pass between phases unchanged; curves, places and steps of a phase
// describe the same motion; bends bound what leaves the straight line within a step, and the error of the work; a slip
// that is not well posed, or depends on a prescribed unknown, is refused; growth is reported.
#include "dynamics/slip_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <random>
#include <stdexcept>

#include "base/numbers.h"
#include "dynamics/slip_path.h"
#include "dynamics/slip_steps.h"
#include "reduction_tools.h"
#include "upbead/base/error.h"

namespace slip_model_test {

using namespace upbead;
using namespace upbead::test;

using Complex = std::complex<double>;
constexpr double shift = 0.8, friction = 0.7;
constexpr int slip = 2;  ///< the unknown of the sample that slips

/// The porous sample, one of whose displacements slips; N' changes with another, its velocity and acceleration.
System sample() {
  System system = loaded_sample(Sample{}, hat());
  system.readings.push_back({"N", "N/m", "", {{0, 1.5}}, {{1, 0.4}}, {{3, 0.2}}, {}});
  return system;
}

ReducedSystem reduced_sample() {
  System system = sample();
  add_slip(system, slip);
  return whole(system, shift);
}

int reading(const System& system, const std::string& name) {
  return system.reading(name);
}

SlipLaw law(double mu = friction) {
  return {mu, {{reading(sample(), "N"), 1.}}, {0, 1}};
}

/// Readings of the whole system under its loads and F_T, at a complex frequency: columns by load.
Eigen::MatrixXcd transfer_of_whole(Complex s) {
  System system = sample();
  add_slip(system, slip);
  return transfer(whole(system, shift), s);
}

void expect_equal(Complex found, Complex expected) {
  EXPECT_LT(std::abs(found - expected), 1e-9 * std::max(1., std::abs(expected)));
}

// In the stuck phase F_T(s) is the force that makes s' zero; in slip it is mu N'.
TEST(SlipModel, PhasesAreTheWholeSystemUnderTheirOwnFriction) {
  const System system = sample();
  const int n = reading(system, "N"), K = static_cast<int>(system.loads.size());
  const SlipModel model = slip_model(reduced_sample(), law());
  ASSERT_EQ(model.n_loads(), K + 1);
  for (const Complex s : {Complex(0.1, 1.), Complex(0.3, 5.)}) {
    const Eigen::MatrixXcd H = transfer_of_whole(s);
    const Eigen::Index v = H.rows() - 1;
    for (int k = 0; k <= K; ++k) {
      const bool by_load = k < K;
      const Complex N = by_load ? H(n, k) : Complex(1.), speed = by_load ? H(v, k) : Complex(0.);
      for (const auto& [contact, mu] : {std::pair{ContactState::slip_landward, friction},
                                        {ContactState::slip_seaward, -friction},
                                        {ContactState::open, 0.}}) {
        const ModalModel& modes = model.phase(contact).modes;
        const Complex shear = mu * N / (1. - mu * H(n, K));
        expect_equal(modes.transfer(row_shear, k, s), shear);
        expect_equal(modes.transfer(row_normal, k, s), N + H(n, K) * shear);
        expect_equal(modes.transfer(row_velocity, k, s), speed + H(v, K) * shear);
        expect_equal(modes.transfer(first_row_wanted, k, s), (by_load ? H(0, k) : Complex(0.)) + H(0, K) * shear);
      }
      const ModalModel& stuck = model.phase(ContactState::stick).modes;
      const Complex shear = -speed / H(v, K);
      expect_equal(stuck.transfer(row_shear, k, s), shear);
      expect_equal(stuck.transfer(row_normal, k, s), N + H(n, K) * shear);
      expect_equal(stuck.transfer(row_velocity, k, s), 0.);
    }
  }
}

TEST(SlipModel, ComparesByTheStuckAndTheFreeMotion) {
  const System system = sample();
  const int n = reading(system, "N"), K = static_cast<int>(system.loads.size());
  const ModalModel both = stuck_and_free(reduced_sample(), law());
  const Complex s(0.2, 2.);
  const Eigen::MatrixXcd H = transfer_of_whole(s);
  const Eigen::Index v = H.rows() - 1;
  for (int k = 0; k <= K; ++k) {
    const Complex shear = k < K ? -H(v, k) / H(v, K) : Complex(0.);
    expect_equal(both.transfer(0, k, s), shear);
    expect_equal(both.transfer(1, k, s), shear + (k < K ? H(n, k) + H(n, K) * shear : Complex(0.)));
    expect_equal(both.transfer(2, k, s), H(v, k));
    expect_equal(both.transfer(3, k, s), shear + H(n, k) + (k < K ? 0. : 1.));
  }
}

TEST(SlipModel, StatesPassUnchanged) {
  const SlipModel model = slip_model(reduced_sample(), law());
  std::mt19937 random(5);
  std::normal_distribution<double> number;
  const Eigen::Index N = model.phases[0].to_state.rows();
  Eigen::VectorXd state = Eigen::VectorXd::NullaryExpr(N, [&] { return number(random); });
  for (const ContactState contact : {ContactState::slip_landward, ContactState::slip_seaward, ContactState::open}) {
    const SlipPhase& phase = model.phase(contact);
    EXPECT_LT((energy_state(phase, modal_state(phase, state)) - state).norm(), 1e-11 * state.norm());
  }
  const SlipPhase& stuck = model.phase(ContactState::stick);
  state[N - 1] = 0.;
  EXPECT_LT((energy_state(stuck, modal_state(stuck, state)) - state).norm(), 1e-11 * state.norm());
}

/// A phase from a random state under random loads, for one step.
struct RandomStep {
  RandomStep(const SlipModel& model, ContactState contact, double length, unsigned seed)
      : phase(model.phase(contact)), step(length) {
    std::mt19937 random(seed);
    std::normal_distribution<double> number;
    const auto draw = [&](Eigen::Index n) -> Eigen::VectorXd {
      return Eigen::VectorXd::NullaryExpr(n, [&] { return number(random); });
    };
    from = modal_state(phase, draw(model.phases[0].to_state.rows()));
    begin = draw(model.n_loads());
    end = draw(model.n_loads());
  }
  Eigen::VectorXd load(double t) const { return begin + (end - begin) * (t / step); }
  SlipPath path() const { return {phase, from, begin, (end - begin) / step, step}; }
  double work(const Eigen::MatrixXd& rows) const {
    const SlipPath path = this->path();
    const auto power = [&](double t) { return load(t).dot(rows * energy_state(phase, path.at(t).z)); };
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(power, 0., step, 8, 1e-12);
  }

  const SlipPhase& phase;
  double step;
  ModalState from;
  Eigen::VectorXd begin, end;
};

constexpr ContactState all_contacts[] = {ContactState::stick, ContactState::slip_landward, ContactState::slip_seaward,
                                         ContactState::open};

TEST(SlipModel, CurvesPlacesAndStepsAreOneMotion) {
  const SlipModel model = slip_model(reduced_sample(), law());
  unsigned seed = 6;
  for (const ContactState contact : all_contacts)
    for (const double step : {0.01, 0.3, 2.}) {
      const RandomStep a(model, contact, step, seed++);
      const SlipPhase& phase = a.phase;
      const SlipPath path = a.path();
      const SlipPath::Place place = path.at(step);
      const SlipPath beyond(phase, place.z, a.end, (a.end - a.begin) / step, step);
      for (int row = 0; row < first_row_wanted + 2; ++row)
        EXPECT_NEAR(path.reading(row)(step), beyond.reading(row)(0.), 1e-11) << row;
      const SlipCurve speed = path.reading(row_velocity);
      const double distance = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(speed, 0., step, 8, 1e-13);
      EXPECT_NEAR(place.distance, distance, 1e-11);
      ModalState next = a.from;
      const SlipSteps steps(phase, contact, load_rows(model), step);
      const SlipStep found = steps.advance(a.from, a.begin, a.end, next);
      EXPECT_LT((next.re - place.z.re).matrix().norm() + (next.im - place.z.im).matrix().norm(), 1e-11);
      EXPECT_NEAR(found.watched, path.reading(SlipSteps::watched_row(contact))(step), 1e-11);
      EXPECT_NEAR(found.normal, path.reading(row_normal)(step), 1e-11);
      if (contact != ContactState::stick) {
        EXPECT_NEAR(steps.within(a.from, next, a.begin, a.end).distance, distance, 1e-11);
      }
    }
}

TEST(SlipSteps, BoundsHowFarReadingsLeaveTheirChord) {
  const SlipModel model = slip_model(reduced_sample(), law());
  const Eigen::MatrixXd rows = load_rows(model);
  double sharpest = 0.;
  for (const ContactState contact : all_contacts)
    for (const double step : {0.01, 0.3, 2., 30.})
      for (unsigned seed = 1; seed <= 5; ++seed) {
        const RandomStep a(model, contact, step, seed);
        const SlipWithin within = SlipSteps(a.phase, contact, rows, step).within(a.from, a.from, a.begin, a.end);
        const SlipPath path = a.path();
        for (const auto& [row, bend] : {std::pair{row_velocity, within.velocity}, {row_normal, within.normal}}) {
          const SlipCurve y = path.reading(row);
          double closest = infinity;
          for (int i = 1; i < 20; ++i) {
            const double x = i / 20., off = std::abs(y(x * step) - (1. - x) * y(0.) - x * y(step));
            closest = std::min(closest, 4. * bend.slow * x * (1. - x) + bend.fast - off);
          }
          EXPECT_GE(closest, -1e-12) << step;
          if (step > 0.01) continue;
          EXPECT_EQ(bend.fast, 0.);
          if (bend.slow > 0.)
            sharpest = std::max(sharpest, std::abs(y(0.5 * step) - 0.5 * (y(0.) + y(step))) / bend.slow);
        }
      }
  EXPECT_GT(sharpest, 0.2) << "the bound is not far beyond what it bounds";
}

TEST(SlipSteps, ErrsInTheWorkByNoMoreThanItSays) {
  const SlipModel model = slip_model(reduced_sample(), law());
  const Eigen::MatrixXd rows = load_rows(model);
  EXPECT_TRUE(rows.row(rows.rows() - 1).isZero(0.)) << "N_0 does no work";
  for (const ContactState contact : all_contacts)
    for (const double step : {0.01, 0.3, 2.})
      for (unsigned seed = 1; seed <= 5; ++seed) {
        const RandomStep a(model, contact, step, seed);
        const SlipSteps steps(a.phase, contact, rows, step);
        const ModalState to = a.path().at(step).z;
        const double exact = a.work(rows);
        const SlipWithin found = steps.within(a.from, to, a.begin, a.end);
        EXPECT_NEAR(found.work, exact, found.work_error + 1e-11) << step;
        if (step > 0.01) continue;
        EXPECT_NEAR(steps.work_of_piece(a.from, to, a.begin, a.end, step), exact, 1e-3 * std::abs(exact) + 1e-5);
        const double stored =
            0.5 * (energy_state(a.phase, to).squaredNorm() - energy_state(a.phase, a.from).squaredNorm());
        if (contact == ContactState::open) {
          EXPECT_LE(stored, exact + 1e-11) << "the rest is lost";
        }
      }
}

TEST(SlipBend, KnowsWhetherAReadingStaysPositive) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-0.2, 2.);
  int positive = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const double begin = number(random), end = number(random);
    const SlipBend bend{std::abs(number(random)), 0.1 * std::abs(number(random))};
    double least = infinity;
    for (int i = 0; i <= 2000; ++i) {
      const double x = i / 2000.;
      least = std::min(least, begin * (1. - x) + end * x - 4. * bend.slow * x * (1. - x) - bend.fast);
    }
    if (std::abs(least) < 1e-5) continue;
    EXPECT_EQ(bend.stays_positive(begin, end), least > 0.) << begin << " " << end << " " << bend.slow;
    positive += least > 0. ? 1 : 0;
  }
  EXPECT_GT(positive, 100);
}

TEST(SlipModel, StuckAndLiftedNeverGrow) {
  const SlipModel model = slip_model(reduced_sample(), law());
  for (const ContactState contact : {ContactState::stick, ContactState::open})
    EXPECT_LE(model.phase(contact).modes.pole.real().maxCoeff(), 0.);
}

TEST(SlipModel, TellsTheGrowthThatFrictionFeeds) {
  EXPECT_EQ(slip_model(reduced_sample(), law(0.01)).growth, 0.);
  EXPECT_GT(slip_model(reduced_sample(), law(2.5)).growth, 0.);
}

TEST(SlipModel, RefusesWhatIsNotWellPosed) {
  EXPECT_THROW(slip_model(reduced_sample(), law(0.)), std::invalid_argument);
  EXPECT_THROW(slip_model(reduced_sample(), law(1e4)), NumericsError);
  EXPECT_THROW(slip_model(whole(sample(), shift), law()), std::invalid_argument) << "without add_slip()";
}

TEST(SlipModel, RefusesASlipThatFeelsWhatIsPrescribed) {
  Sample moved;
  moved.prescribed_u = true;
  System system = sample_system(moved);
  system.readings.pop_back();  // an acceleration, refused as such
  system.loads = {prescribed_load(system, hat())};
  add_slip(system, slip);
  EXPECT_THROW(slip_model(whole(system, shift), {friction, {}, {}}), NumericsError);
}

}  // namespace slip_model_test
