#include "runner.h"

#include <algorithm>
#include <new>

#include "base/interrupt.h"
#include "base/stopwatch.h"
#include "case/case_run.h"
#include "case/script_trust.h"
#include "run/sliding/case_sliding.h"
#include "run/sliding/coupled_sliding.h"
#include "summary_reader.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

std::string key_of(const MeshRequest& request) {
  std::string key = request.file + "\n" + std::to_string(request.refine);
  for (const auto& [name, value] : request.parameters) key += "\n" + name + "=" + to_toml(value);
  return key;
}

/// Everything on which a solution depends: the whole case without its sliding.
std::string solution_key_of(const Case& problem) {
  Case without = problem;
  if (!has_frictional_contact(problem.scene)) without.scene.sliding.reset();
  return effective_case(without, ".");
}

std::string in_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

std::shared_ptr<const Mesh> Runner::mesh_for(const Case& problem, Shared& shared) {
  if (!problem.scene.mesh.refine) return nullptr;  // such a mesh is made for the case by its tolerance
  const MeshRequest request = mesh_request(problem);
  const std::string key = key_of(request);
  if (sharing_ && mesh_ && key == mesh_key_) {
    shared = Shared::mesh;
  } else {
    mesh_ = read_mesh(request);
    mesh_key_ = key;
  }
  return mesh_;
}

std::string Runner::solve(const Case& problem, const std::function<void()>& meanwhile, Shared& shared) {
  const std::string key = solution_key_of(problem);
  RunOptions options;
  options.progress = [&meanwhile](double) { meanwhile(); };
  if (sharing_ && solution_.simulation && key == solution_key_) {
    shared = Shared::solution;
    Scene given = solution_.simulation->given;  // with the shapes of its loads by waves
    given.sliding = problem.scene.sliding;
    return to_json(in_places_of(problem, [&] { return with_sliding(solution_, given, options.progress); }).summary);
  }
  solution_ = {};
  in_places_of(problem, [&] { check_size(problem.scene); });  // before a mesh is read
  const Simulation simulation = simulation_of(problem, mesh_for(problem, shared));
  solution_ = upbead::solve(problem, simulation, read_records(problem, simulation), options);
  solution_key_ = key;
  return to_json(solution_.summary);
}

RunResult Runner::run(const StudyRun& run, const std::function<void()>& meanwhile) {
  const Stopwatch watch;
  RunResult result;
  try {
    const Case problem = read_case(study_.cases[static_cast<std::size_t>(run.case_index)], overrides_of(run));
    require_trust(problem, trusts_scripts_);
    require_loads(problem);
    const std::string summary = solve(problem, meanwhile, result.shared);
    result.values = numbers_at(summary, study_.reads);
    result.doubts = doubts_of(summary);
    result.done = true;
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
