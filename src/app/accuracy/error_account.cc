#include "error_account.h"

#include <algorithm>
#include <cmath>

#include "../compile_on.h"
#include "../solve.h"
#include "upbead/fem/far_sides.h"
#include "upbead/response/shear_response.h"
#include "upbead/response/spectrum.h"
#include "upbead/response/step_choice.h"

namespace upbead {

namespace {

/// By name of a far side, the surfaces behind it.
using Sides = std::map<std::string, std::set<std::string>>;

/// The case with all its far sides of one kind.
Case with_far_sides(const Case& input, const Sides& sides, const Boundary& kind) {
  Case other = input;
  const auto is_water = [&](const std::string& name) { return input.scene.regions.at(name).kind == RegionKind::water; };
  for (const auto& [side, surfaces] : sides) {
    Boundary& boundary = other.scene.boundaries.at(side);
    if (!std::all_of(surfaces.begin(), surfaces.end(), is_water)) boundary.displacement = kind.displacement;
    if (boundary.pressure) boundary.pressure = kind.pressure;
  }
  return other;
}

bool same_boundaries(const Scene& a, const Scene& b) {
  return std::equal(a.boundaries.begin(), a.boundaries.end(), b.boundaries.begin(), [](const auto& x, const auto& y) {
    return x.second.displacement == y.second.displacement && x.second.pressure == y.second.pressure;
  });
}

/// Largest |F_T| of a transform about a time (N/m).
double largest_shear(const Spectrum& spectrum, const std::vector<std::complex<double>>& shear, double time,
                     double duration) {
  double largest = 0.;
  for (int i = -2; i <= 2; ++i)
    largest = std::max(largest, std::abs(shear_at(spectrum.s, shear, time + 0.05 * i * duration)));
  return largest;
}

double error_of_far_sides(const Case& input, const std::shared_ptr<const Mesh>& coarse, const ShearResponse& response) {
  const Sides sides = far_sides(*coarse);
  if (sides.empty()) return 0.;
  const auto spectrum_of = [&](const Case& problem) {
    const CompiledCase scene = compile_on(problem, coarse);
    return solve_spectrum(scene.scene, scene.compiled);
  };
  const Spectrum given = spectrum_of(input);
  const auto spectrum_with = [&](const Boundary& kind) {
    const Case other = with_far_sides(input, sides, kind);
    return same_boundaries(other.scene, input.scene) ? given : spectrum_of(other);
  };
  const Spectrum held = spectrum_with({DisplacementCondition::roller, PressureCondition::sealed});
  const Spectrum free = spectrum_with({DisplacementCondition::free, PressureCondition::open});
  std::vector<std::complex<double>> difference;
  for (std::size_t j = 0; j < given.s.size(); ++j)
    difference.push_back(given.shear[j] - 0.5 * (held.shear[j] + free.shear[j]));
  const double duration = step_of_loads(input.scene, 4).duration;
  return largest_shear(given, difference, response.peak_shear_time, duration) / std::abs(response.peak_shear);
}

double error_of_steps(const Case& input, const std::shared_ptr<const Mesh>& coarse, const Run& run) {
  Case fine = input, wide = input;
  fine.scene.time.scheme = wide.scene.time.scheme =
      run.response.order == 4 ? TimeScheme::sdirk4 : TimeScheme::generalised_alpha;
  fine.scene.time.step = run.summary.discretisation.time_step;
  wide.scene.time.step = std::min(2. * *fine.scene.time.step, input.scene.time.end);
  fine.scene.fields_every = wide.scene.fields_every = {};
  const CompiledCase scene = compile_on(fine, coarse);
  const auto peak = [&](const Case& problem) {
    const SchemeChoice choice{problem.scene.time.scheme, "", {}};
    return run_march(problem, scene, choice, {}).summary.response->peak_shear;
  };
  const double of_fine = peak(fine), of_wide = peak(wide);
  return std::abs(of_fine - of_wide) / 3. / std::abs(of_fine);
}

}  // namespace

ErrorEstimate estimate_error(const Case& input, const CompiledCase& scene, const Run& run) {
  const std::shared_ptr<const Mesh> coarse = read_mesh(mesh_request(input));
  ErrorEstimate error;
  error.mesh = scene.accuracy->error.sum;
  if (run.summary.reduction)
    error.reduced_model = run.summary.reduction->error_peak;
  else
    error.time = error_of_steps(input, coarse, run);
  error.far_boundary = error_of_far_sides(input, coarse, *run.summary.response);
  return error;
}

}  // namespace upbead
