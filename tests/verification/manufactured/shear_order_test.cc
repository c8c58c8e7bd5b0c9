// Claim: in a whole scene, a breakwater under a wave, the caisson's motions converge with the order of the scheme;
// the orders of the shear force F_T and of pore pressures are recorded.
//
// Source: the program's own sdirk4 march with steps of 0.125 ms, an eighth of the shortest step of sdirk4 that is
// compared and a quarter of that of generalised_alpha: its error is about 1 % of the compared errors or less.
//
// The smooth pulse F (t/tau)^4 exp(4 - 4 t/tau) has a continuous third derivative at t = 0 and no kink; the triangle
// has kinks, which are ends of steps. Mound inertial, seabed darcy, 5 % damping or none. Errors are the largest over
// all steps until 0.4 s. F_T is the ground's reaction: at the ends of steps, and where generalised_alpha satisfies
// the equation of motion ("balanced").
//
// Limits for the motions under the smooth pulse: 1.95 and 3.95, by least squares.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "record.h"
#include "scenes.h"

namespace upbead::test {
namespace shear_order_test {

constexpr double end = 0.4, finest = 0.125e-3;  // s

TimeFunction smooth_pulse(double peak, double tau) {
  return TimeFunction({},
                      {[peak, tau](double t) { return peak * std::pow(t / tau, 4) * std::exp(4. - 4. * t / tau); }});
}

/// Value of a history with even steps, by the polynomial through six of its times.
double interpolated(const std::vector<double>& time, const Eigen::RowVectorXd& values, double at) {
  const auto last = static_cast<std::ptrdiff_t>(time.size()) - 6;
  const std::ptrdiff_t first = std::clamp<std::ptrdiff_t>(std::lround(at / (time[1] - time[0])) - 2, 0, last);
  double sum = 0.;
  for (std::ptrdiff_t i = first; i < first + 6; ++i) {
    double weight = 1.;
    for (std::ptrdiff_t j = first; j < first + 6; ++j)
      if (j != i)
        weight *= (at - time[static_cast<std::size_t>(j)]) /
                  (time[static_cast<std::size_t>(i)] - time[static_cast<std::size_t>(j)]);
    sum += weight * values[i];
  }
  return sum;
}

/// A breakwater, its reference march, and orders against it.
class Breakwater {
 public:
  Breakwater(const TimeFunction& force, bool damped)
      : mesh_(breakwater_mesh(0.25)),
        compiled_(scene(force, damped), *mesh_),
        reference_(run(compiled_, end, finest)) {}

  /// Order of the error of a reading, at the ends of steps or where the scheme is balanced.
  double order_of(const std::string& reading, SchemeKind scheme, bool balanced = false) {
    const int row = compiled_.system.reading(reading);
    const Eigen::RowVectorXd exact = reference_.ends.reading.row(row);
    std::vector<double> error;
    for (const Response& response : responses(scheme)) {
      const Series& series = balanced ? response.balanced : response.ends;
      double worst = 0.;
      for (std::size_t i = 0; i < series.time.size(); ++i)
        worst = std::max(worst, std::abs(series.reading(row, static_cast<Eigen::Index>(i)) -
                                         interpolated(reference_.ends.time, exact, series.time[i])));
      error.push_back(worst);
    }
    return order(steps(scheme), error);
  }

  static std::vector<double> steps(SchemeKind scheme) {
    return scheme == SchemeKind::sdirk4 ? std::vector<double>{4e-3, 2e-3, 1e-3}
                                        : std::vector<double>{2e-3, 1e-3, 0.5e-3};
  }

 private:
  static Scene scene(const TimeFunction& force, bool damped) {
    Scene scene = breakwater(force);
    scene.regions["mound"].flow = Flow::inertial;
    scene.regions["seabed"].flow = Flow::darcy;
    if (!damped)
      for (const char* soil : {"mound", "seabed"}) scene.regions[soil].damping.reset();
    scene.probes["mound"].at = {5., 3.};
    scene.probes["seabed"].at = {7., -4.};
    return scene;
  }

  const std::vector<Response>& responses(SchemeKind scheme) {
    auto& found = responses_[scheme];
    if (found.empty())
      for (const double step : steps(scheme)) found.push_back(run(compiled_, end, step, scheme));
    return found;
  }

  std::unique_ptr<Mesh> mesh_;
  Compiled compiled_;
  Response reference_;
  std::map<SchemeKind, std::vector<Response>> responses_;
};

void record_orders(Record& record, const std::string& title, Breakwater breakwater, bool smooth) {
  for (const SchemeKind scheme : {SchemeKind::generalised_alpha, SchemeKind::sdirk4}) {
    const bool alpha = scheme == SchemeKind::generalised_alpha;
    const std::string start =
        title + (alpha ? ", generalised_alpha, steps of 2 to 0.5 ms: " : ", sdirk4, steps of 4 to 1 ms: ") +
        "order in dt of ";
    for (const char* motion : {"displacement_x", "rotation"}) {
      const double order = breakwater.order_of(std::string("caisson/") + motion, scheme);
      const std::string what = start + "the caisson's " + (motion[0] == 'd' ? "sway" : "rotation");
      smooth ? record.at_least(what, order, alpha ? 1.95 : 3.95) : record.measured(what, order);
    }
    record.measured(start + "F_T at the ends of steps", breakwater.order_of("shear_force", scheme));
    if (alpha) record.measured(start + "F_T where balanced", breakwater.order_of("shear_force", scheme, true));
    for (const std::string soil : {"mound", "seabed"})
      record.measured(start + "p in the " + soil, breakwater.order_of("probes/" + soil + "/pressure", scheme));
  }
}

TEST(OrderInTime, SmoothPulseOnABreakwater) {
  Record record("manufactured_time");
  record_orders(record, "breakwater, smooth pulse, 5 % damping", {smooth_pulse(1e6, 0.05), true}, true);
}

TEST(OrderInTime, SmoothPulseOnAnUndampedBreakwater) {
  Record record("manufactured_time");
  record_orders(record, "breakwater, smooth pulse, no damping", {smooth_pulse(1e6, 0.05), false}, true);
}

TEST(OrderInTime, TriangleOnABreakwater) {
  Record record("manufactured_time");
  record_orders(record, "breakwater, triangle of 0.1 s, 5 % damping", {triangle(1e6, 0.1), true}, false);
}

}  // namespace shear_order_test
}  // namespace upbead::test
