#include "error_account.h"

#include <algorithm>
#include <cmath>

#include "../derived.h"
#include "fem/far_sides.h"
#include "finer.h"
#include "response/shear_response.h"
#include "response/spectrum.h"
#include "response/step_choice.h"
#include "shear_difference.h"
#include "slip_error.h"

namespace upbead {

namespace {

/// By name of a far side, the surfaces behind it.
using Sides = std::map<std::string, std::set<std::string>>;

/// The scene with all its far sides of one kind.
Scene with_far_sides(const Scene& given, const Sides& sides, const Boundary& kind) {
  Scene other = given;
  const auto is_water = [&](const std::string& name) { return given.regions.at(name).kind == RegionKind::water; };
  for (const auto& [side, surfaces] : sides) {
    Boundary& boundary = other.boundaries.at(side);
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

double error_of_far_sides(const Simulation& simulation, const ShearResponse& response) {
  const Scene& scene = simulation.given;
  const Sides sides = far_sides(*simulation.given_mesh);
  if (sides.empty()) return 0.;
  const double duration = step_of_loads(scene, 4).duration;
  const auto spectrum_of = [&](const Scene& other) {
    const Simulation coarse = on_mesh(other, simulation.given_mesh);
    return solve_spectrum(coarse.scene, *coarse.compiled, response.peak_shear_time);
  };
  const Spectrum given = spectrum_of(scene);
  const auto spectrum_with = [&](const Boundary& kind) {
    const Scene other = with_far_sides(scene, sides, kind);
    return same_boundaries(other, scene) ? given : spectrum_of(other);
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
ShearError error_of_steps(const Run& run) {
  constexpr double whole = 2.;
  const Simulation coarse = on_mesh(run.simulation->given, run.simulation->given_mesh);
  const System& system = coarse.compiled->system;
  SchemeOptions options;
  if (run.response.order == 2) options.kind = SchemeKind::generalised_alpha;
  options.account_energy = false;
  const TimeGrid grid =
      make_time_grid(kinks(system), coarse.given.time.end, run.summary.discretisation.time_step * (1. + 1e-9));
  const auto answer = [&](const TimeGrid& at) {
    return shear_history(*coarse.compiled, march(system, *make_scheme(system, options), at), true);
  };
  const ShearError moved = difference(answer(grid), answer(halved(grid)));
  return {whole * moved.peak, whole * moved.history};
}

/// Of cells; those of a mesh that was made for the tolerance are known, unless the soil has changed since.
ShearError error_of_mesh(const Simulation& simulation) {
  if (simulation.accuracy && !simulation.soil) return simulation.accuracy->levels.back().error;
  return error_of_cells(simulation, with_halved_cells(simulation));
}

bool has_slipped(const Run& run) {
  return run.summary.contact && run.summary.contact->solved;
}

}  // namespace

void estimate_errors(Run& run) {
  const Simulation& simulation = *run.simulation;
  if (!run.summary.response || !simulation.given.time.inertia ||
      (!simulation.accuracy && !simulation.given.accuracy.estimate)) {
    tell_why_no_slip_error(run);
    return;
  }
  ErrorEstimate& peak = run.summary.error.emplace();
  ErrorEstimate& history = run.summary.history_error.emplace();
  ShearError mesh, time;
  if (has_slipped(run)) {
    const ContactError contact = error_of_contact(run);
    mesh = contact.mesh;
    time = contact.time;
    run.summary.contact->solved->error_estimate = contact.slip;
  } else {
    mesh = error_of_mesh(simulation);
    if (!run.summary.reduction) time = error_of_steps(run);
  }
  peak.mesh = mesh.peak;
  history.mesh = mesh.history;
  peak.time = time.peak;
  history.time = time.history;
  if (run.summary.reduction) {
    peak.reduced_model = run.summary.reduction->error_peak;
    history.reduced_model = run.summary.reduction->error;
  }
  peak.far_boundary = error_of_far_sides(simulation, *run.summary.response);
  estimate_slip_error(run);
}

}  // namespace upbead
