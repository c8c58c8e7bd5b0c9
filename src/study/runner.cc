#include "runner.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "base/interrupt.h"
#include "base/stopwatch.h"
#include "case/case_findings.h"
#include "case/case_run.h"
#include "case/case_schema.h"
#include "case/script_trust.h"
#include "run/derived.h"
#include "summary_reader.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Everything on which a mesh depends: the case with its mesh alone.
std::string mesh_key_of(const Case& problem) {
  CaseTables mesh_alone;
  mesh_alone.mesh = effective_tables(problem, ".").mesh;
  return case_schema().echo(mesh_alone);
}

/// Everything on which a solution depends: the whole case, without what is only told, see answer().
std::string solution_key_of(const Case& problem) {
  CaseTables tables = effective_tables(problem, ".");
  if (!needs_sliding(problem.scene)) tables.sliding_table.reset();
  Limits that_ask;  // for more to be solved
  that_ask.safety = tables.limits.safety;
  if (tables.limits.liquefaction) that_ask.liquefaction = 1.;
  tables.limits = that_ask;
  tables.title.clear();
  tables.report = {};
  return case_schema().echo(tables);
}

/// None where the model of all soils does not converge for this one.
std::optional<Solution> solved_as_member(const Case& problem, const Simulation& member, const RunOptions& options) {
  try {
    return in_places_of(problem, [&] { return upbead::solve(member, options); });
  } catch (const NumericsError&) {
    return std::nullopt;
  }
}

/// How wrong the pressure of an edge may be by the estimate of one model of all soils.
constexpr double tolerable_of_pressure = 0.05;
/// By how many times the estimate a margin must be below 1, so that the resultant is known to leave the base.
constexpr double surely_left = 2.;

bool is_of_edge(const std::string& read) {
  return read == "base.peak_heel_pressure" || read == "base.peak_toe_pressure";
}

/// Why a member's answer does not stand for the run's own; "" where it does. The distance of the resultant from an edge
/// is a difference of moments, holding minus overturning, of which the model has one within its estimate: with the
/// margin m = holding / overturning, it and the edge's pressure are wrong by estimate / |m - 1|.
/// Where the resultant leaves the base by more than that, the edge has no pressure, and the run would tell none either;
/// where neither edge has one, the margin does not tell which of them is sure.
std::string why_own(const Summary& summary, const RunResult& result, const std::vector<std::string>& reads) {
  const std::optional<double> margin = summary.base ? summary.base->least_overturning_margin : std::nullopt;
  const bool leaves = margin && 1. - *margin > surely_left * *result.error_estimate &&
                      (summary.base->peak_heel_pressure || summary.base->peak_toe_pressure);
  for (std::size_t i = 0; i < reads.size(); ++i)
    if (!result.values[i] && !(leaves && is_of_edge(reads[i])))
      return "one model of all soils does not tell every number that is read";
  if (margin && !leaves && *result.error_estimate > tolerable_of_pressure * std::abs(*margin - 1.))
    return "the resultant comes so near to an edge of the base that the edge's pressure may be wrong by more than 5 %";
  return "";
}

std::string in_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

std::shared_ptr<const Mesh> Runner::mesh_for(const Case& problem, Shared& shared) {
  if (!problem.scene.mesh.refine) return nullptr;  // such a mesh is made for the case by its tolerance
  const std::string key = mesh_key_of(problem);
  if (sharing_ && mesh_ && key == mesh_key_) {
    shared = Shared::mesh;
  } else {
    before_.reset();
    mesh_ = read_mesh(mesh_request(problem));
    mesh_key_ = key;
  }
  return mesh_;
}

Simulation Runner::simulation_for(int run, const Case& problem, bool as_member, Shared& shared) {
  in_places_of(problem, [&] { check_size(problem.scene); });  // before a mesh is read
  const std::shared_ptr<const Mesh> mesh = mesh_for(problem, shared);
  if (!sharing_ || !mesh) return simulation_of(problem, mesh);
  if (const auto member = as_member ? soils_.member(run, problem, mesh) : std::nullopt) {
    shared = Shared::soils;
    return *member;
  }
  return own_simulation(problem, shared);
}

Simulation Runner::own_simulation(const Case& problem, Shared& shared) {
  if (shared == Shared::soils) shared = Shared::mesh;
  const Simulation simulation = with_room(simulation_after(before_ ? &*before_ : nullptr, problem, mesh_));
  if (before_ && simulation.room() == before_->room()) shared = Shared::system;
  before_ = simulation;
  return simulation;
}

Summary Runner::solve(int run, const Case& problem, bool as_member, const std::function<void()>& meanwhile,
                      Shared& shared) {
  const std::string key = solution_key_of(problem);
  RunOptions options;
  options.progress = [&meanwhile](double) { meanwhile(); };
  const bool may_stay = solved_ && (as_member || !solved_->simulation->member());
  if (sharing_ && may_stay && key == solution_key_) {
    shared = Shared::solution;
  } else {
    solved_.reset();
    Simulation simulation = simulation_for(run, problem, as_member, shared);
    read_records(problem, simulation);  // their mistakes come before the work
    if (shared == Shared::soils) solved_ = solved_as_member(problem, simulation, options);
    if (shared == Shared::soils && !solved_) {
      soils_.refuse("the model of all soils does not converge for it");
      simulation = own_simulation(problem, shared);
    }
    if (!solved_) solved_ = in_places_of(problem, [&] { return upbead::solve(simulation, options); });
    solution_key_ = key;
    const bool of_its_basis = solved_->n_spared > 0 && solved_->simulation->room() == simulation.room();
    if (shared == Shared::system && of_its_basis) shared = Shared::basis;
  }
  return answer(problem, *solved_, options.progress).summary;
}

RunResult Runner::answer_of(int run, const Case& problem, const std::function<void()>& meanwhile) {
  RunResult result;
  for (const bool as_member : {true, false}) {
    const Summary summary = solve(run, problem, as_member, meanwhile, result.shared);
    result.error_estimate = summary.reduction ? summary.reduction->error_of_soils : std::nullopt;
    const Json json = summary_outputs().to_json(summary);
    result.summary = json_text(json);
    result.values = numbers_at(json, study_.reads);
    result.doubts = doubts_of(summary);
    if (!result.error_estimate) break;
    const std::string why = why_own(summary, result, study_.reads);
    if (why.empty()) break;
    soils_.refuse(why);
  }
  if (!result.error_estimate) result.why_own = soils_.why_not();
  result.done = true;
  return result;
}

RunResult Runner::run(int number, const std::function<void()>& meanwhile) {
  const StudyRun& run = study_.runs[static_cast<std::size_t>(number)];
  const Stopwatch watch;
  RunResult result;
  try {
    const Case problem = read_case(study_.cases[static_cast<std::size_t>(run.case_index)], overrides_of(run));
    require_trust(problem, trusts_scripts_);
    require_loads(problem);
    result = answer_of(number, problem, meanwhile);
  } catch (const Interrupted&) {
    throw;
  } catch (const std::bad_alloc&) {
    result.message = "it does not fit in memory";
  } catch (const InputError& error) {
    result.message = in_one_line(error.what());
  } catch (const NumericsError& error) {
    result.message = in_one_line(std::string("the numerics failed: ") + error.what());
  } catch (const std::exception& error) {
    result.message = in_one_line(std::string("this is a bug, please report it: ") + error.what());
  }
  result.seconds = watch.seconds();
  return result;
}

}  // namespace upbead
