// Claim: both time schemes give the exact motion of one degree of freedom under impulsive forces: histories, and
// shock spectra (largest and least F_T, largest spring force) of triangles with rise fractions 0.5, 0.3, 0.1 and
// 0 (a jump at t = 0) and of church roofs, without damping and with 5, 10 and 20 %.
// Source: tests/reference/ref5_lumped.json (superposed ramps, exact; its 8 digits are good to 5e-8). A church
// roof there is a triangle that falls to a plateau at t_d; the plateau is kept for t_plateau and falls to zero
// within a period.
// Limit: 1e-6 of the force's peak. The second-order scheme needs thousands of steps a period for it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "lumped.h"
#include "record.h"
#include "reference.h"

namespace upbead::test {
namespace one_degree_test {

/// Steps a period: enough for 1e-6, of the largest and least values and of histories. Extremes need fewer, as an
/// error of phase does not affect them.
struct Steps {
  double spectrum = 0., history = 0.;
};
Steps steps_a_period(SchemeKind kind) {
  return kind == SchemeKind::sdirk4 ? Steps{200., 200.} : Steps{4000., 10000.};
}

TimeFunction force(double duration, double rise_fraction, double plateau, double plateau_duration) {
  const double rise = rise_fraction * duration;
  const TimeFunction triangle = pulse(1. - plateau, rise, duration);
  if (plateau == 0.) return triangle;
  return sum(triangle, sum(ramp(plateau, 0., rise), ramp(-plateau, duration + plateau_duration, 1.)));
}

struct Spectrum {
  std::vector<double> largest, least, spring;
};

Spectrum spectrum(SchemeKind kind, const Json& table) {
  const double plateau = table.at("plateau"), plateau_duration = table.at("t_plateau_over_Tn");
  const double loads_over = plateau > 0. ? plateau_duration + 1. : 0.;
  Spectrum found;
  for (const double duration : table.at("td_over_Tn")) {
    const System system =
        one_degree(table.at("zeta"), force(duration, table.at("rise_fraction"), plateau, plateau_duration));
    // One more period contains the extremes of the free vibration.
    const Response response = march_with(kind, system, duration + loads_over + 1., 1. / steps_a_period(kind).spectrum);
    found.largest.push_back(extreme(system, response, "shear_force", 1));
    found.least.push_back(-extreme(system, response, "shear_force", -1));
    found.spring.push_back(extreme(system, response, "spring_force", 1));
  }
  return found;
}

std::string percent(double fraction) {
  return std::to_string(static_cast<int>(std::lround(100. * fraction))) + " %";
}

/// Whether a table is drawn: one figure for each kind of force is enough.
bool drawn(const Json& table) {
  return table.at("plateau") == 0.3 ||
         (table.at("plateau") == 0. && (table.at("rise_fraction") == 0.5 || table.at("rise_fraction") == 0.));
}

using Chosen = std::function<bool(const Json&)>;

/// Compares the tables of `list` that are chosen: all four damping ratios of a triangle, both of a church roof.
void compare_spectra(Record& record, SchemeKind kind, const std::string& shape, const char* list,
                     const Chosen& chosen) {
  double worst = 0.;
  int tables = 0;
  const Json all = reference("ref5_lumped");
  for (const Json& table : all.at(list)) {
    if (!chosen(table)) continue;
    ++tables;
    const Spectrum found = spectrum(kind, table);
    const std::vector<double> exact = table.at("peak_FT");
    worst =
        std::max({worst, largest_error(found.largest, exact, 1.), largest_error(found.least, table.at("min_FT"), 1.),
                  largest_error(found.spring, table.at("peak_kx"), 1.)});
    if (kind == SchemeKind::sdirk4 && drawn(table))
      record.curve({"one degree of freedom, " + shape, "duration / period", "largest F_T / peak P",
                    "damping " + percent(table.at("zeta")), table.at("td_over_Tn"), exact, found.largest});
  }
  EXPECT_GE(tables, 2);
  record.at_most("one degree of freedom, " + shape + ", " + title(kind, steps_a_period(kind).spectrum) +
                     ": largest and least F_T, largest spring force, of the peak of P",
                 worst, 1e-6);
}

void compare_triangles(SchemeKind kind, double rise_fraction) {
  Record record("lumped");
  compare_spectra(record, kind, "triangles of rise fraction " + std::to_string(rise_fraction).substr(0, 3),
                  "sdof_spectrum", [&](const Json& table) { return table.at("rise_fraction") == rise_fraction; });
}

void compare_roofs(SchemeKind kind) {
  Record record("lumped");
  for (const double plateau : {0.3, 0.5})
    compare_spectra(record, kind, "church roofs of plateau " + std::to_string(plateau).substr(0, 3),
                    "sdof_spectrum_church_roof", [&](const Json& table) { return table.at("plateau") == plateau; });
}

void compare_histories(SchemeKind kind) {
  Record record("lumped");
  double worst = 0.;
  const Json all = reference("ref5_lumped");
  for (const Json& table : all.at("sdof_histories")) {
    const double duration = table.at("td_over_Tn");
    const System system = one_degree(table.at("zeta"), pulse(1., 0.5 * duration, duration));
    const std::vector<double> times = table.at("t_over_Tn"), shear = table.at("FT_over_Ppk");
    // The times of the table, multiples of 1/20, are ends of steps.
    const Response response = march_with(kind, system, times.back(), 1. / steps_a_period(kind).history);
    const auto at_times = [&](const char* reading) {
      return sampled(response.ends.time, response.ends.reading.row(system.reading(reading)), times);
    };
    const auto found = at_times("shear_force");
    worst = std::max(
        {worst, largest_error(found, shear, 1.), largest_error(at_times("spring_force"), table.at("kx_over_Ppk"), 1.)});
    if (kind == SchemeKind::sdirk4 && table.at("zeta") == 0.05)
      record.curve({"one degree of freedom, 5 % damping: histories", "time / period", "F_T / peak P",
                    "duration " + std::to_string(duration).substr(0, 3) + " periods", times, shear, found});
  }
  record.at_most("one degree of freedom, histories under symmetric triangles, " +
                     title(kind, steps_a_period(kind).history) + ": F_T and spring force, of the peak of P",
                 worst, 1e-6);
}

class OneDegree : public ::testing::TestWithParam<SchemeKind> {};

TEST_P(OneDegree, SpectraOfSymmetricTriangles) {
  compare_triangles(GetParam(), 0.5);
}
TEST_P(OneDegree, SpectraOfSkewTriangles) {
  compare_triangles(GetParam(), 0.3);
}
TEST_P(OneDegree, SpectraOfSteepTriangles) {
  compare_triangles(GetParam(), 0.1);
}
TEST_P(OneDegree, SpectraOfJumps) {
  compare_triangles(GetParam(), 0.);
}
TEST_P(OneDegree, SpectraOfChurchRoofs) {
  compare_roofs(GetParam());
}
TEST_P(OneDegree, Histories) {
  compare_histories(GetParam());
}

std::string name_of(const ::testing::TestParamInfo<SchemeKind>& test) {
  return test.param == SchemeKind::sdirk4 ? "sdirk4" : "generalised_alpha";
}
INSTANTIATE_TEST_SUITE_P(, OneDegree, ::testing::Values(SchemeKind::sdirk4, SchemeKind::generalised_alpha), name_of);

}  // namespace one_degree_test
}  // namespace upbead::test
