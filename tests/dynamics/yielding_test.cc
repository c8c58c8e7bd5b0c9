#include "dynamics/yielding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "spring_chain.h"
#include "upbead/base/error.h"

namespace upbead {
namespace yielding_test {

using test::smooth;
using test::SpringChain;

/// A spring of total stiffness 1 consists of parallel parts; each slides at its own force.
struct Part {
  double h, y;
};
const std::vector<Part> parts = {{0.4, 0.08}, {0.3, 0.2}, {0.2, 0.4}, {0.1, 1e9}};

/// Yielding springs between the masses of a spring chain; the first spring is between mass 0 and the base.
class YieldingSprings : public InternalForce {
 public:
  YieldingSprings(int n, double strength) : strength_(strength), slid_(parts.size() * n), now_(slid_) {
    for (int i = 0; i < n; ++i) rows_.push_back(i);
  }
  const std::vector<int>& rows() const override { return rows_; }
  void evaluate(const Vector& x, Vector& p) override {
    const int n = static_cast<int>(rows_.size());
    p.setZero(n);
    now_ = slid_;
    dissipated_ = 0.;
    for (int i = 0; i < n; ++i) {
      const double d = x[i] - (i > 0 ? x[i - 1] : 0.), correction = d - force(i, d);
      p[i] += correction;
      if (i > 0) p[i - 1] -= correction;
    }
  }
  double commit(const Vector& x) override {
    Vector p;
    evaluate(x, p);
    slid_ = now_;
    stored_ = 0.;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const double d = x[static_cast<Eigen::Index>(i)] - (i > 0 ? x[static_cast<Eigen::Index>(i) - 1] : 0.);
      stored_ -= 0.5 * d * d;
      for (std::size_t k = 0; k < parts.size(); ++k)
        stored_ += 0.5 * parts[k].h * std::pow(d - slid_[i * parts.size() + k], 2);
    }
    return dissipated_;
  }
  double stored_beside_elastic() const override { return stored_; }
  const Vector& added_to_readings() const override { return none_; }
  double exerted() const override { return 0.; }

 private:
  double force(int i, double d) {
    double sum = 0.;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      double& slid = now_[i * parts.size() + k];
      const double trial = parts[k].h * (d - slid), most = strength_ * parts[k].y;
      const double held = std::clamp(trial, -most, most);
      const double more = (trial - held) / parts[k].h;
      slid += more;
      dissipated_ += held * more;
      sum += held;
    }
    return sum;
  }

  Vector none_ = Vector::Zero(2);  // one value for each reading of the chain
  double strength_;
  std::vector<int> rows_;
  std::vector<double> slid_, now_;
  double dissipated_ = 0., stored_ = 0.;
};

constexpr int n_masses = 8;
constexpr double damping = 0.02, end = 24.;

System chain() {
  return SpringChain{n_masses, damping}.system(smooth());
}

State marched(const System& system, Scheme& scheme, int n) {
  State state = at_rest(system);
  scheme.start(state);
  for (int i = 0; i < n; ++i) scheme.advance(state, end / n);
  return state;
}

/// The same chain, explicitly in small steps, with the history of every step.
Vector by_leapfrog(double strength, int n) {
  const System system = chain();
  YieldingSprings springs(n_masses, strength);
  Vector x = Vector::Zero(n_masses), v = x, p;
  const double h = end / n, brake = 0.5 * damping * h;
  for (int i = 0; i < n; ++i) {
    springs.evaluate(x, p);
    const double f = system.loads[0].history(i * h, (i + 0.5) * h);
    const Vector a = system.loads[0].vector * f - system.K * x + p;
    v = ((1. - brake) * v + (i == 0 ? 0.5 : 1.) * h * a) / (1. + brake);
    springs.commit(x);
    x += h * v;
  }
  return x;
}

class Yielding : public ::testing::Test {
 protected:
  const System system_ = chain();  // the sample's environment has PETSc running
};

TEST_F(Yielding, WhereNothingYieldsTheAnswerIsTheElasticOneWithOneEvaluationAStage) {
  YieldingSprings springs(n_masses, 1e6);
  const auto scheme = make_yielding_scheme(system_, springs);
  const State state = marched(system_, *scheme, 400);
  EXPECT_EQ(scheme->yielding()->evaluations, scheme->yielding()->stages);
  EXPECT_EQ(scheme->yielding()->stages, 1200);
  EXPECT_EQ(scheme->yielding()->dissipated, 0.);
  const auto linear = make_scheme(system_, {SchemeKind::sdirk4});
  const State exact = marched(system_, *linear, 400);
  EXPECT_LT((state.x - exact.x).norm(), 1e-3 * exact.x.norm());  // order 2 against order 4
}

TEST_F(Yielding, FollowsAnExplicitMarchOfItsOwn) {
  const Vector exact = by_leapfrog(1., 240000);
  std::vector<double> error, taken;
  for (const int n : {240, 480, 960, 1920}) {
    YieldingSprings springs(n_masses, 1.);
    const auto scheme = make_yielding_scheme(system_, springs, {1e-9, false});
    error.push_back((marched(system_, *scheme, n).x - exact).norm() / exact.norm());
    const EnergyAccount& energy = scheme->energy();
    EXPECT_LT(energy.mismatch(), 1e-8);
    EXPECT_EQ(energy.plastic, scheme->yielding()->dissipated);
    EXPECT_GT(energy.plastic, 0.3 * energy.largest_work);
    taken.push_back(std::abs(energy.scheme) / energy.largest_work);
    EXPECT_GT(scheme->yielding()->evaluations, scheme->yielding()->stages);
    EXPECT_GT(scheme->yielding()->dissipated, 0.);
  }
  EXPECT_LT(error.back(), 1e-3);
  EXPECT_LT(error.back(), error.front() / 20.) << "order 2 would be 64";
  EXPECT_LT(taken.back(), 1e-3) << "what the law says is lost is what the equations lose";
}

/// A force at the end mass that is not part of the elastic matrix.
class EndForce : public InternalForce {
 public:
  explicit EndForce(double (*of)(double)) : of_(of) {}
  const std::vector<int>& rows() const override { return rows_; }
  void evaluate(const Vector& x, Vector& p) override { p.setConstant(1, of_(x[n_masses - 1])); }
  double commit(const Vector&) override { return 0.; }
  double stored_beside_elastic() const override { return 0.; }
  const Vector& added_to_readings() const override { return none_; }
  double exerted() const override { return 0.; }

 private:
  Vector none_ = Vector::Zero(2);
  double (*of_)(double);
  std::vector<int> rows_{n_masses - 1};
};

TEST_F(Yielding, StepsThatDoNotConvergeAreHalvedThenTold) {
  EndForce repulsive([](double x) { return 40. * std::max(x - 1., 0.); });
  const auto scheme = make_yielding_scheme(system_, repulsive);
  EXPECT_NEAR(marched(system_, *scheme, 6).time, end, 1e-12 * end);
  EXPECT_GT(scheme->yielding()->cut_steps, 0);
  EndForce nothing([](double x) { return x > 1. ? std::nan("") : 0.; });
  const auto failing = make_yielding_scheme(system_, nothing);
  EXPECT_THROW(marched(system_, *failing, 60), NumericsError);
}

}  // namespace yielding_test
}  // namespace upbead
