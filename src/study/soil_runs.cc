#include "study/soil_runs.h"

#include <algorithm>
#include <map>
#include <set>

#include "case/case_run.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Soils that may become points of the basis: enough to see the corners of a box of a dozen keys.
constexpr std::size_t most_candidates = 24;
/// Share of the scenes' tolerance that the basis may take.
constexpr double share_of_tolerance = 0.6;

bool begins(const std::string& text, const std::string& with) {
  return text.compare(0, with.size(), with) == 0;
}

bool is_of_soil(const std::string& key) {
  return begins(key, "regions.") || key == "fluid.bulk_modulus";
}

/// Settings that change no System, but the course of loads and what is said of the answer.
bool is_of_waves(const std::string& key) {
  return begins(key, "loads.") || begins(key, "sliding.") || begins(key, "limits.") || key == "title";
}

/// The settings with one kind of key, as a text.
template <class Kind>
std::string settings_of(const StudyRun& run, const Kind& is_of_kind) {
  std::string text;
  for (const auto& [key, value] : run.settings)
    if (is_of_kind(key)) text += key + "=" + value + "\n";
  return text;
}

std::string soil_of(const StudyRun& run) {
  return settings_of(run, is_of_soil);
}

/// At most `most` of a list, evenly spaced.
std::vector<int> thinned(const std::vector<int>& list, std::size_t most) {
  if (list.size() <= most) return list;
  std::vector<int> few;
  for (std::size_t i = 0; i < most; ++i) few.push_back(list[i * list.size() / most]);
  return few;
}

Simulation with_all_cells_on(const Case& problem, const std::shared_ptr<const Mesh>& mesh) {
  return simulation_by(problem, mesh, [](Scene scene, const std::shared_ptr<const Mesh>& on) {
    return Simulation(with_all_cells(std::move(scene)), on);
  });
}

}  // namespace

std::vector<std::vector<int>> soil_groups(const Study& study) {
  if (study.share != StudyShare::soils) return {};
  std::map<std::string, std::vector<int>> of_rest;
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const StudyRun& run = study.runs[i];
    const std::string rest =
        settings_of(run, [](const std::string& key) { return !is_of_soil(key) && !is_of_waves(key); });
    of_rest[std::to_string(run.case_index) + "\n" + rest].push_back(static_cast<int>(i));
  }
  std::vector<std::vector<int>> groups;
  for (auto& entry : of_rest) {
    std::set<std::string> soils;
    for (const int i : entry.second) soils.insert(soil_of(study.runs[static_cast<std::size_t>(i)]));
    if (soils.size() >= least_soils) groups.push_back(std::move(entry.second));
  }
  return groups;
}

Case SoilRuns::case_of(int run) const {
  const StudyRun& of = study_.runs[static_cast<std::size_t>(run)];
  return read_case(study_.cases[static_cast<std::size_t>(of.case_index)], overrides_of(of));
}

/// Made of the study alone, whichever run comes first: so it is the same in every process.
void SoilRuns::make(int group, const std::shared_ptr<const Mesh>& mesh, const std::function<void()>& meanwhile) {
  const std::vector<int>& runs = groups_[static_cast<std::size_t>(group)];
  made_ = group;
  model_.reset();
  why_no_model_.clear();
  try {
    const Case problem = case_of(runs.front());
    const Simulation first = with_all_cells_on(problem, mesh);
    for (const Diagnostic& reason : why_no_soils(first)) {
      why_no_model_ = reason.place.key + ": " + reason.what;
      return;
    }
    std::vector<Scene> soils;
    for (const int i : thinned(runs, most_candidates)) soils.push_back(scene_on(case_of(i), *mesh));
    SoilModelOptions options;
    options.tolerance = share_of_tolerance * problem.scene.tolerance;
    options.progress = [&meanwhile](double) { meanwhile(); };
    model_ = std::make_unique<SoilModel>(first, soils, options);
  } catch (const InputError& error) {
    why_no_model_ = error.diagnostics().list().front().what;
  } catch (const NumericsError& error) {
    why_no_model_ = error.what();
  }
}

std::optional<Simulation> SoilRuns::member(int run, const Case& problem, const std::shared_ptr<const Mesh>& mesh,
                                           const std::function<void()>& meanwhile) {
  why_not_.clear();
  const auto found = std::find_if(groups_.begin(), groups_.end(), [run](const std::vector<int>& group) {
    return std::find(group.begin(), group.end(), run) != group.end();
  });
  if (found == groups_.end()) return std::nullopt;
  if (const int group = static_cast<int>(found - groups_.begin()); group != made_) make(group, mesh, meanwhile);
  if (!model_) {
    why_not_ = why_no_model_;
    return std::nullopt;
  }
  try {
    Simulation simulation = simulation_by(
        problem, mesh, [this](Scene scene, const std::shared_ptr<const Mesh>&) { return model_->member(scene); });
    if (error_of_soils(simulation) <= problem.scene.tolerance) return simulation;
    why_not_ = "the estimate of its error by one model of all soils exceeds the tolerance";
  } catch (const InputError& error) {
    why_not_ = error.diagnostics().list().front().what;
  }
  return std::nullopt;
}

}  // namespace upbead
