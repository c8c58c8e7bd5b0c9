// Claims: a sealed column whose soil packs denser has the pore pressure that follows from its storage and K eps_v; a
// drained one settles by K/M eps_v of its height; partly drained, it follows an independent computation in one
// dimension over time; sand that has lost its effective stress is reported; scaled by Froude's law the strains are
// the same. On a layered section compaction adds settlement and pore pressure, and the balance of energy closes.

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "case/scale.h"
#include "findings/find.h"
#include "good_case.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/case/case_run.h"

namespace upbead::test {
namespace densification_run_test {

using Answer = upbead::Run;  // testing::Test has a member of that name

constexpr double height = 4., G = 50e6, nu = 0.3, n = 0.4, K_f = 1e8, conductivity = 1e-3, pi = 3.14159265358979;
constexpr double lambda = 2. * G * nu / (1. - 2. * nu), M = lambda + 2. * G, K = lambda + 2. / 3. * G;
constexpr double Q = K_f / n, c1 = 0.8, c2 = 0.5;

const char* const column_geo = R"(
DefineConstant[ height = 4 ];  // m: of the column
Point(1) = {0, 0, 0}; Point(2) = {height / 4, 0, 0}; Point(3) = {height / 4, height, 0}; Point(4) = {0, height, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 2; Transfinite Curve {2, 4} = 41;
Transfinite Surface {1}; Recombine Surface {1};
Physical Surface("soil") = {1};
Physical Curve("base") = {1}; Physical Curve("sides") = {2, 4}; Physical Curve("top") = {3};
)";

/// Under a traction of 100 kPa sin(2 pi t / 1 s) for three cycles, without inertia.
std::string column_case(const std::string& soil, const std::string& top, const std::string& end) {
  return R"([mesh]
file = "column.geo"
[fluid]
density = 1000
bulk_modulus = 1e8
[initial]
water_level = 10
k0 = 0.5
start = "virgin"
bounds = false
[initial.surcharge.load]
boundary = "top"
weight = 400e3
[regions.soil]
kind = "porous"
shear_modulus = 50e6
poissons_ratio = 0.3
porosity = 0.4
grain_density = 2650
)" + soil +
         R"(
[boundaries]
base = { displacement = "fixed", pressure = "sealed" }
sides = { displacement = "roller", pressure = "sealed" }
top = { pressure = ")" +
         top + R"(" }
[loads.cycles]
boundary = "top"
kind = "traction"
direction = [0.0, -1.0]
history = "cycles.csv"
[probes.top]
at = [0.5, 4.0]
[probes.base]
at = [0.5, 0.0]
[probes.middle]
at = [0.5, 2.0]
[time]
inertia = false
step = 0.01
end = )" +
         end + "\n";
}

const std::string linear = "law = \"hysteretic\"\nstrain = { reference_strain = 1e3 }\n";
const std::string denser = "densification = { c1 = 0.8, c2 = 0.5 }\n";
const std::string permeable = "hydraulic_conductivity = 1e-3\n";

double cycles(double t) {
  return t < 3. ? 100e3 * std::sin(2. * pi * t) : 0.;
}

class DensificationRun : public InFolder {
 protected:
  DensificationRun() {
    static const PetscSession petsc;  // MPI starts once in a process
    write("column.geo", column_geo);
    std::string text = "time,traction\n";
    for (int i = 0; i <= 300; ++i) text += std::to_string(0.01 * i) + "," + std::to_string(cycles(0.01 * i)) + "\n";
    write("cycles.csv", text);
    unsetenv("UPBEAD_MESHES");  // so that the shipped geometries are used
  }
  static Answer run(const std::string& text) {
    write("case.toml", text);
    const Case input = read_case("case.toml");
    return solve(input, simulation_of(input));
  }
  static std::vector<double> history(const Answer& run, const std::string& reading) {
    const auto row = run.response.ends.reading.row(run.simulation->system().reading(reading)).eval();
    return {row.begin(), row.end()};
  }
};

TEST_F(DensificationRun, SealedColumnHasThePressureOfKTimesTheVolumetricStrain) {
  const Answer found = run(column_case(linear + denser + permeable, "sealed", "3.2"));
  const CompactedSoil& soil = found.summary.densification.at(0);
  ASSERT_GT(soil.mean, 1e-4);
  EXPECT_NEAR(soil.largest, soil.mean, 1e-6 * soil.mean) << "uniform";
  const double exact = Q * K * soil.mean / (M + Q);
  EXPECT_NEAR(history(found, "probes/base/pressure").back(), exact, 1e-6 * exact);
  EXPECT_NEAR(history(found, "probes/top/displacement_y").back(), -height * exact / Q, 1e-6 * height * exact / Q);
  EXPECT_NEAR(*soil.pressure_at_end, exact, 1e-6 * exact);
  EXPECT_EQ(soil.reversals, 6);
  EXPECT_GT(soil.energy, 0.);
  EXPECT_LE(soil.energy, found.summary.energy->plastic * (1. + 1e-12));
  EXPECT_LT(found.summary.energy->mismatch(), 1e-9);
}

TEST_F(DensificationRun, DrainedColumnSettlesByTheVolumetricStrain) {
  const Answer found = run(column_case(linear + denser + "flow = \"drained\"\n", "open", "3.2"));
  const CompactedSoil& soil = found.summary.densification.at(0);
  ASSERT_GT(soil.mean, 1e-4);
  const double exact = -height * K / M * soil.mean;
  EXPECT_NEAR(history(found, "probes/top/displacement_y").back(), exact, 1e-6 * std::abs(exact));
  EXPECT_FALSE(soil.pressure_at_end);
  // half cycles by hand, with the amplitude of strain by the traction alone; the settlement changes it a little
  double eps = 0.;
  for (int half = 0; half < 7; ++half) {
    const double gamma = (half == 0 || half == 6 ? 0.5 : 1.) * 100e3 / M;
    eps += 0.5 * gamma * c1 * std::exp(-c2 * eps / gamma);
  }
  EXPECT_NEAR(soil.mean, eps, 0.08 * eps);
}

TEST_F(DensificationRun, WithoutShearNothingPacksDenser) {
  std::string text = column_case(linear + denser + permeable, "sealed", "3.2");
  text.replace(text.find("history ="), 0, "factor = 0.0\n");
  const Answer found = run(text);
  EXPECT_EQ(found.summary.densification.at(0).largest, 0.);
  EXPECT_EQ(history(found, "probes/base/pressure").back(), 0.);
}

/// An independent computation of a column in one dimension: total stress q, s = (q - p + K eps_v)/M the strain
/// (compression), p/Q - s the change of the water's volume, by Darcy's flow; implicit Euler in small steps.
class Column {
 public:
  explicit Column(int cells) : p_(cells, 0.), s_(cells, 0.), from_(cells, 0.), far_(p_), eps_(p_), before_(p_) {}
  void march(double end, double step, const std::function<void(double)>& see) {
    double q = 0.;
    for (double t = step; t < end + 0.5 * step; t += step) {
      flow(step, cycles(t) - q);
      q = cycles(t);
      for (std::size_t i = 0; i < p_.size(); ++i) count(i, (q - p_[i] + K * eps_[i]) / M);
      see(t);
    }
  }
  double base() const { return p_.front(); }
  double middle() const { return 0.5 * (p_[p_.size() / 2 - 1] + p_[p_.size() / 2]); }
  double mean_strain() const {
    double sum = 0.;
    for (const double eps : eps_) sum += eps / static_cast<double>(eps_.size());
    return sum;
  }
  double settlement() const {
    double sum = 0.;
    for (const double s : s_) sum += s * height / static_cast<double>(s_.size());
    return sum;
  }

 private:
  /// (1/Q + 1/M) dp = (dq + K deps_v)/M + step k/(rho g) p'' ; the base is sealed, the top open.
  void flow(double step, double more) {
    const std::size_t cells = p_.size();
    const double storage = 1. / Q + 1. / M, size = height / static_cast<double>(cells);
    const double r = step * conductivity / (1000. * 9.81) / (size * size);
    std::vector<double> diagonal(cells), right(cells);
    for (std::size_t i = 0; i < cells; ++i) {
      diagonal[i] = storage + (i == 0 ? r : i + 1 == cells ? 3. * r : 2. * r);
      right[i] = storage * p_[i] + (more + K * (eps_[i] - taken(i))) / M;
    }
    for (std::size_t i = 1; i < cells; ++i) {
      const double factor = -r / diagonal[i - 1];
      diagonal[i] += factor * r;
      right[i] -= factor * right[i - 1];
    }
    p_[cells - 1] = right[cells - 1] / diagonal[cells - 1];
    for (std::size_t i = cells - 1; i-- > 0;) p_[i] = (right[i] + r * p_[i + 1]) / diagonal[i];
    used_ = eps_;
  }
  double taken(std::size_t i) const { return used_.empty() ? 0. : used_[i]; }
  /// Counts half cycles of the strain by Byrne's law.
  void count(std::size_t i, double s) {
    s_[i] = s;
    if (std::abs(s - from_[i]) < std::abs(far_[i] - from_[i]) || (s - from_[i]) * (far_[i] - from_[i]) < 0.) {
      from_[i] = far_[i];
      before_[i] = eps_[i];
    }
    far_[i] = s;
    const double gamma = 0.5 * std::abs(s - from_[i]);
    if (gamma > 0.) eps_[i] = before_[i] + 0.5 * gamma * c1 * std::exp(-c2 * before_[i] / gamma);
  }

  std::vector<double> p_, s_, from_, far_, eps_, before_, used_;
};

TEST_F(DensificationRun, DrainingColumnFollowsAProgramInOneDimension) {
  std::string text = column_case(linear + denser + permeable, "open", "20");
  text.replace(text.find("step = 0.01"), 11, "step = 0.005");
  const Answer found = run(text);
  const std::vector<double> base = history(found, "probes/base/pressure"),
                            top = history(found, "probes/top/displacement_y"),
                            middle = history(found, "probes/middle/pressure");
  Column exact(200);
  double largest = 0., settled = 0., off = 0., off_middle = 0., off_top = 0.;
  std::size_t i = 0;
  exact.march(20., 1e-3, [&](double t) {
    while (i + 1 < base.size() && found.response.ends.time[i] < t - 1e-9) ++i;
    if (std::abs(found.response.ends.time[i] - t) > 1e-9) return;
    largest = std::max(largest, std::abs(exact.base()));
    settled = std::max(settled, std::abs(exact.settlement()));
    off = std::max(off, std::abs(base[i] - exact.base()));
    off_middle = std::max(off_middle, std::abs(middle[i] - exact.middle()));
    off_top = std::max(off_top, std::abs(top[i] + exact.settlement()));
  });
  EXPECT_LT(off, 0.01 * largest);
  EXPECT_LT(off_middle, 0.01 * largest);
  EXPECT_LT(off_top, 0.01 * settled);
  const double by_hand = height * K / M * exact.mean_strain();
  EXPECT_NEAR(-top.back(), by_hand, 0.02 * by_hand) << "all water has gone";
  EXPECT_LT(std::abs(base.back()), 0.01 * largest);
}

TEST_F(DensificationRun, LengthsTimesTwentyByFroudeKeepTheStrains) {
  const Answer small = run(column_case(linear + denser + permeable, "sealed", "3.2"));
  const Case input = read_case("case.toml");
  const ScaledCase scaled = scale_case(input, {20., SoilScaling::froude, {}}, "big");
  std::filesystem::create_directories("big");
  for (const NamedText& file : scaled.histories) write("big/" + file.path, file.text);
  write("big/case.toml", scaled.text);
  const Case big_input = read_case("big/case.toml");
  const Answer big = solve(big_input, simulation_of(big_input));
  const CompactedSoil &a = small.summary.densification.at(0), &b = big.summary.densification.at(0);
  EXPECT_NEAR(b.mean, a.mean, 1e-6 * a.mean);
  EXPECT_NEAR(*b.pressure_at_end, 20. * *a.pressure_at_end, 1e-6 * 20. * *a.pressure_at_end);
  EXPECT_NEAR(b.pressure_ratio_at_end, a.pressure_ratio_at_end, 1e-6);
}

TEST_F(DensificationRun, SandThatHasLostItsStressIsToldAndNoWorse) {
  std::string text = column_case(linear + "densification = { c1 = 8.0 }\n" + permeable, "sealed", "3.2");
  text.replace(text.find("400e3"), 5, "20e3");
  text.replace(text.find("history ="), 0, "factor = 0.15\n");
  const Answer found = run(text);
  const CompactedSoil& soil = found.summary.densification.at(0);
  EXPECT_GT(soil.largest_pressure_ratio, 0.95);
  EXPECT_GT(soil.share_liquefied, 0.5);
  const double p = history(found, "probes/middle/pressure").back();
  // at most the weight above it: the surcharge, and (1 - n)(rho_s - rho_f) g 2 m
  EXPECT_GT(p, 10e3);
  EXPECT_LT(p, 20e3 + 0.6 * 1650. * 9.81 * 2.);
  EXPECT_TRUE(std::any_of(found.summary.warnings.begin(), found.summary.warnings.end(),
                          [](const NumberedWarning& w) { return w.name == "liquefied"; }));
}

/// The stress that shear has taken does not come back as water drains, and does not keep it from settling.
TEST(SandThatPacks, HasSettledOnceItsWaterHasLeft) {
  Scene scene;
  scene.limits.settlement = 0.05;
  Summary s;
  s.nonlinear.emplace();
  s.residual.emplace().displacement_y = -0.01;
  s.densification.emplace_back().pressure_ratio_at_end = 0.7;
  using Pressure = std::optional<double>;  // none: drained soil, which has no water to lose
  for (const Pressure& left : {Pressure(), Pressure(0.7), Pressure(2e4)}) {
    s.densification[0].pressure_at_end = left;
    for (const Check& check : checks_of(scene, s)) {
      if (check.limit != "settlement") continue;
      EXPECT_EQ(check.holds, left > 1e4 ? std::nullopt : std::optional(true));
    }
  }
}

TEST_F(DensificationRun, SectionSettlesMoreAndKeepsPressureInItsSandAtLength) {
  std::ifstream file(UPBEAD_SECTION_CASE);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto replace = [&](const std::string& a, const std::string& b) { text.replace(text.find(a), a.size(), b); };
  replace("[regions.seabed]",
          "[initial]\nwater_level = 8\nbounds = false\n[regions.seabed]\nlaw = \"hysteretic\"\n"
          "strength = { friction_angle = 35 }");
  replace("[regions.mound]", "[regions.mound]\nlaw = \"hysteretic\"\nstrength = { friction_angle = 40 }");
  replace("peak = 1e6", "peak = 3e6");
  const Answer plain = run(text);
  replace("strength = { friction_angle = 35 }",
          "strength = { friction_angle = 35 }\ndensification = { relative_density = 0.5 }");
  replace("strength = { friction_angle = 40 }",
          "strength = { friction_angle = 40 }\ndensification = { relative_density = 0.7 }");
  const Answer found = run(text);
  EXPECT_TRUE(plain.summary.densification.empty());
  ASSERT_EQ(found.summary.densification.size(), 2u);
  EXPECT_LT(found.summary.residual->displacement_y, plain.summary.residual->displacement_y) << "settles more";
  for (const CompactedSoil& soil : found.summary.densification) {
    EXPECT_GT(soil.mean, 0.);
    EXPECT_GT(soil.largest, soil.mean);
    EXPECT_GT(*soil.pressure_at_end, 0.);
  }
  EXPECT_LT(found.summary.response->reaction_mismatch, 1e-4);
  EXPECT_LT(found.summary.energy->mismatch(), 1e-9);
  EXPECT_LT(std::abs(found.summary.energy->scheme), 0.02 * found.summary.energy->largest_work);
}

}  // namespace densification_run_test
}  // namespace upbead::test
