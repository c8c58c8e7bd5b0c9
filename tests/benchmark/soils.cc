// One reduced model for many soils, against runs of each soil: errors, estimates, times.
//
// usage: bench_soils CASE N_TRUTH POINTS TOLERANCE [KEY=VALUE]...
// SOILS_BEFORE=N leaves out the first N unseen soils, ONLY_POLES=1 looks at the poles of the others alone.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

#include "base/stopwatch.h"
#include "case/case_run.h"
#include "dynamics/state_space.h"
#include "fem/affine_scene.h"
#include "response/held_readings.h"
#include "response/reduction.h"
#include "response/soil_family.h"
#include "upbead/algebra/petsc_session.h"

namespace upbead {
namespace {

using Regions = std::map<std::string, Region>;

/// A random soil of the box: G by 1/3 to 3, k by 1/10 to 10, damping 2 to 10 %, nu 0.25 to 0.45.
Regions random_soil(Regions regions, std::mt19937& rng, bool damped) {
  std::uniform_real_distribution<double> unit(0., 1.);
  for (auto& [name, r] : regions) {
    if (r.kind != RegionKind::porous) continue;
    *r.shear_modulus *= std::pow(9., unit(rng) - 0.5);
    *r.hydraulic_conductivity *= std::pow(100., unit(rng) - 0.5);
    r.poissons_ratio = 0.25 + 0.2 * unit(rng);
    const double zeta = 0.02 + 0.08 * unit(rng);
    if (damped && r.damping) r.damping->ratio = zeta;
  }
  return regions;
}

std::map<std::string, Coefficients> of_regions(const Scene& scene, const Regions& regions) {
  return coefficients(regions, scene.fluid, scene.gravity);
}

/// The scene reduced to a tolerance.
Reduction reduced_to(double tolerance, Scene scene, const CompiledScene& compiled, const ReductionTargets& targets) {
  scene.tolerance = tolerance;
  return reduce_scene(scene, compiled, targets);
}

/// Histories of what a family holds, under the scene's loads.
Eigen::MatrixXd held_of(const Scene& scene, const Reduction& reduction, const CompiledScene& compiled) {
  const HeldReadings held = held_readings(reduction.model.reading_label, compiled.caisson->bottom_width);
  return held.sums * respond(reduction.model, sampled_loads(scene, compiled.system)).reading;
}

/// Largest real part of a pole over the largest pole, before round-off is cut off.
double growth(const Reduction& reduction) {
  const Eigen::VectorXcd pole =
      Eigen::EigenSolver<Eigen::MatrixXd>(state_space(reduction.system).A, false).eigenvalues();
  return pole.real().maxCoeff() / pole.cwiseAbs().maxCoeff();
}

/// Targets under which the sums of readings are as exact as F_T, or nearly.
ReductionTargets all_alike(int first_vectors) {
  ReductionTargets targets;
  targets.tolerance_of_others = 1e-4;
  targets.first_vectors = first_vectors;
  targets.most_vectors = most_of_member;
  return targets;
}

Eigen::VectorXd difference(const Eigen::MatrixXd& y, const Eigen::MatrixXd& exact) {
  return (y - exact).cwiseAbs().rowwise().maxCoeff().cwiseQuotient(exact.cwiseAbs().rowwise().maxCoeff());
}

void print(const std::string& what, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double p) { return values[static_cast<std::size_t>(p * (values.size() - 1.))]; };
  std::cout << what << ": least " << values.front() << ", 5 % " << at(0.05) << ", median " << at(0.5) << ", 95 % "
            << at(0.95) << ", largest " << values.back() << std::endl;
}

int main(int argc, char** argv) {
  const PetscSession petsc;
  std::vector<std::string> overrides(argv + 5, argv + argc);
  overrides.push_back("mesh.full_domain=true");
  Case input = read_case(argv[1], overrides);
  const int n_truth = std::stoi(argv[2]), points = std::stoi(argv[3]);
  const double tolerance = std::stod(argv[4]);
  const char* const before = std::getenv("SOILS_BEFORE");
  const int n_before = before ? std::stoi(before) : 0;
  const bool only_poles = std::getenv("ONLY_POLES") != nullptr;
  const Simulation s = simulation_of(input);
  const Scene& scene = s.scene();
  bool damped = true;
  for (const auto& [name, r] : scene.regions)
    if (r.kind == RegionKind::porous && !r.damping) damped = false;
  std::mt19937 rng(7);
  std::map<std::string, Varied> varied;
  const auto nominal = of_regions(scene, scene.regions);
  for (int i = 0; i < 5; ++i) {
    const auto other = of_regions(scene, random_soil(scene.regions, rng, damped));
    for (const auto& [name, c] : other)
      for (int q = 0; q < n_coefficients; ++q)
        if (c[q] != nominal.at(name)[q]) varied[name][q] = true;
  }
  Stopwatch watch;
  const AffineScene affine = affine_scene(scene, *s.mesh(), s.absent(), varied, false);
  std::cout << affine.parts.size() << " parts in " << watch.seconds() << " s\n";
  {
    const Regions soil = random_soil(scene.regions, rng, damped);
    Scene other = scene;
    other.regions = soil;
    const AssembledScene made = assemble_scene(other, *s.mesh(), s.absent(), {}, false);
    std::cout << "distance "
              << distance(made.compiled->system, affine.at(affine.factors(of_regions(scene, soil))).system) << "\n";
  }
  SoilFamilyOptions options;
  options.most_points = points;
  options.tolerance = tolerance;
  options.candidates.push_back(affine.factors(nominal));
  for (int i = 0; i < 15; ++i)
    options.candidates.push_back(affine.factors(of_regions(scene, random_soil(scene.regions, rng, damped))));
  watch = {};
  const SoilFamilyMade made = make_soil_family(scene, affine, *s.compiled(), options);
  int n_phi = 0;
  for (const bool p : made.family.reduced.fixed.is_phi) n_phi += p;
  std::cout << "family of " << made.points.size() << " points, R = " << made.family.reduced.fixed.size() - n_phi
            << " + " << n_phi << ", safety " << made.family.reduced.safety << ", " << watch.seconds()
            << " s; estimates";
  for (const double e : made.estimates) std::cout << " " << e;
  std::cout << "\n";
  std::vector<std::vector<double>> errors(4);
  std::vector<double> ratios, online, full, growths;
  for (int i = 0; i < n_before + n_truth; ++i) {
    const Factors factors = affine.factors(of_regions(scene, random_soil(scene.regions, rng, damped)));
    if (i < n_before) continue;
    if (only_poles) {
      growths.push_back(
          growth(reduced_to(0.2 * tolerance, scene, made.family.at(factors), all_alike(first_of_member))));
      continue;
    }
    watch = {};
    const CompiledScene whole = affine.at(factors);
    const Eigen::MatrixXd exact = held_of(scene, reduced_to(1e-4, scene, whole, all_alike(24)), whole);
    full.push_back(watch.seconds());
    watch = {};
    const CompiledScene small = made.family.at(factors);
    const Reduction answer = reduced_to(0.2 * tolerance, scene, small, all_alike(first_of_member));
    const Eigen::MatrixXd near = held_of(scene, answer, small);
    online.push_back(watch.seconds());
    growths.push_back(growth(answer));
    const Eigen::VectorXd far = difference(near, exact);
    for (std::size_t r = 0; r < errors.size(); ++r) errors[r].push_back(far[static_cast<Eigen::Index>(r)]);
    Scene member = scene;
    member.tolerance = 0.2 * tolerance;
    ratios.push_back(family_error(made.family, member, factors) / far.maxCoeff());
  }
  if (only_poles) {
    print("largest real part of a pole over the largest pole", growths);
    return 0;
  }
  const char* const names[] = {"error of F_T", "of x_G", "of the heel's moment", "of the toe's moment"};
  for (std::size_t r = 0; r < errors.size(); ++r) print(names[r], errors[r]);
  print("estimate over the largest of these errors", ratios);
  std::cout << "bounded: " << std::count_if(ratios.begin(), ratios.end(), [](double r) { return r >= 1.; }) << " of "
            << ratios.size() << "\n";
  print("largest real part of a pole over the largest pole", growths);
  print("seconds of a soil, all readings", online);
  print("seconds of its own reduction, all readings", full);
  return 0;
}

}  // namespace
}  // namespace upbead

int main(int argc, char** argv) {
  return upbead::main(argc, argv);
}
