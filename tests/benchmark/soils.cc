// One reduced model for many soils, against runs of each soil: errors, estimates, times.
//
// usage: bench_soils CASE N_TRUTH POINTS TOLERANCE [KEY=VALUE]...
#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "base/stopwatch.h"
#include "case/case_run.h"
#include "fem/affine_scene.h"
#include "fem/caisson/reading_names.h"
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

ReductionTargets only_shear() {
  ReductionTargets targets;
  targets.only_shear = true;
  return targets;
}

int main(int argc, char** argv) {
  const PetscSession petsc;
  std::vector<std::string> overrides(argv + 5, argv + argc);
  overrides.push_back("mesh.full_domain=true");
  Case input = read_case(argv[1], overrides);
  const int n_truth = std::stoi(argv[2]), points = std::stoi(argv[3]);
  const double tolerance = std::stod(argv[4]);
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
  std::vector<double> errors, ratios, online;
  double full = 0.;
  std::map<double, std::vector<double>> per_share;
  for (int i = 0; i < n_truth; ++i) {
    const Regions soil = random_soil(scene.regions, rng, damped);
    const Factors factors = affine.factors(of_regions(scene, soil));
    watch = {};
    Scene fine = scene;
    fine.tolerance = 1e-4;
    const CompiledScene whole = affine.at(factors);
    const Reduction truth = reduce_scene(fine, whole, only_shear());
    full += watch.seconds();
    const SampledLoads loads = sampled_loads(scene, whole.system);
    const int F = whole.system.reading(reading::shear_force);
    const Eigen::RowVectorXd exact = respond(truth.model, loads).reading.row(F);
    watch = {};
    Scene m = scene;
    m.tolerance = 0.2 * tolerance;
    const CompiledScene small = made.family.at(factors);
    const Reduction member = reduce_scene(m, small, only_shear());
    const Eigen::RowVectorXd near = respond(member.model, loads).reading.row(F);
    online.push_back(watch.seconds());
    errors.push_back((near - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff());
    for (const double share : {nested_share}) {
      const CompiledScene smaller = made.family.at(factors, share);
      const Eigen::RowVectorXd less = respond(reduce_scene(m, smaller, only_shear()).model, loads).reading.row(F);
      per_share[share].push_back((near - less).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff() / errors.back());
    }
    ratios.push_back(made.family.reduced.safety * per_share[nested_share].back());
  }
  for (auto& [share, list] : per_share) {
    std::sort(list.begin(), list.end());
    std::cout << "share " << share << ": nested difference over error, least " << list.front() << ", 5 % "
              << list[list.size() / 20] << ", median " << list[list.size() / 2] << "\n";
  }
  std::sort(errors.begin(), errors.end());
  std::sort(ratios.begin(), ratios.end());
  std::sort(online.begin(), online.end());
  const auto at = [n_truth](double p) { return static_cast<std::size_t>(p * (n_truth - 1)); };
  std::cout << "errors median " << errors[at(0.5)] << ", 95 % " << errors[at(0.95)] << ", largest " << errors.back()
            << "; estimate over error: least " << ratios[0] << ", 5 % " << ratios[at(0.05)] << ", median "
            << ratios[at(0.5)] << "; a soil " << online[at(0.5)] << " s, in full " << full / n_truth << " s\n";
  return 0;
}

}  // namespace
}  // namespace upbead

int main(int argc, char** argv) {
  return upbead::main(argc, argv);
}
