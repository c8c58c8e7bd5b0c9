#include "judge.h"

#include <algorithm>
#include <cmath>

#include "algebra/factorisation.h"
#include "case/case_findings.h"
#include "equilibrated.h"
#include "fem/compile.h"
#include "upbead/base/error.h"
#include "upbead/case/case_run.h"

namespace upbead::test {

namespace {

/// E = M + c C + k K, as the scheme solves with it for steps of h.
struct Coefficients {
  double c, k;
  /// sdirk4: gamma = 1/4. generalised-alpha with rho = 0.9: see AlphaCoefficients.
  Coefficients(SchemeKind kind, double h) : c(0.25 * h), k(c * c) {
    if (kind == SchemeKind::sdirk4) return;
    const double rho = 0.9, alpha_m = (2. * rho - 1.) / (rho + 1.), alpha_f = rho / (rho + 1.);
    const double gamma = 0.5 - alpha_m + alpha_f, beta = 0.25 * std::pow(1. - alpha_m + alpha_f, 2);
    c = (1. - alpha_f) * h * gamma / (1. - alpha_m);
    k = (1. - alpha_f) * h * h * beta / (1. - alpha_m);
  }
};

double peak_of(const SystemLoad& load, double end) {
  return std::max(extremum(load.history, 0., end, 1).value, -extremum(load.history, 0., end, -1).value);
}

/// All loads at their largest, as the right-hand side of the free unknowns.
Vector right_hand_side(const System& system, const SparseMatrix& E, double end) {
  Vector rhs = Vector::Zero(system.size()), given = Vector::Zero(system.size());
  for (const SystemLoad& load : system.loads) {
    const double peak = peak_of(load, end);
    rhs += peak * load.vector;
    if (load.prescribed >= 0) given[load.prescribed] = peak;
  }
  return (rhs - E * given).head(system.n_free());
}

void measure_solve(const System& system, SchemeKind kind, double h, double end, Measures& m) {
  const Coefficients at(kind, h);
  const int n = system.n_free();
  const SparseMatrix E = system.M + at.c * system.C + at.k * system.K;
  const SparseMatrix free_rows = E.topRows(n), A = free_rows.leftCols(n);
  const Factorisation factors(A, system.blocks);
  m.negative = factors.inertia().negative;
  m.expected = static_cast<int>(std::count(system.field.begin(), system.field.begin() + n, Field::pressure_impulse));
  const Vector b = right_hand_side(system, E, end);
  if (b.norm() == 0.) return;
  const SolveError error = solve_error(A, factors.solve(b), b);
  m.residual = error.residual;
  m.plain_residual = error.plain;
}

/// A lower bound of the static work of the loads, each alone: 1/2 sum of (peak b_i)^2 / K_ii over displacements; for
/// a prescribed pressure b is its force on the skeleton.
double possible_work(const System& system, double end) {
  double work = 0.;
  for (const SystemLoad& load : system.loads)
    for (int i = 0; i < system.n_free(); ++i) {
      const double push = load.prescribed < 0 ? load.vector[i] : system.C.coeff(i, load.prescribed);
      const double stiffness = std::abs(system.K.coeff(i, i));
      if (system.field[i] == Field::displacement && stiffness > 0.)
        work += 0.5 * std::pow(peak_of(load, end) * push, 2) / stiffness;
    }
  return work;
}

/// The time from which on all loads are zero; `end` if there is none before.
double end_of_loads(const System& system, double end) {
  double over = 0.;
  for (const SystemLoad& load : system.loads) {
    const auto& corners = load.history.kinks();
    const double last = corners.empty() ? 0. : corners.back();
    over = std::max(over, load.history(last + end) == 0. && load.history(last + 0.3 * end) == 0. ? last : end);
  }
  return std::min(over, end);
}

/// Share of the possible work of the loads below which energies are round-off.
constexpr double possible_share = 1e-10;

/// Stored energy 400 steps after the end.
double stored_later(const System& system, double end, double h) {
  constexpr int more = 400;
  SchemeOptions options;
  options.kind = SchemeKind::generalised_alpha;
  const auto scheme = make_scheme(system, options);
  TimeGrid grid = make_time_grid(kinks(system), end, h);
  grid.end = end + more * h;
  grid.segments.push_back({end, h, more});
  return march(system, *scheme, grid).energy.back().stored();
}

/// `scale`: the energy that the balance is relative to.
void measure_growth(const System& system, const Response& response, double h, double scale, Measures& m) {
  const std::vector<double>& time = response.ends.time;
  const double over = end_of_loads(system, time.back());
  double before = 0.;
  for (std::size_t i = 1; i < time.size(); ++i) {
    const EnergyAccount& energy = response.energy[i];
    m.noise = std::max(m.noise, energy.mismatch() * energy.largest_work / scale);
    if (time[i - 1] < over * (1. - 1e-9)) {
      before = std::max(before, energy.stored());
      continue;
    }
    m.loads_end = true;
    m.growth = std::max(m.growth, (energy.stored() - response.energy[i - 1].stored()) / scale);
  }
  if (m.loads_end && m.scheme == "generalised_alpha")
    m.kept = stored_later(system, time.back(), h) / std::max(before, scale - response.energy.back().largest_work);
}

void measure_energy(const System& system, const Response& response, double h, Measures& m) {
  if (response.energy.empty()) return;
  const EnergyAccount& last = response.energy.back();
  const double possible = possible_share * possible_work(system, response.ends.time.back());
  const double scale = last.largest_work + possible;
  if (scale == 0.) return;
  m.energy = last.mismatch() * last.largest_work / scale;
  m.only_round_off = last.mismatch() * last.largest_work <= possible;
  measure_growth(system, response, h, scale, m);
}

bool is_finite(const Run& run) {
  const Response& r = run.response;
  const auto all = [](const Vector& v) { return v.array().isFinite().all(); };
  to_json(run.summary);  // throws if a number is not finite
  return r.ends.reading.array().isFinite().all() && r.balanced.reading.array().isFinite().all() &&
         all(r.final_state.x) && all(r.final_state.v) && all(r.final_state.a);
}

void measure(const Case& input, const Simulation& simulation, Measures& m) {
  const Run run = solve(input, simulation);
  const System& system = run.simulation->system();
  const double end = input.scene.time.end, h = run.summary.discretisation.time_step;
  m.scheme = run.summary.discretisation.scheme;
  m.unknowns = system.n_free();
  m.steps = run.summary.discretisation.steps;
  m.finite = is_finite(run);
  m.told_loose = std::any_of(run.summary.warnings.begin(), run.summary.warnings.end(),
                             [](const NumberedWarning& warning) { return warning.name == "balance_loose"; });
  measure_energy(system, run.response, h, m);
  if (run.summary.response) m.reaction = run.summary.response->reaction_mismatch;
  const SchemeKind kind = m.scheme == "generalised_alpha" ? SchemeKind::generalised_alpha : SchemeKind::sdirk4;
  measure_solve(system, kind, h, end, m);
  if (m.scheme != "reduced") m.halving = halve(system, kind, end, h, 12);
}

std::string failures(const Measures& m) {
  std::string text;
  const auto ask = [&text](bool holds, const std::string& name) {
    if (!holds) text += (text.empty() ? "" : " ") + name;
  };
  ask(m.finite, "finite");
  ask(m.energy <= (m.told_loose ? Bounds::told : Bounds::energy) || (m.told_loose && m.only_round_off), "energy");
  const bool alpha = m.scheme == "generalised_alpha";
  ask(alpha || m.growth <= Bounds::growth + 2. * m.noise, "growth");
  ask(m.kept <= Bounds::kept, "kept");
  ask(m.reaction <= (m.told_loose ? Bounds::told : Bounds::reaction), "reaction");
  ask(m.negative == m.expected, "inertia");
  ask(m.residual <= Bounds::residual, "residual");
  ask(m.scheme == "reduced" || m.halving.closer, "halving");
  return text;
}

}  // namespace

Verdict judge(const std::string& path) {
  Verdict verdict;
  try {
    const Case input = read_case(path);
    require_loads(input);
    const Simulation scene = simulation_of(input);
    measure(input, scene, verdict.measures);
    verdict.why = failures(verdict.measures);
    if (!verdict.why.empty()) verdict.kind = Verdict::Kind::failed;
  } catch (const InputError& error) {
    verdict = {Verdict::Kind::contradictory, error.diagnostics().list().front().what, {}};
  } catch (const NumericsError& error) {
    verdict = {Verdict::Kind::refused, error.what(), {}};
  }
  return verdict;
}

}  // namespace upbead::test
