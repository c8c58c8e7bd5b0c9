// Claim: on ground without damping, where friction that follows N' couples sway and heave into a growing vibration
// (flutter), S is either right or refused with its reason: growth is that of the closed form; with vibrations far
// above the frequencies of the load S is that of the rigid block; in any scene friction never dissipates more energy
// than is available; a bottom that would part from its ground has no S. Values within a step are bounded.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "dynamics/slip_path.h"
#include "dynamics/slip_steps.h"
#include "lumped.h"
#include "upbead/base/error.h"
#include "upbead/sliding/pulse.h"

namespace upbead::test {
namespace coupled_flutter_test {

constexpr double mass = 6e5, weight = 3.2e6, friction = 0.6, shift = 30.;
const TriangularPulse pulse{4e6, 0.3};

/// Undamped by default; a push landward lifts the base; its springs (sway, coupling, heave) have the ratios 1 : -5/6
/// : 2.
System wedge(double base_mass, double stiffness, double damping = 0.) {
  return block_on_wedge(mass, {base_mass, stiffness, damping}, -stiffness * 5. / 6.);
}

/// Largest real part of the poles of m_b u'' + k u + c y = mu N', (m + m_b) y'' + c u + 2 k y = 0 with the base's sway
/// u, its heave y and N' = W' - (m_b y'' + c u + 2 k y): det(K - w M) = 0 is a w^2 - b w + d = 0 with w = -s^2.
double growth(double base, double k) {
  const double c = -k * 5. / 6., m = mass + base;
  const double a = base * m, b = base * 2. * k + (k + friction * c) * m - c * friction * base,
               d = (k + friction * c) * 2. * k - c * (c + friction * 2. * k);
  const std::complex<double> root = std::sqrt(std::complex<double>(b * b - 4. * a * d));
  double largest = 0.;
  for (const std::complex<double> w : {(b + root) / (2. * a), (b - root) / (2. * a)})
    largest = std::max(largest, std::abs(std::sqrt(-w).real()));
  return largest;
}

CoupledSliding slide(const SlipModel& model, double step = 1.5e-3) {
  return CoupledSlip(model, step).slide(samples(history(pulse), weight, step, 500));
}

TEST(CoupledFlutter, GrowsAsTheClosedFormSays) {
  const double base = 2e5, k = 6e8;
  ASSERT_GT(growth(base, k), 3.);
  const SlipModel model = in_modes(wedge(base, k), friction, shift, {}, 0);
  EXPECT_NEAR(model.growth, growth(base, k), 1e-6 * growth(base, k)) << "within the load's band it is kept";
  EXPECT_EQ(model.damping_time, 0.);
  EXPECT_EQ(in_modes(wedge(base, k), 0.5 * friction, shift, {}, 0).damping_time, 0.);
}

// The faster the vibration, the less it affects the block: S tends to that on rigid ground, with a difference of the
// order of P/k, the sway before the slip.
TEST(CoupledFlutter, FarAboveTheLoadIsNoPartOfTheSlip) {
  const double exact = sliding_distance_exact(mass, friction * weight, pulse), base = 2e5;
  for (const double k : {1e13, 1e14, 1e15}) {
    SCOPED_TRACE(k);
    const SlipModel model = in_modes(wedge(base, k), friction, shift, {}, 0);
    EXPECT_GT(growth(base, k), 100.);
    EXPECT_GT(model.damping_time, 0.);
    EXPECT_EQ(model.growth, 0.);
    EXPECT_LT(model.damping_time * shift, 1e-2) << "the damping ratio at s_0 stays within 0.5 %";
    const CoupledSliding found = slide(model);
    EXPECT_EQ(why_no_distance(found), "");
    EXPECT_NEAR(found.slip.residual, exact, 10. * pulse.peak / k + 1e-5 * exact);
    EXPECT_NEAR(found.dissipated, friction * weight * found.slip.residual, 1e-3 * found.dissipated);
  }
}

// Within the load's band flutter is a real motion of ground and friction. It ends when N' falls to zero: then S is
// refused.
TEST(CoupledFlutter, ThatLiftsTheBottomHasNoDistance) {
  const double base = 2e5;
  int refused = 0;
  for (const double k : {6e8, 6e9, 6e10}) {
    SCOPED_TRACE(k);
    const CoupledSliding found = slide(in_modes(wedge(base, k), friction, shift, {}, 0));
    EXPECT_GE(found.dissipated, 0.);
    EXPECT_LE(found.dissipated, found.available + found.uncertain);
    if (why_no_distance(found).empty()) continue;
    EXPECT_LT(found.least_normal, 0.);
    EXPECT_NE(why_no_distance(found).find("part from the ground"), std::string::npos);
    ++refused;
  }
  EXPECT_GT(refused, 0);
}

/// A random scene: masses, springs of any strength, damping or none, a history of force and one of N_0.
struct RandomScene {
  explicit RandomScene(unsigned seed) : random_(seed) {
    base = mass * std::pow(10., number(-2., 0.5));
    stiffness = std::pow(10., number(8., 14.));
    coupling = number(-1.2, 1.2) * stiffness;
    damping = number(0., 1.) < 0.5 ? 0. : stiffness * std::pow(10., number(-6., -3.));
    const double longest = std::pow(10., number(-1.5, 0.));
    double t = 0.;
    for (int i = 0; i < 8; ++i) {
      force.time.push_back(t);
      force.value.push_back(i == 0 || i == 7 ? 0. : number(-4., 8.) * 1e6);
      t += step * std::ceil(number(0., longest) / step + 1.);
    }
    uplift = number(0., 1.) < 0.3 ? number(0., 0.8) : 0.;
  }
  System system() const { return block_on_wedge(mass, {base, stiffness, damping}, coupling); }
  WaveSamples loads() const {
    WaveSamples all = samples(force, weight, step, static_cast<int>(force.time.back() / step) + 200);
    all.row(1) -= uplift * all.row(0).cwiseMax(0.);
    return all;
  }
  double number(double least, double most) { return std::uniform_real_distribution<double>(least, most)(random_); }

  static constexpr double step = 2e-3;
  double base, stiffness, coupling, damping, uplift;
  History force;

 private:
  std::mt19937 random_;
};

TEST(CoupledFlutter, NoSceneGivesADistanceThatCannotBe) {
  int told = 0, refused = 0, fluttered = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    RandomScene scene(seed);
    CoupledSliding found;
    try {
      const SlipModel model = in_modes(scene.system(), friction, shift, {1}, 0);
      fluttered += model.growth > 0. || model.damping_time > 0. ? 1 : 0;
      CoupledHistory history;
      const WaveSamples loads = scene.loads();
      found = CoupledSlip(model, RandomScene::step).slide(loads, &history);
      if (!why_no_distance(found).empty()) {
        ++refused;
        continue;
      }
      // work of the loads by x', which is taken as linear between samples
      double work = 0., rough = 0.;
      for (Eigen::Index n = 1; n < loads.cols(); ++n) {
        const double v = history.outputs(0, n - 1), w = history.outputs(0, n), P = loads(0, n - 1), Q = loads(0, n);
        work += RandomScene::step * (P * (2. * v + w) + Q * (v + 2. * w)) / 6.;
        rough += RandomScene::step * (std::abs(P) + std::abs(Q)) * std::abs(w - v);
      }
      EXPECT_LE(found.dissipated, work + rough + found.uncertain);
    } catch (const NumericsError&) {
      ++refused;
      continue;
    }
    ++told;
    EXPECT_TRUE(std::isfinite(found.slip.residual));
    EXPECT_GE(found.dissipated, -found.uncertain);
    EXPECT_LE(found.dissipated, found.available + found.uncertain + 1e-6 * std::abs(found.available));
    EXPECT_LT(found.uncertain, 0.05 * std::abs(found.available) + 1.);
    EXPECT_LT(found.pulled, 0.01 * found.pressed + 1e-300);
    EXPECT_LT(std::abs(found.slip.residual), 100.);
  }
  EXPECT_GT(told, 150);
  EXPECT_GT(fluttered, 30);
  RecordProperty("told", told);
  RecordProperty("refused", refused);
}

/// A state of a phase in which all modes move.
ModalState random_state(const SlipPhase& phase, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::VectorXd state(phase.from_state.cols());
  for (double& value : state) value = normal(random);
  return modal_state(phase, state);
}

TEST(SlipSteps, BoundsWhatReadingsDoBetweenTheEnds) {
  std::mt19937 random(5);
  const SlipModel model = in_modes(wedge(2e5, 6e9, 2e4), friction, shift, {}, 0);
  const Eigen::MatrixXd rows = load_rows(model);
  double nearest = 0.;
  for (const ContactState bottom : {ContactState::slip_landward, ContactState::slip_seaward, ContactState::open})
    for (const double step : {1e-4, 1e-3, 1e-2, 0.1}) {
      const SlipPhase& phase = model.phase(bottom);
      const Eigen::Vector2d begin(1e5, weight), end(-2e5, 0.9 * weight), slope = (end - begin) / step;
      const ModalState z = random_state(phase, random);
      const SlipPath path(phase, z, begin, slope, step);
      const SlipSteps steps(phase, bottom, rows, step);
      const SlipWithin within = steps.within(z, path.at(step).z, begin, end);
      for (const auto& [row, bend] : {std::pair{row_velocity, within.velocity}, {row_normal, within.normal}}) {
        const SlipCurve curve = path.reading(row);
        for (double x = 0.; x <= 1.; x += 1. / 256.) {
          const double chord = (1. - x) * curve(0.) + x * curve(step);
          const double bound = 4. * bend.slow * x * (1. - x) + bend.fast;
          EXPECT_LE(std::abs(curve(x * step) - chord), bound * (1. + 1e-9) + 1e-12 * std::abs(chord));
          if (bound > 0.) nearest = std::max(nearest, std::abs(curve(x * step) - chord) / bound);
        }
      }
      // the work as a sum over many small pieces
      constexpr int n = 4096;
      double work = 0.;
      ModalState last = z;
      for (int i = 1; i <= n; ++i) {
        const ModalState next = path.at(step * i / n).z;
        work += steps.work_of_piece(last, next, begin + slope * (step * (i - 1) / n), begin + slope * (step * i / n),
                                    step / n);
        last = next;
      }
      EXPECT_NEAR(within.work, work, within.work_error + 1e-4 * std::abs(work));
    }
  EXPECT_GT(nearest, 0.3) << "bounds of some use";
}

TEST(SlipSteps, StaysPositiveIsTheLeastOfAParabola) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0., 1.);
  for (int i = 0; i < 1000; ++i) {
    const SlipBend bend{number(random), 0.1 * number(random)};
    const double begin = 2. * number(random), end = 2. * number(random);
    double least = std::min(begin, end) - bend.fast;
    for (double x = 0.; x <= 1.; x += 1e-3)
      least = std::min(least, begin * (1. - x) + end * x - 4. * bend.slow * x * (1. - x) - bend.fast);
    if (bend.stays_positive(begin, end)) {
      EXPECT_GT(least, -1e-12);
    }
  }
}

}  // namespace coupled_flutter_test
}  // namespace upbead::test
