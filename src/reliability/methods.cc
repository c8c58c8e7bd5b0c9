#include "reliability/methods.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <openturns/OT.hxx>

#include "base/interrupt.h"
#include "base/text.h"
#include "reliability/chance.h"

namespace upbead {

namespace {

std::vector<double> vector_of(const OT::Point& point) {
  return {point.begin(), point.end()};
}

OT::Point point_of(const std::vector<double>& values) {
  OT::Point point(values.size());
  std::copy(values.begin(), values.end(), point.begin());
  return point;
}

/// g as OpenTURNS calls it. Not in parallel: a margin may keep a state.
class MarginEvaluation : public OT::EvaluationImplementation {
 public:
  MarginEvaluation(const Margin& margin, std::size_t size) : margin_(margin), size_(size) {
    setInputDescription(OT::Description::BuildDefault(size, "u"));
    setOutputDescription(OT::Description(1, "g"));
  }
  MarginEvaluation* clone() const override { return new MarginEvaluation(*this); }
  OT::UnsignedInteger getInputDimension() const override { return size_; }
  OT::UnsignedInteger getOutputDimension() const override { return 1; }
  OT::Bool isParallel() const override { return false; }
  OT::Point operator()(const OT::Point& u) const override {
    check_interrupt();
    return OT::Point(1, margin_(vector_of(u)));
  }
  OT::Sample operator()(const OT::Sample& u) const override {
    check_interrupt();
    OT::Sample out(u.getSize(), 1);
    for (std::size_t i = 0; i < u.getSize(); ++i) out(i, 0) = margin_(vector_of(u[i]));
    return out;
  }

 private:
  Margin margin_;
  std::size_t size_;
};

/// A margin that counts its calls, and the event that it falls below 0.
struct Event {
  Event(const Margin& margin, std::size_t size, const Steps& steps = {}) : normal(size) {
    const Margin counted = [margin, count = calls](const std::vector<double>& u) {
      ++*count;
      return margin(u);
    };
    const OT::Evaluation evaluation(MarginEvaluation(counted, size));
    function = OT::Function(evaluation, OT::CenteredFiniteDifferenceGradient(steps.gradient, evaluation),
                            OT::CenteredFiniteDifferenceHessian(steps.hessian, evaluation));
    event = OT::ThresholdEvent(OT::CompositeRandomVector(function, OT::RandomVector(normal)), OT::Less(), 0.);
  }
  std::shared_ptr<double> calls = std::make_shared<double>(0.);
  OT::Normal normal;
  OT::Function function;
  OT::ThresholdEvent event;
};

void quiet() {
  OT::Log::Show(OT::Log::NONE);
}

MethodAnswer answer_of(const std::string& method, double probability, double evaluations) {
  return {method, probability, index_of(probability), {}, evaluations, {}};
}

MethodAnswer no_answer(const std::string& method, const std::string& why, double evaluations = 0.) {
  return {method, {}, {}, {}, evaluations, why};
}

/// Distance of u* from g = 0, and how far u* is from normal to it (the sine of their angle).
struct Misses {
  double distance = 0., angle = 0.;
};

constexpr double near_origin = 1e-6, most_distance = 2e-3, most_angle = 0.05;

Misses misses_of(const Event& event, const OT::Point& u, const OT::Point& gradient) {
  const double slope = gradient.norm(), length = u.norm();
  if (!(slope > 0.) || !std::isfinite(slope)) return {HUGE_VAL, HUGE_VAL};
  const double along = std::abs(u.dot(gradient)) / slope;
  const double across = std::sqrt(std::max(length * length - along * along, 0.));
  return {std::abs(event.function(u)[0]) / slope, length > near_origin ? across / length : 0.};
}

/// The point that an optimiser ends at, where it is a design point.
std::optional<DesignPoint> search(const Event& event, OT::OptimizationAlgorithm algorithm, double g_origin) {
  const OT::Point origin(event.normal.getDimension(), 0.);
  try {
    OT::FORM form(algorithm, event.event, origin);
    form.run();
    const OT::Point u = form.getResult().getStandardSpaceDesignPoint();
    const OT::Matrix jacobian = event.function.gradient(u);
    OT::Point gradient(u.getDimension());
    for (std::size_t i = 0; i < u.getDimension(); ++i) gradient[i] = jacobian(i, 0);
    const Misses miss = misses_of(event, u, gradient);
    if (!(miss.distance <= most_distance) || !(miss.angle <= most_angle)) return {};
    const double sign = g_origin < 0. ? -1. : 1., length = u.norm();
    DesignPoint point;
    point.u = vector_of(u);
    point.index = sign * length;
    const OT::Point towards = length > near_origin ? u * (sign / length) : gradient * (-1. / gradient.norm());
    point.alpha = vector_of(towards);
    return point;
  } catch (const OT::Exception&) {  // it does not converge
    return {};
  }
}

OT::OptimizationAlgorithm tuned(OT::OptimizationAlgorithm algorithm) {
  algorithm.setMaximumIterationNumber(200);
  algorithm.setMaximumEvaluationNumber(20000);
  algorithm.setMaximumAbsoluteError(1e-6);
  algorithm.setMaximumRelativeError(1e-6);
  algorithm.setMaximumResidualError(1e-6);
  algorithm.setMaximumConstraintError(1e-6);
  return algorithm;
}

MethodAnswer sampled(const std::string& method, const OT::ProbabilitySimulationResult& result, double evaluations) {
  const double p = result.getProbabilityEstimate();
  if (!(p > 0.)) return no_answer(method, "no sample of " + significant(evaluations, 6) + " failed", evaluations);
  const bool all = p >= 1.;  // then it is no less than by half a sample that did not
  MethodAnswer answer = answer_of(method, all ? 1. - 0.5 / std::max(evaluations, 1.) : p, evaluations);
  answer.variation = result.getCoefficientOfVariation();
  return answer;
}

constexpr int block = 1000;

constexpr double least_probability = 1e-12;  // below which subset sampling ends

OT::UnsignedInteger blocks(int samples) {
  return static_cast<OT::UnsignedInteger>(std::max(samples / block, 1));
}

}  // namespace

DesignPointSearch find_design_point(const Margin& margin, std::size_t size, const Steps& steps) {
  quiet();
  const Event event(margin, size, steps);
  const double g_origin = event.function(OT::Point(size, 0.))[0];
  for (const OT::OptimizationAlgorithm& algorithm :
       {OT::OptimizationAlgorithm(OT::AbdoRackwitz()), OT::OptimizationAlgorithm(OT::Cobyla())}) {
    if (std::optional<DesignPoint> point = search(event, tuned(algorithm), g_origin)) {
      point->evaluations = *event.calls;
      return {point, ""};
    }
  }
  return {{},
          "no design point: neither Abdo and Rackwitz's steps nor COBYLA end at a point of g = 0 that is nearest "
          "to the origin"};
}

MethodAnswer by_form(const DesignPointSearch& found) {
  if (!found.point) return no_answer("form", found.why_not);
  const double beta = found.point->index;
  MethodAnswer answer = answer_of("form", boost::math::cdf(boost::math::normal(), -beta), found.point->evaluations);
  answer.index = beta;
  return answer;
}

MethodAnswer by_sorm(const Margin& margin, const DesignPointSearch& found, const Steps& steps) {
  if (!found.point) return no_answer("sorm", found.why_not);
  quiet();
  const std::vector<double>& u = found.point->u;
  const Event event(margin, u.size(), steps);
  try {
    const OT::SORMResult result(point_of(u), event.event, found.point->index < 0.);
    const double p = result.getEventProbabilityBreitung();
    if (p > 0. && p < 1.) return answer_of("sorm", p, *event.calls);
  } catch (const OT::Exception&) {
  }
  return no_answer("sorm", "Breitung's formula has no value: g = 0 is curved towards the origin by 1/beta or more",
                   *event.calls);
}

MethodAnswer by_importance(const Margin& margin, const std::vector<DesignPoint>& points, const Sampling& sampling) {
  if (points.empty()) return no_answer("importance", "no design point to sample around");
  quiet();
  const std::size_t size = points.front().u.size();
  const Event event(margin, size);
  OT::Collection<OT::Distribution> around;
  for (const DesignPoint& point : points)
    around.add(OT::Normal(point_of(point.u), OT::Point(size, 1.), OT::CorrelationMatrix(size)));
  OT::RandomGenerator::SetSeed(sampling.seed);
  const OT::Distribution density = points.size() == 1 ? around[0] : OT::Distribution(OT::Mixture(around));
  OT::ProbabilitySimulationAlgorithm algorithm(event.event, OT::ImportanceSamplingExperiment(density));
  algorithm.setBlockSize(block);
  algorithm.setMaximumOuterSampling(blocks(sampling.samples));
  algorithm.setMaximumCoefficientOfVariation(sampling.variation);
  algorithm.setMaximumStandardDeviation(0.);
  algorithm.run();
  return sampled("importance", algorithm.getResult(), *event.calls);
}

MethodAnswer by_subset(const Margin& margin, std::size_t size, const Sampling& sampling) {
  quiet();
  const Event event(margin, size);
  OT::RandomGenerator::SetSeed(sampling.seed);
  OT::SubsetSampling algorithm(event.event);
  algorithm.setBlockSize(block);
  algorithm.setMaximumOuterSampling(blocks(sampling.samples));
  algorithm.setMinimumProbability(least_probability);
  try {
    algorithm.run();
  } catch (const OT::Exception&) {  // as run() tells it
    return no_answer("subset", "its probability is below " + significant(least_probability, 1), *event.calls);
  }
  return sampled("subset", algorithm.getResult(), *event.calls);
}

MethodAnswer by_plain(const Margin& margin, std::size_t size, const Sampling& sampling) {
  quiet();
  const Event event(margin, size);
  OT::RandomGenerator::SetSeed(sampling.seed);
  OT::ProbabilitySimulationAlgorithm algorithm(event.event, OT::MonteCarloExperiment());
  algorithm.setBlockSize(block);
  algorithm.setMaximumOuterSampling(blocks(sampling.plain_samples));
  algorithm.setMaximumCoefficientOfVariation(0.);
  algorithm.setMaximumStandardDeviation(0.);
  algorithm.run();
  return sampled("plain", algorithm.getResult(), *event.calls);
}

}  // namespace upbead
