#include "error_account.h"

#include <algorithm>
#include <cmath>

#include "../compile_on.h"
#include "finer.h"
#include "shear_difference.h"
#include "slip_error.h"
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
  const double duration = step_of_loads(input.scene, 4).duration;
  const auto spectrum_of = [&](const Case& problem) {
    const CompiledCase scene = compile_on(problem, coarse);
    return solve_spectrum(scene.scene, scene.compiled, response.peak_shear_time);
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
  return largest_shear(given, difference, response.peak_shear_time, duration) / std::abs(response.peak_shear);
}

/// The grid with every step halved.
TimeGrid halved(TimeGrid grid) {
  for (TimeSegment& segment : grid.segments) {
    segment.step *= 0.5;
    segment.n_steps *= 2;
  }
  return grid;
}

/// Of a march of order 2 or 4, by steps half as long on the coarse mesh: where loads have corners that steps do not
/// resolve, or stiff waves lower the order, they take away half of the error at least.
ShearError error_of_steps(const Case& input, const std::shared_ptr<const Mesh>& coarse, const Run& run) {
  constexpr double whole = 2.;
  const CompiledCase scene = compile_on(input, coarse);
  const System& system = scene.compiled.system;
  SchemeOptions options;
  if (run.response.order == 2) options.kind = SchemeKind::generalised_alpha;
  options.account_energy = false;
  const TimeGrid grid =
      make_time_grid(kinks(system), input.scene.time.end, run.summary.discretisation.time_step * (1. + 1e-9));
  const auto answer = [&](const TimeGrid& at) {
    return shear_history(scene.compiled, march(system, *make_scheme(system, options), at), true);
  };
  const ShearError moved = difference(answer(grid), answer(halved(grid)));
  return {whole * moved.peak, whole * moved.history};
}

/// Of cells; those of a mesh that was made for the tolerance are known, unless the soil has changed since.
ShearError error_of_mesh(const Case& input, const CompiledCase& scene) {
  if (scene.accuracy && !scene.soil) return scene.accuracy->levels.back().error;
  return error_of_cells(input, scene, compile_finer(input, scene));
}

bool has_slipped(const Run& run) {
  return run.summary.contact && run.summary.contact->solved;
}

}  // namespace

void estimate_errors(const Case& input, const CompiledCase& scene, Run& run) {
  if (!run.summary.response || !input.scene.time.inertia || (!scene.accuracy && !input.accuracy.estimate)) {
    tell_why_no_slip_error(input, run);
    return;
  }
  ErrorEstimate& peak = run.summary.error.emplace();
  ErrorEstimate& history = run.summary.history_error.emplace();
  const std::shared_ptr<const Mesh> coarse = read_mesh(mesh_request(input));
  ShearError mesh, time;
  if (has_slipped(run)) {
    const ContactError contact = error_of_contact(input, scene, run);
    mesh = contact.mesh;
    time = contact.time;
    run.summary.contact->solved->error_estimate = contact.slip;
  } else {
    mesh = error_of_mesh(input, scene);
    if (!run.summary.reduction) time = error_of_steps(input, coarse, run);
  }
  peak.mesh = mesh.peak;
  history.mesh = mesh.history;
  peak.time = time.peak;
  history.time = time.history;
  if (run.summary.reduction) {
    peak.reduced_model = run.summary.reduction->error_peak;
    history.reduced_model = run.summary.reduction->error;
  }
  peak.far_boundary = error_of_far_sides(input, coarse, *run.summary.response);
  estimate_slip_error(input, scene, run);
}

}  // namespace upbead
