// Claim: errors fall with the size h of the cells as the elements' theory says, on squares, on perturbed quadrilaterals
// and on trapezoids: u in Q(k), phi in Q(k - 1), W in DGQ(k - 1).
//
// Sources: tests/reference/ref8_mms.json (darcy flow, delta = 0: trigonometric with three sets of constants, and two
// layers whose coefficients jump) and mms_inertial.json (inertial flow, two sets). All sides are free and sealed;
// tractions and fluxes come from the closed forms, the initial state is interpolated.
//
// Order: least squares over the three finest of four meshes, errors at t_end. Degree 2 has 2, 4, 8, 16 cells on 5 m;
// degree 3 has 2, 4, 8, 12.
//
// Limits: degree 2: u 1.9 in L2 and H1 (the pressure's error drives u; 2.9 shows only before that), phi and p 1.9, W
// 0.9; degree 3: u 3.9 and 2.9, phi and p 2.9, W 1.9. They also hold in the limit of short steps: in one trial with
// steps a quarter as long every order still passed.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>

#include "norms.h"
#include "record.h"

namespace upbead::test {
namespace space_test {

struct Study {
  std::string name;   ///< of the test
  std::string title;  ///< in the records
  std::string file, kind;
  std::size_t set;
  int degree;
  int steps;   ///< to t_end
  bool drawn;  ///< in the figure
};

/// Names the parameter of a test.
void PrintTo(const Study& study, std::ostream* out) {
  *out << study.name;
}

/// Least order that is required.
double limit(const std::string& norm, int degree) {
  static const std::map<std::string, std::array<double, 2>> limits{{"u in L2", {1.9, 3.9}},
                                                                   {"u in H1", {1.9, 2.9}},
                                                                   {"phi in L2", {1.9, 2.9}},
                                                                   {"p in L2", {1.9, 2.9}},
                                                                   {"W in L2", {0.9, 1.9}}};
  return limits.at(norm)[degree == 2 ? 0 : 1];
}

/// The errors, and through the finest of them a line of the order that theory gives.
Curve curve_of(const Refinement& found, const std::string& norm, int degree, const std::string& label) {
  Curve curve{norm + ", degree " + std::to_string(degree) + " (log-log)",
              "h (m)",
              "relative error",
              label,
              found.h,
              {},
              found.error.at(norm)};
  const double slope = std::round(limit(norm, degree));
  for (const double h : found.h) curve.exact.push_back(curve.computed.back() * std::pow(h / found.h.back(), slope));
  return curve;
}

class OrderInSpace : public testing::TestWithParam<Study> {};

TEST_P(OrderInSpace, IsThatOfTheElements) {
  const Study& study = GetParam();
  Record record(study.kind == "inertial" ? "manufactured_inertial" : "manufactured_darcy");
  const Manufactured mms = manufactured(study.file, study.kind, study.set, study.degree);
  const std::vector<double> h = study.degree == 2 ? std::vector<double>{2.5, 1.25, 0.625, 0.3125}
                                                  : std::vector<double>{2.5, 1.25, 0.625, 5. / 12.};
  std::map<std::string, double> least;
  for (const Quads quads : {Quads::uniform, Quads::perturbed, Quads::trapezoid}) {
    const Refinement found = refinement(mms, quads, h, mms.end, study.steps);
    for (const auto& [norm, error] : found.error) {
      const double order = found.order_of(norm);
      const auto before = least.emplace(norm, std::numeric_limits<double>::infinity()).first;
      before->second = std::isnan(order) ? order : std::min(before->second, order);
      const bool few = norm == "u in L2" || norm == "p in L2" || norm == "W in L2";
      if (study.drawn && few) record.curve(curve_of(found, norm, study.degree, name_of(quads)));
    }
  }
  for (const auto& [norm, order] : least)
    record.at_least(study.title + ", degree " + std::to_string(study.degree) + ": order in h of " + norm +
                        ", least of uniform, perturbed and trapezoid meshes",
                    order, limit(norm, study.degree));
}

const std::string trig = "trigonometric", nearly_undrained = "trigonometric, nearly undrained, damped",
                  stiff = "trigonometric, nu = 0.49", layers = "jumping coefficients",
                  air = "inertial, air in the water", water = "inertial, no air, damped";

const auto by_name = [](const testing::TestParamInfo<Study>& each) { return each.param.name; };

INSTANTIATE_TEST_SUITE_P(
    Manufactured, OrderInSpace,
    testing::Values(Study{"TrigDegree2", trig, "ref8_mms", "trig", 0, 2, 100, true},
                    Study{"NearlyUndrainedDegree2", nearly_undrained, "ref8_mms", "trig", 1, 2, 100, false},
                    Study{"NearlyIncompressibleDegree2", stiff, "ref8_mms", "trig", 2, 2, 150, false},
                    Study{"TwoLayersDegree2", layers, "ref8_mms", "two-layer", 0, 2, 100, false},
                    Study{"InertialAirDegree2", air, "mms_inertial", "inertial", 0, 2, 100, true},
                    Study{"InertialDampedDegree2", water, "mms_inertial", "inertial", 1, 2, 100, false}),
    by_name);

INSTANTIATE_TEST_SUITE_P(
    ManufacturedAtLength, OrderInSpace,
    testing::Values(Study{"TrigDegree3", trig, "ref8_mms", "trig", 0, 3, 300, true},
                    Study{"NearlyUndrainedDegree3", nearly_undrained, "ref8_mms", "trig", 1, 3, 300, false},
                    Study{"NearlyIncompressibleDegree3", stiff, "ref8_mms", "trig", 2, 3, 500, false},
                    Study{"TwoLayersDegree3", layers, "ref8_mms", "two-layer", 0, 3, 300, false},
                    Study{"InertialAirDegree3", air, "mms_inertial", "inertial", 0, 3, 200, true},
                    Study{"InertialDampedDegree3", water, "mms_inertial", "inertial", 1, 3, 200, false}),
    by_name);

}  // namespace space_test
}  // namespace upbead::test
