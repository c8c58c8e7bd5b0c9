// Claims: a block on a layer that only shears moves like an oscillator whose spring is the soil's law: elastic and
// perfectly plastic (the exact slide on a rigid-plastic layer), and an overlay along the curve of G by strain. The
// more stress the soil of a section bears at rest, the more it yields; both routes to F_T and the energies agree;
// keys that yielding soil excludes are reported.

#include <cmath>
#include <vector>

#include "good_case.h"
#include "sheared_layer.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/case/case_run.h"

namespace upbead::test {
namespace yielding_run_test {

constexpr double B = 400., h = 1., mass = 4e6, G = 1e8, duration = 0.2, end = 0.8;

std::string layer_case(double peak, const std::string& law, double modulus = G) {
  return R"([mesh]
file = "layer.geo"
[initial]
water_level = -1
k0 = 1
start = "virgin"
bounds = false
[regions.soil]
kind = "solid"
deformation = "elastic"
density = 1e-3
poissons_ratio = 0.3
shear_modulus = )" +
         std::to_string(modulus) + "\n" + law + block_on_layer(peak) + "end = 0.8\nstep = 0.0005\n";
}

/// Shear stress of parallel elements, each of which slides at its own strength.
class Overlay {
 public:
  struct Element {
    double h, y;
  };
  explicit Overlay(std::vector<Element> elements) : elements_(std::move(elements)), slid_(elements_.size(), 0.) {}
  double stress(double gamma) {
    double sum = 0.;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      const auto [h, y] = elements_[i];
      const double trial = h * (gamma - slid_[i]), held = std::clamp(trial, -y, y);
      slid_[i] += (trial - held) / h;
      sum += held;
    }
    return sum;
  }

 private:
  std::vector<Element> elements_;
  std::vector<double> slid_;
};

struct Slide {
  double largest_F_T = 0., last = 0.;
};

/// The block on its layer, explicitly in small steps.
Slide slide(Overlay soil, double peak) {
  constexpr double step = 2e-6;
  double u = 0., v = 0.;
  Slide found;
  for (double t = 0.; t < end; t += step) {
    const double F_T = B * soil.stress(u / h), P = t < duration ? peak * (1. - std::abs(2. * t / duration - 1.)) : 0.;
    found.largest_F_T = std::max(found.largest_F_T, F_T);
    v += step * (P - F_T) / mass;
    u += step * v;
  }
  found.last = u;
  return found;
}

class YieldingRun : public InFolder {
 protected:
  Summary run(const std::string& text) {
    static const PetscSession petsc;  // MPI starts once in a process
    write("layer.geo", layer_geo(41));
    unsetenv("UPBEAD_MESHES");  // so that the shipped geometries are used
    write("case.toml", text);
    const Case input = read_case("case.toml");
    const Simulation scene = simulation_of(input);
    return solve(input, scene).summary;
  }
};

TEST_F(YieldingRun, BlockOnARigidPlasticLayerSlidesAsFarAsItIsExact) {
  const double strength = 5e3, peak = 5e6, stiff = 1e10;
  // without gravity, by which the layer would be squeezed out at its free sides, and without tension cracks
  const Summary found = run("gravity = 1e-6\n" + layer_case(peak,
                                                            "law = \"mohr_coulomb\"\nstrength = { friction_angle = 0, "
                                                            "cohesion = 5e3, tension = 1e9 }",
                                                            stiff));
  const Slide exact = slide(Overlay({{stiff, strength}}), peak);
  EXPECT_NEAR(found.response->peak_shear, B * strength, 5e-3 * B * strength);
  EXPECT_NEAR(found.residual->displacement_x, exact.last, 5e-3 * exact.last);
  // rigid-plastic: m s'' = P - F until the block stops
  double s = 0., v = 0.;
  for (double t = 0., step = 1e-6; t < end; t += step) {
    const double P = t < duration ? peak * (1. - std::abs(2. * t / duration - 1.)) : 0.;
    v = std::max(0., v + step * (P - B * strength) / mass);
    s += step * v;
  }
  EXPECT_NEAR(found.residual->displacement_x, s, 5e-3 * s) << "the exact slide";
  EXPECT_NEAR(found.energy->plastic, B * strength * s, 0.01 * B * strength * s);
  EXPECT_EQ(found.nonlinear->start, "static");
  EXPECT_TRUE(found.nonlinear->bounds.empty());
}

TEST_F(YieldingRun, BlockOnAHystereticLayerFollowsTheOverlay) {
  const double peak = 4e6;
  const Summary found = run(layer_case(
      peak, "law = \"hysteretic\"\nstrain = { modulus = [[1e-6, 1.0], [1e-5, 0.9], [1e-4, 0.6], [1e-3, 0.25]] }"));
  // the same curve: G/G_max linear in log gamma, at 12 strains equally spaced in log gamma
  std::vector<std::array<double, 2>> points;
  for (int i = 0; i < 12; ++i) {
    const double x = 3. * i / 11., gamma = 1e-6 * std::pow(10., x);
    const double ratio = x < 1. ? 1. - 0.1 * x : x < 2. ? 0.9 - 0.3 * (x - 1.) : 0.6 - 0.35 * (x - 2.);
    points.push_back({gamma, G * gamma * ratio});
  }
  std::vector<Overlay::Element> elements;
  double slope = G;
  for (int i = 0; i < 12; ++i) {
    const double next = i < 11 ? (points[i + 1][1] - points[i][1]) / (points[i + 1][0] - points[i][0]) : 0.;
    elements.push_back({slope - next, (slope - next) * points[i][0]});
    slope = next;
  }
  const Slide exact = slide(Overlay(elements), peak);
  EXPECT_NEAR(found.response->peak_shear, exact.largest_F_T, 5e-3 * exact.largest_F_T);
  EXPECT_NEAR(found.residual->displacement_x, exact.last, 0.01 * exact.last);
  EXPECT_EQ(found.nonlinear->start, "virgin");
}

const Check& displacement_check(const Summary& summary) {
  for (const Check& check : summary.checks)
    if (check.name == "displacement with the ground") return check;
  throw std::runtime_error("the displacement with the ground is not checked");
}

std::string with_friction(std::string text, double coefficient) {
  const std::string rigid = "kind = \"rigid\"\n";
  return text.replace(
      text.find(rigid), rigid.size(),
      rigid + "interface = { kind = \"friction\", coefficient = " + std::to_string(coefficient) + " }\n");
}

void expect_closed_balances(const Summary& s) {
  EXPECT_EQ(*displacement_check(s).demand, std::abs(s.residual->displacement_x)) << "slip counts in it";
  EXPECT_LT(s.response->reaction_mismatch, 1e-4);
  EXPECT_LT(s.energy->mismatch(), 1e-8);
}

TEST_F(YieldingRun, FrictionNodeByNodeOnSoilThatCannotYieldIsContactAlone) {
  const double peak = 5e6;
  const std::string strong = "law = \"mohr_coulomb\"\nstrength = { friction_angle = 0, cohesion = 1e9 }";
  const Summary slides = run(with_friction(layer_case(peak, strong), 0.05)),
                alone = run(with_friction(layer_case(peak, ""), 0.05));
  ASSERT_TRUE(slides.contact->solved && alone.contact->solved);
  EXPECT_GT(alone.contact->solved->slip, 5e-3);
  EXPECT_NEAR(slides.contact->solved->slip, alone.contact->solved->slip, 1e-3 * alone.contact->solved->slip);
  EXPECT_NEAR(slides.energy->friction, alone.energy->friction, 1e-3 * alone.energy->friction);
  EXPECT_EQ(slides.energy->plastic, 0.);
  expect_closed_balances(slides);
}

TEST_F(YieldingRun, FrictionNodeByNodeAndSoilInOneStageAtLength) {
  const double peak = 5e6;
  const std::string weak = "law = \"mohr_coulomb\"\nstrength = { friction_angle = 0, cohesion = 5e3 }";
  // friction that prevents all slip: soil alone
  const Summary holds = run(with_friction(layer_case(peak, weak), 50.)), bonded = run(layer_case(peak, weak));
  EXPECT_NEAR(holds.residual->displacement_x, bonded.residual->displacement_x, 1e-5 * bonded.residual->displacement_x);
  EXPECT_NEAR(holds.response->peak_shear, bonded.response->peak_shear, 1e-5 * bonded.response->peak_shear);
  EXPECT_EQ(holds.energy->friction, 0.);
  // both: F_T stays below the lower of the two strengths
  const Summary both = run(with_friction(layer_case(peak, weak), 0.045));
  EXPECT_GT(both.energy->friction, 0.);
  EXPECT_LT(both.response->peak_shear, 1.001 * 0.045 * mass * 9.81);
  for (const Summary& s : {holds, both}) expect_closed_balances(s);
}

TEST_F(YieldingRun, BearsLessAndMovesMoreTheMoreItBearsAtRest) {
  std::ifstream file(UPBEAD_SECTION_CASE);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto replace = [&](const std::string& a, const std::string& b) { text.replace(text.find(a), a.size(), b); };
  replace("[regions.seabed]",
          "[initial]\nwater_level = 8\n[regions.seabed]\nlaw = \"hysteretic\"\n"
          "strength = { friction_angle = 35 }");
  replace("[regions.mound]", "[regions.mound]\nlaw = \"hysteretic\"\nstrength = { friction_angle = 40 }");
  replace("peak = 1e6", "peak = 4e6");
  text += "[sliding]\nsubmerged_weight = 1e6\n[limits]\nsliding = 0.01\n";
  const Summary found = run(text);
  const NonlinearSummary& n = *found.nonlinear;
  EXPECT_EQ(n.start, "k0");
  ASSERT_EQ(n.bounds.size(), 2u);
  const Check& moved = displacement_check(found);
  double carried = std::abs(found.residual->displacement_x);
  for (const StartBound& bound : n.bounds) carried = std::max(carried, std::abs(bound.residual.displacement_x));
  EXPECT_EQ(*moved.demand, carried + std::abs(found.sliding->design.value));
  EXPECT_GT(found.sliding->design.value, 0.);
  EXPECT_FALSE(*moved.holds);
  EXPECT_NE(moved.assumption.find("from the start gravity"), std::string::npos) << moved.assumption;
  const StartBound& virgin = n.bounds[0].start == "virgin" ? n.bounds[0] : n.bounds[1];
  const StartBound& gravity = n.bounds[0].start == "virgin" ? n.bounds[1] : n.bounds[0];
  EXPECT_GT(virgin.peak_shear, found.response->peak_shear);
  EXPECT_LT(gravity.peak_shear, found.response->peak_shear);
  EXPECT_LT(virgin.residual.displacement_x, found.residual->displacement_x);
  EXPECT_GT(gravity.residual.displacement_x, found.residual->displacement_x);
  EXPECT_GT(gravity.residual.rotation, virgin.residual.rotation);
  EXPECT_LT(gravity.residual.displacement_y, found.residual->displacement_y) << "settles more";
  EXPECT_LT(found.residual->displacement_y, 0.);
  EXPECT_LT(found.response->reaction_mismatch, 1e-4);
  EXPECT_LT(found.energy->mismatch(), 1e-9);
  EXPECT_GT(found.energy->plastic, 0.2 * found.energy->largest_work);
  EXPECT_FALSE(found.error.has_value());
}

}  // namespace yielding_run_test
}  // namespace upbead::test
