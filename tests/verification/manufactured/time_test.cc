// Claim: generalised_alpha is of order 2 and sdirk4 of order 4 in the step.
//
// Source: tests/reference/ref8_mms.json, solution `time-only`: bilinear in x, y, which squares of degree 2 represent
// exactly, so that the whole error is that in time.
//
// Limits: u 1.95 and 3.95, by least squares over the steps named; those of phi and p are recorded. sdirk4 shows order
// 4 only at steps of 0.5 ms and less, where the error of u in L2 is below 1e-9: its stages are of order 1, and the
// fastest waves of this mesh (periods of some ms) have to be resolved before the fourth order takes over.
// generalised_alpha takes its first two steps by sdirk4, which are more accurate: if steps are few, these two are a
// noticeable part, and the order appears lower.

#include <gtest/gtest.h>

#include <cmath>

#include "norms.h"
#include "record.h"

namespace upbead::test {
namespace time_test {

/// Errors for each step.
struct Halving {
  std::vector<double> step;  ///< s
  std::map<std::string, std::vector<double>> error;

  double order_of(const std::string& norm) const { return order(step, error.at(norm)); }
};

Halving halving(const Problem& problem, const std::vector<int>& steps, SchemeKind scheme) {
  Halving out;
  for (const int n : steps) {
    out.step.push_back(problem.mms.end / n);
    for (const auto& [norm, error] : errors(problem, marched(problem, problem.mms.end, n, scheme)))
      out.error[norm].push_back(error);
  }
  return out;
}

Curve curve_of(const Halving& found, const std::string& norm, double slope, const std::string& label) {
  Curve curve{norm + " (log-log)", "step (s)", "relative error", label, found.step, {}, found.error.at(norm)};
  for (const double step : found.step)
    curve.exact.push_back(curve.computed.back() * std::pow(step / found.step.back(), slope));
  return curve;
}

void record_orders(Record& record, const std::string& title, const Halving& found, double limit) {
  for (const char* norm : {"u in L2", "u in H1"})
    record.at_least(title + ": order in dt of " + norm, found.order_of(norm), limit);
  for (const char* norm : {"phi in L2", "p in L2"})
    record.measured(title + ": order in dt of " + norm, found.order_of(norm));
}

TEST(OrderInTime, OfTheSchemes) {
  Record record("manufactured_time");
  const Manufactured mms = manufactured("ref8_mms", "time-only", 0, 2);
  const auto mesh = quadrilaterals(mms, Quads::uniform, 2.5);
  const Problem problem(mms, *mesh);
  const Halving alpha = halving(problem, {100, 200, 400, 800, 1600}, SchemeKind::generalised_alpha);
  const Halving coarse = halving(problem, {50, 100, 200}, SchemeKind::sdirk4);
  const Halving fine = halving(problem, {400, 800, 1600}, SchemeKind::sdirk4);
  record_orders(record, "generalised_alpha, steps of 2 to 0.125 ms", alpha, 1.95);
  record_orders(record, "sdirk4, steps of 0.5 to 0.125 ms", fine, 3.95);
  for (const char* norm : {"u in L2", "phi in L2", "p in L2"}) {
    record.measured(std::string("sdirk4, steps of 4 to 1 ms: order in dt of ") + norm, coarse.order_of(norm));
    Halving all = coarse;
    all.step.insert(all.step.end(), fine.step.begin(), fine.step.end());
    auto& error = all.error[norm];
    error.insert(error.end(), fine.error.at(norm).begin(), fine.error.at(norm).end());
    record.curve(curve_of(alpha, norm, 2., "generalised_alpha"));
    record.curve(curve_of(all, norm, 4., "sdirk4"));
  }
}

}  // namespace time_test
}  // namespace upbead::test
