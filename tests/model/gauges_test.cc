// Claim: pressures are linear between transducers, beyond them as stated; forces and moments are their exact
// integrals; for a peak narrower than the spacing the program warns, with an estimate near the true error.
#include "upbead/model/gauges.h"

#include <gtest/gtest.h>

#include <cmath>

namespace upbead {
namespace gauges_test {

constexpr double pi = 3.14159265358979323846;

/// Pressures p(y) f(t), f a triangle of 1 at 0.5 s.
template <class Pressure>
Gauges row(const std::vector<double>& places, Pressure p) {
  Gauges gauges;
  for (int i = 0; i <= 200; ++i) gauges.time.push_back(0.005 * i);
  for (const double y : places) {
    gauges.name.push_back("p" + std::to_string(gauges.name.size() + 1));
    gauges.place.push_back(y);
    gauges.pressure.emplace_back();
    for (const double t : gauges.time) gauges.pressure.back().push_back(p(y) * (1. - std::abs(2. * t - 1.)));
  }
  return gauges;
}

const std::vector<double> seven{0., 2., 4., 6., 8., 10., 12.};

NumberedWarning warning(const NumberedWarnings& list, const std::string& name) {
  for (const NumberedWarning& found : list)
    if (found.name == name) return found;
  return {};
}

TEST(Gauges, IntegrateALinearPressureExactly) {
  Gauges gauges = row({1., 2., 5.}, [](double y) { return 10. - y; });
  gauges.beyond = {Beyond::none, Beyond::none};
  const Resultant r = resultant(gauges, -100., 100.);
  EXPECT_NEAR(r.force[100], 10. * 4. - 0.5 * (25. - 1.), 1e-12);
  EXPECT_NEAR(r.moment[100], 5. * (25. - 1.) - (125. - 1.) / 3., 1e-12);
  EXPECT_NEAR(r.force[50], 0.5 * r.force[100], 1e-12);
}

TEST(Gauges, RunOnAsStated) {
  Gauges gauges = row({1., 2.}, [](double) { return 3.; });
  gauges.beyond = {Beyond::constant, Beyond::to_zero};
  gauges.zero_at = {0., 4.};
  const Resultant r = resultant(gauges, -1., 10.);
  EXPECT_NEAR(r.force[100], 3. * (2. + 1. + 1.), 1e-10);
  EXPECT_NEAR(r.moment[100], 3. * (0. + 1.5 + 1. * (2. + 2. / 3.)), 1e-10);
  EXPECT_NEAR(resultant(gauges, 1., 2.).force[100], 3., 1e-12);
  gauges.beyond = {Beyond::none, Beyond::none};
  EXPECT_NEAR(resultant(gauges, -1., 10.).force[100], 3., 1e-12);
}

TEST(Gauges, SharesAddUpToOne) {
  Gauges gauges = row(seven, [](double) { return 1.; });
  for (const double y : {-5., 0., 0.7, 2., 6.3, 12., 40.}) {
    double sum = 0.;
    for (std::size_t i = 0; i < gauges.count(); ++i) {
      Load load;
      load.shape = share(gauges, i);
      sum += intensity(load, y);
    }
    EXPECT_NEAR(sum, 1., 1e-12) << y;
  }
}

// exp(-(y - y0)^2 / (2 s^2)): trapezoids of spacing h err by up to h^2 / 12 times the difference of the slopes at the
// ends for a smooth peak, and by up to the whole force where s << h.
TEST(Gauges, TellAPeakNarrowerThanTheirSpacing) {
  const auto peak = [](double y0, double s) {
    return [=](double y) { return 1e5 * std::exp(-0.5 * (y - y0) * (y - y0) / (s * s)); };
  };
  for (const double s : {0.5, 0.7}) {
    Gauges gauges = row(seven, peak(6.3, s));
    gauges.beyond = {Beyond::none, Beyond::none};
    const double exact = 1e5 * s * std::sqrt(2. * pi), force = resultant(gauges, 0., 12.).force[100];
    const NumberedWarning told = warning(gauge_warnings("wall", gauges, {}), "gauges_too_sparse");
    ASSERT_EQ(told.name, "gauges_too_sparse") << s;
    EXPECT_GT(std::abs(force / exact - 1.), 0.03) << s;
    EXPECT_LT(std::abs(force / exact - 1.), 4. * told.value) << s << " " << force / exact << " " << told.value;
  }
  const Gauges wide = row(seven, peak(6.3, 3.));
  EXPECT_EQ(warning(gauge_warnings("wall", wide, {}), "gauges_too_sparse").name, "");
  EXPECT_LT(interpolation_error(wide).force, 0.05);
}

TEST(Gauges, SampledTooCoarselyAreToldOnce) {
  Gauges gauges = row({0., 2., 4.}, [](double) { return 0.; });
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t t = 0; t <= 200; ++t)  // rises of 12, 8 and 30 samples
      gauges.pressure[i][t] = std::max(0., 1. - std::abs(static_cast<double>(t) - 100.) / std::vector{12., 8., 30.}[i]);
  int told = 0;
  const NumberedWarnings list = gauge_warnings("wall", gauges, resultant(gauges, 0., 4.).force);
  for (const NumberedWarning& found : list) told += found.name == "record_too_coarse";
  const NumberedWarning found = warning(list, "record_too_coarse");
  EXPECT_EQ(told, 1);
  EXPECT_NEAR(found.value, 8., 1.);
  EXPECT_NE(found.text().find("'wall.p2'"), std::string::npos) << found.text();
  EXPECT_NE(found.text().find("; 1 more of its row"), std::string::npos) << found.text();
}

TEST(Gauges, AreComparedWithALoadCell) {
  Gauges gauges = row(seven, [](double y) { return 2e4 - 1e3 * y; });
  const std::vector<double> total = resultant(gauges, 0., 12.).force;
  gauges.load_cell = total;
  EXPECT_TRUE(gauge_warnings("wall", gauges, total).empty());
  for (double& force : gauges.load_cell) force *= 0.8;
  const NumberedWarning told = warning(gauge_warnings("wall", gauges, total), "load_cell_differs");
  EXPECT_NEAR(told.value, 0.25, 1e-12);
}

TEST(Gauges, TellExchangedHeightsByName) {
  Gauges gauges = row(seven, [](double y) { return 2e4 - 1e3 * y + 4e3 * std::sin(0.3 * y); });
  std::swap(gauges.pressure[1], gauges.pressure[4]);
  const NumberedWarning told = warning(gauge_warnings("wall", gauges, {}), "records_swapped");
  EXPECT_NE(told.text().find("'wall.p2' and 'wall.p5'"), std::string::npos) << told.text();
}

TEST(Gauges, OfAStandingWaveOnABedHaveNoResultant) {
  std::vector<double> many, few;
  for (int i = 0; i <= 80; ++i) many.push_back(0.5 * i);
  for (int i = 0; i <= 4; ++i) few.push_back(10. * i);
  const auto wave = [](double length) { return [length](double x) { return 1e4 * std::cos(2. * pi * x / length); }; };
  for (const double length : {80., 40., 20.}) {  // whole halves of a wave: they cancel to round-off
    const Gauges gauges = row(many, wave(length));
    EXPECT_FALSE(interpolation_error(gauges).has_resultant);
    EXPECT_LT(interpolation_error(gauges).force, 0.05) << length;
    EXPECT_EQ(warning(gauge_warnings("sea", gauges, {}), "gauges_too_sparse").name, "");
  }
  const NumberedWarning told = warning(gauge_warnings("sea", row(few, wave(13.)), {}), "gauges_too_sparse");
  EXPECT_EQ(told.name, "gauges_too_sparse") << "three waves on five transducers";
  EXPECT_EQ(told.text().find("e+"), std::string::npos) << told.text();
  const Gauges wall = row(seven, [](double y) { return 10. + y; });
  EXPECT_TRUE(interpolation_error(wall).has_resultant);
}

}  // namespace gauges_test
}  // namespace upbead
