// Claims: the difference of two nested models is about the error of the smaller one; a model reported as converged
// meets the tolerance; `measured`, other readings, each load alone, max_vectors and exhausted spaces count as
// documented; on a basis that others have grown the model is the same to the last bit; agreed_frequency is the
// frequency up to which two models agree.
// Source: a chain of masses and springs, its modes in closed form.
#include "upbead/dynamics/reduce.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dynamics/basis.h"
#include "dynamics/growing_model.h"
#include "modal_models.h"
#include "reduction_tools.h"
#include "spring_chain.h"

namespace reduce_test {

using namespace upbead;
using namespace upbead::test;

const SpringChain chain_of_masses;
constexpr double duration = 40., end = 150.;

TimeFunction force() {
  return piecewise_linear({0., 0.5 * duration, duration}, {0., 1., 0.});
}

ReduceOptions options_for(const System& system, double tolerance) {
  ReduceOptions options;
  options.shift = 1.25 * 2. * std::acos(-1.) / duration;
  std::vector<double> time;
  for (int i = 0; i <= 300; ++i) time.push_back(i * end / 300.);
  std::vector<TimeFunction> histories;
  for (const SystemLoad& load : system.loads) histories.push_back(load.history);
  options.training = sample(histories, time);
  options.measured = {0};
  options.tolerance = tolerance;
  options.tolerance_of_others = std::numeric_limits<double>::infinity();
  return options;
}

/// For each reading: largest difference from the exact modes over the largest value.
Eigen::VectorXd true_error(const ModalModel& model, const ReduceOptions& options) {
  const Eigen::MatrixXd exact = respond(chain_of_masses.exact(), options.training).reading;
  const Eigen::MatrixXd found = respond(model, options.training).reading;
  return (found - exact).cwiseAbs().rowwise().maxCoeff().cwiseQuotient(exact.cwiseAbs().rowwise().maxCoeff());
}

TEST(Reduce, NestedErrorIsThatOfTheSmallerModel) {
  const System system = chain_of_masses.system(force());
  const ReduceOptions options = options_for(system, 1e-6);
  const Reduction reduction = reduce(system, options);
  ASSERT_GE(reduction.history.size(), 3u);
  int smaller = 24;
  double mean = 0.;
  for (const auto& [n, nested] : reduction.history) {
    const double truth = true_error(modes_of(reduced(system, options.shift, smaller)), options)[0];
    mean += std::log(nested.history / truth) / static_cast<double>(reduction.history.size());
    EXPECT_GE(nested.history, nested.peak);
    smaller = n;
  }
  RecordProperty("nested_over_true", std::to_string(std::exp(mean)));
  EXPECT_GT(std::exp(mean), 0.3);
  EXPECT_LT(std::exp(mean), 3.);
}

TEST(Reduce, WhatConvergedMeetsTheTolerance) {
  const System system = chain_of_masses.system(force());
  for (const double tolerance : {1e-2, 2e-3}) {
    const ReduceOptions options = options_for(system, tolerance);
    const Reduction reduction = reduce(system, options);
    EXPECT_TRUE(reduction.converged);
    EXPECT_LE(reduction.error.history, tolerance);
    EXPECT_GT(reduction.error.history, 0.);
    EXPECT_EQ(reduction.error.history, reduction.error.of_reading[0]);
    EXPECT_EQ(reduction.error.others, reduction.error.of_reading[1]);
    EXPECT_LE(true_error(reduction.model, options)[0], tolerance);
    EXPECT_EQ(reduction.n_vectors, reduction.history.back().first);
    EXPECT_EQ(reduction.n_solves, reduction.n_vectors);
    EXPECT_EQ(reduction.n_independent_loads, 1);
  }
}

TEST(Reduce, WhatIsPreparedBeforeItsTrainingIsTheSame) {
  const System system = chain_of_masses.system(force());
  const ReduceOptions options = options_for(system, 2e-3);
  ReduceOptions untrained = options;
  untrained.training = {};
  const Reduction straight = reduce(system, options);
  GrowingModel model(system, untrained);
  model.prepare();
  int solves = 0;
  model.train(options.training, [&solves](double) { ++solves; });
  while (!model.reduction().converged && model.grow()) {
  }
  const Reduction prepared = model.finish();
  EXPECT_TRUE(prepared.converged);
  EXPECT_EQ(prepared.n_vectors, straight.n_vectors);
  EXPECT_EQ(solves, straight.n_vectors - 24) << "the first look's vectors are not made again";
  EXPECT_EQ(prepared.error.history, straight.error.history);
  EXPECT_EQ(prepared.omega, straight.omega);
  EXPECT_EQ(prepared.model.pole, straight.model.pole);
  EXPECT_EQ(prepared.model.reading, straight.model.reading);
}

void expect_equal(const Reduction& a, const Reduction& b) {
  EXPECT_EQ(a.n_vectors, b.n_vectors);
  EXPECT_EQ(a.n_solves, b.n_solves);
  EXPECT_EQ(a.converged, b.converged);
  EXPECT_EQ(a.error.history, b.error.history);
  EXPECT_EQ(a.omega, b.omega);
  EXPECT_EQ(a.history.size(), b.history.size());
  EXPECT_EQ(a.model.pole, b.model.pole);
  EXPECT_EQ(a.model.reading, b.model.reading);
  EXPECT_EQ(a.system.K, b.system.K);
  ASSERT_EQ(a.states.has_value(), b.states.has_value());
  if (!a.states) return;
  EXPECT_EQ(a.states->displacements.coordinate, b.states->displacements.coordinate);
  EXPECT_EQ(a.states->displacements.columns(), b.states->displacements.columns());
  EXPECT_EQ(a.states->model.reading, b.states->model.reading);
}

TEST(Reduce, OnABasisThatOthersHaveGrownTheModelIsTheSameToTheLastBit) {
  const System system = chain_of_masses.system(force());
  BasisRoom room;
  const ReduceOptions loose = options_for(system, 1e-2), strict = options_for(system, 1e-6);
  ReduceOptions higher = loose, states = loose, few = loose, shifted = loose;
  higher.training.begin *= 3.;
  higher.training.end *= 3.;
  states.keep_states = true;
  few.max_vectors = 20;  // less than the first look takes else
  shifted.shift *= 1.1;
  int spared = 0;
  for (const ReduceOptions& options : {loose, strict, higher, states, loose}) {
    const Reduction kept = reduce(system, options, &room), alone = reduce(system, options);
    expect_equal(kept, alone);
    EXPECT_EQ(alone.n_spared, 0);
    EXPECT_EQ(kept.n_spared, std::min(spared, alone.n_solves));
    spared = std::max(spared, alone.n_solves);
  }
  for (const ReduceOptions& options : {few, shifted}) {
    const Reduction kept = reduce(system, options, &room);
    expect_equal(kept, reduce(system, options));
    EXPECT_EQ(kept.n_spared, 0);
  }
}

TEST(Reduce, OtherReadingsHaveTheirOwnTolerance) {
  const System system = chain_of_masses.system(force());
  ReduceOptions options = options_for(system, 1e-2);
  const Reduction loose = reduce(system, options);
  options.tolerance_of_others = 1e-3;
  const Reduction strict = reduce(system, options);
  EXPECT_GT(loose.error.others, 1e-3);
  EXPECT_TRUE(strict.converged);
  EXPECT_LE(strict.error.others, 1e-3);
  EXPECT_GT(strict.n_vectors, loose.n_vectors);
}

TEST(Reduce, MeasuresEachLoadWhereItIsAsked) {
  // The sum of the loads is slow but for a thousandth; each load alone is fast.
  const TimeFunction slow = piecewise_linear({0., 75., 150.}, {0., 1., 0.});
  const TimeFunction fast = piecewise_linear({0., 1., 2.}, {0., 1., 0.});
  System system = chain_of_masses.system(sum(slow, fast));
  SystemLoad other = system.loads[0];
  other.vector[250] = 0.001;
  other.history = scaled(fast, -1.);
  system.loads.push_back(other);
  ReduceOptions options = options_for(system, 1e-2);
  options.max_vectors = 31;
  options.each_load = false;
  const Reduction together = reduce(system, options);
  options.each_load = true;
  const Reduction each = reduce(system, options);
  ASSERT_EQ(together.n_independent_loads, 2);
  ASSERT_FALSE(together.history.empty());
  ASSERT_FALSE(each.history.empty());
  EXPECT_GT(each.history[0].second.history, 3. * together.history[0].second.history);
}

TEST(Reduce, StopsAtTheMostVectors) {
  const System system = chain_of_masses.system(force());
  ReduceOptions options = options_for(system, 1e-9);
  options.max_vectors = 33;
  double done = 0.;
  options.progress = [&done](double now) {
    EXPECT_GE(now, done);
    EXPECT_LE(now, 1.);
    done = now;
  };
  const Reduction reduction = reduce(system, options);
  EXPECT_GT(done, 0.);
  EXPECT_FALSE(reduction.converged);
  EXPECT_EQ(reduction.n_vectors, 30) << "the last look that fits";
  EXPECT_EQ(reduction.n_solves, 30);
  EXPECT_GT(reduction.error.history, 1e-9);
}

TEST(Reduce, AnExhaustedSpaceIsExact) {
  const SpringChain small{9, 0.1};
  const System system = small.system(force());
  const ReduceOptions options = options_for(system, 1e-12);
  const Reduction reduction = reduce(system, options);
  EXPECT_TRUE(reduction.converged);
  EXPECT_LE(reduction.n_vectors, 18);
  const Eigen::MatrixXd exact = respond(small.exact(), options.training).reading;
  EXPECT_LT(error(respond(reduction.model, options.training).reading, exact), 1e-10);
}

TEST(Reduce, ComparesByTheModelThatIsAskedFor) {
  const System system = chain_of_masses.system(force());
  ReduceOptions options = options_for(system, 1e-3);
  const Reduction usual = reduce(system, options);
  options.model = [](const ReducedSystem& reduced) {
    ModalModel model = modes_of(reduced);
    model.reading.row(0).swap(model.reading.row(1));
    return model;
  };
  const Reduction other = reduce(system, options);
  EXPECT_EQ(other.error.history, other.error.of_reading[0]);
  EXPECT_NE(other.history[0].second.history, usual.history[0].second.history) << "another reading is measured";
  EXPECT_LT(error(respond(modes_of(other.system), options.training).reading.row(0),
                  respond(other.model, options.training).reading.row(1)),
            1e-12)
      << "the system is what the model was made of";
}

/// Two oscillators side by side, of 1 and `omega` rad/s.
ModalModel two_oscillators(double omega) {
  ModalModel model = Oscillator{1., 0.1, 1.}.model(), second = Oscillator{1., 0.1, omega * omega}.model();
  for (Eigen::MatrixXcd* part : {&model.load, &second.load}) part->conservativeResize(1, 1);
  model.pole.conservativeResize(2);
  model.pole[1] = second.pole[0];
  model.load.setOnes(2, 1);
  model.reading.conservativeResize(3, 2);
  model.reading.col(1) = second.reading;
  model.feedthrough *= 2.;
  return model;
}

TEST(AgreedFrequency, EndsWhereTheModelsDiffer) {
  const ModalModel coarse = two_oscillators(9.), fine = two_oscillators(10.);
  constexpr double tolerance = 0.01, decay = 0.05, largest = 100.;
  const auto difference = [&](double omega) {
    const std::complex<double> s(decay, omega);
    return std::abs(coarse.transfer(0, 0, s) - fine.transfer(0, 0, s));
  };
  const double agreed = agreed_frequency(coarse, fine, {0}, tolerance, decay, largest);
  double scale = 0.;
  for (double omega = 0.01; omega < largest; omega *= 1.01)
    scale = std::max(scale, std::abs(fine.transfer(0, 0, {decay, omega})));
  EXPECT_GT(agreed, 1.) << "they share the first resonance";
  EXPECT_LT(agreed, 9.);
  for (double omega = 0.01; omega <= agreed; omega *= 1.01) EXPECT_LE(difference(omega), 1.01 * tolerance * scale);
  EXPECT_GT(difference(1.05 * agreed), 0.98 * tolerance * scale) << "points are 4.7 % apart";
}

TEST(AgreedFrequency, IsTheLargestOrNone) {
  const ModalModel model = two_oscillators(10.), other = two_oscillators(20.);
  EXPECT_EQ(agreed_frequency(model, model, {0, 1}, 1e-12, 0.05, 77.), 77.);
  EXPECT_EQ(agreed_frequency(other, model, {0}, 1e-9, 0.05, 77.), 0.);
}

}  // namespace reduce_test
